// Scripts that let shells complete the commands, options and names of `mwt`, made from what commands declare.
#pragma once

#include <span>
#include <string>

#include "harness/cli/command_line.h"

namespace mwt {

/// For bash, with or without the package bash-completion.
[[nodiscard]] std::string bash_completion(std::span<const Command> commands);

/// For zsh: a file to be called _mwt in a folder of $fpath.
[[nodiscard]] std::string zsh_completion(std::span<const Command> commands);

}  // namespace mwt
