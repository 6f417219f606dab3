#include "harness/cli/verify_program.h"

#include <fmt/core.h>

#include <cstdio>
#include <memory>

#include "base/error.h"
#include "harness/io/points/point_file.h"
#include "verifier/refused.h"
#include "verifier/verify.h"

namespace mwt {

namespace {

struct VerifyArguments {
  std::string points;
  std::string proof;
};

// A verdict that nobody can read is none.
void print_verdict(const std::string& text) {
  const bool is_written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  if (!is_written) throw InputError("standard output cannot be written (disk full or pipe closed)");
}

int verify(const VerifyArguments& options) {
  try {
    const verifier::Verdict verdict = verifier::verify(read_points(options.points), options.proof);
    print_verdict(
        fmt::format("VERIFIED weight in [{:.17g}, {:.17g}], {}\n"
                    "{} points, {} candidates, {} removed, {} certain, {} regions\n",
                    verdict.lower, verdict.upper, verdict.is_optimal ? "optimal" : "bounded", verdict.points,
                    verdict.candidates, verdict.removed, verdict.certain, verdict.regions));
    return kExitOk;
  } catch (const verifier::Refused& refused) {
    print_verdict(fmt::format("REFUSED {}\n", refused.what()));
    return kExitNegative;
  }
}

}  // namespace

Command verify_program() {
  const auto options = std::make_shared<VerifyArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("points", options->points, kFile, "point file; - for stdin");
    declared.argument("proof", options->proof, kFile, "proof of the optimum, written by mwt solve --proof");
  };
  return {"mwt_verify", "Check a proof that a triangulation has minimum weight, without any code of the solvers",
          declare, [options] { return verify(*options); }};
}

}  // namespace mwt
