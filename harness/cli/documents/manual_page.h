// Manual pages, made from what commands declare, as --help is: roff source with the macros of man(7).
#pragma once

#include <span>
#include <string>

#include "harness/cli/command_line.h"

namespace mwt {

/// The page of a program with commands; `name_line` says in a few words what the program is.
[[nodiscard]] std::string manual_page(const std::string& program, const std::string& name_line,
                                      std::span<const Command> commands);

/// The page of a program that is one command.
[[nodiscard]] std::string manual_page(const Command& program);

}  // namespace mwt
