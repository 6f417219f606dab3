// How the programs end.
#pragma once

namespace mwt {

/// How a run of the program ends; scripts rely on these.
enum ExitCode : int {
  kExitOk = 0,
  kExitNegative = 1,     ///< an invalid triangulation, a regression, or a study with failed runs
  kExitUserMistake = 2,  ///< one line on standard error states the mistake and the remedy
  kExitFailure = 3,      ///< a fault of this program: an algorithm's invalid output, an unexpected exception
  kExitInterrupted = 130,
};

}  // namespace mwt
