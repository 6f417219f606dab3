// mwt_verify POINTS PROOF: checks a proof of optimality. Exit 0: verified, 1: not, 2: unusable input, 3: internal.
#include <cstdio>
#include <exception>
#include <new>

#include "base/error.h"
#include "harness/io/points/point_file.h"
#include "harness/io/standard_streams.h"
#include "verifier/refused.h"
#include "verifier/verify.h"

namespace {

// A verdict that nobody can read is none.
int flushed(int exit_code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
  std::fprintf(stderr, "mwt_verify: standard output cannot be written (disk full or pipe closed)\n");
  return 2;
}

}  // namespace

int main(int argument_count, char** arguments) {
  mwt::open_closed_standard_streams();
  if (argument_count != 3) {
    std::fprintf(stderr, "usage: mwt_verify POINTS PROOF\n");
    return 2;
  }
  try {
    const mwt::verifier::Verdict verdict = mwt::verifier::verify(mwt::read_points(arguments[1]), arguments[2]);
    std::printf("VERIFIED weight in [%.17g, %.17g], %s\n", verdict.lower, verdict.upper,
                verdict.is_optimal ? "optimal" : "bounded");
    std::printf("%zu points, %zu candidates, %zu removed, %zu certain, %zu regions\n", verdict.points,
                verdict.candidates, verdict.removed, verdict.certain, verdict.regions);
    return flushed(0);
  } catch (const mwt::verifier::Refused& refused) {
    std::printf("REFUSED %s\n", refused.what());
    return flushed(1);
  } catch (const mwt::InputError& error) {
    std::fprintf(stderr, "mwt_verify: %s\n", error.what());
    return 2;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "mwt_verify: out of memory\n");
    return 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mwt_verify: internal failure: %s\n", error.what());
    return 3;
  }
}
