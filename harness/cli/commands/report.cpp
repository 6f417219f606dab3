#include "harness/report/report.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/io/output_file.h"

namespace mwt {

namespace {

struct ReportArguments {
  std::string folder;
  std::optional<std::string> tables;
};

// The tables must not take the place of what they are made of, or of what is written beside them.
void require_usable_output(const ReportArguments& options) {
  if (!options.tables) return;
  std::vector<std::string> files;
  for (const char* name : {"runs.csv", "instances.csv", "environments.csv", "study.toml", "summary.csv",
                           "exponents.csv", "claims.csv", "claim_rows.csv"}) {
    files.push_back((std::filesystem::path(options.folder) / name).string());
  }
  const OutputOption output{"--tables", *options.tables};
  require_usable_outputs({&output, 1}, files);
}

int report(const ReportArguments& options) {
  require_usable_output(options);
  const ReportData data = read_report_data(options.folder);
  for (const std::string& warning : data.records.warnings) std::cerr << "mwt: warning: " << warning << '\n';
  std::ostringstream tables;
  for (const ReportPart& part : report_tables()) part(data, tables);
  write_file_atomically(options.tables.value_or("-"), tables.str());
  const bool is_file = options.tables && !is_standard_output(*options.tables);
  if (is_file) std::cout << "written: " << *options.tables << '\n';
  for (const ReportPart& part : report_results()) part(data, std::cout);
  return kExitOk;
}

}  // namespace

Command report_command() {
  const auto options = std::make_shared<ReportArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("folder", options->folder, kFolder, "results folder of a study (mwt run)");
    declared.option("--tables", options->tables, kFile,
                    "write the tables to this file instead of printing them (often thousands of lines)");
  };
  return {"report", "Print tables of time, alpha and growth from the records of a study, and write them as CSV",
          declare, [options] { return report(*options); }};
}

}  // namespace mwt
