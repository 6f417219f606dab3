#include "harness/archive/benchmark_set.h"

#include <iostream>
#include <memory>

#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/io/output_file.h"
#include "harness/run/catalogue.h"

namespace mwt {

namespace {

struct ArchiveArguments {
  std::string folder;
  std::string output;
};

int archive(const ArchiveArguments& options) {
  require_fitting_ending(options.output, {".tar.zst"},
                         "a benchmark set is written as a tar archive compressed by zstd");
  const OutputOption output{"--output", options.output};
  require_usable_outputs({&output, 1}, {});
  const BenchmarkSet set = benchmark_set_of(options.folder, Catalogue::built_in());
  for (const std::string& warning : set.warnings) std::cerr << "mwt: warning: " << warning << '\n';
  write_file_atomically(options.output, packed(set));
  if (!is_standard_output(options.output)) {
    std::cout << "written: " << options.output << ": " << set.instances << " instances, " << set.proved
              << " proved optima, " << set.proofs << " proofs\n";
  }
  return kExitOk;
}

}  // namespace

Command archive_command() {
  const auto options = std::make_shared<ArchiveArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("folder", options->folder, kFolder, "results folder of a study (mwt run)");
    declared.required("-o,--output", options->output, kFile, "file for the set: .tar.zst");
  };
  return {"archive", "Pack the instances of a study, their certified optima and proofs as a benchmark set", declare,
          [options] { return archive(*options); }};
}

}  // namespace mwt
