// How the programs end.
#pragma once

namespace mwt {

/// How a run of the program ends; scripts rely on these.
enum ExitCode : int {
  kExitOk = 0,
  kExitNegative = 1,     ///< the answer is no: an invalid triangulation, a regression, a study with runs that failed
  kExitUserMistake = 2,  ///< one line on standard error says what and how to mend it
  kExitFailure = 3,      ///< of this program: an algorithm's invalid output, an exception nobody expected
  kExitInterrupted = 130,
};

}  // namespace mwt
