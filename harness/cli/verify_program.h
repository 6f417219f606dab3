// The program mwt_verify, as a command: its manual page is made like that of mwt.
#pragma once

#include "harness/cli/command_line.h"

namespace mwt {

/// mwt_verify POINTS PROOF. Exit 0: verified, 1: not, 2: unusable input, 3: internal.
[[nodiscard]] Command verify_program();

}  // namespace mwt
