#include <iostream>
#include <memory>

#include "base/error.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/documents/shell_completion.h"

namespace mwt {

namespace {

struct CompletionArguments {
  std::string shell;
};

int print_completion(const CompletionArguments& options, std::span<const Command> commands) {
  if (options.shell == "bash") {
    std::cout << bash_completion(commands);
  } else if (options.shell == "zsh") {
    std::cout << zsh_completion(commands);
  } else {
    throw InputError("no completion for the shell '" + options.shell + "'; known: bash, zsh");
  }
  return kExitOk;
}

}  // namespace

Command completion_command(const std::vector<Command>& commands) {
  const auto options = std::make_shared<CompletionArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("shell", options->shell, one_of("SHELL", {"bash", "zsh"}), "bash or zsh");
  };
  return {"completion", "Print a script that lets a shell complete commands, options and names", declare,
          [options, &commands] { return print_completion(*options, commands); }};
}

}  // namespace mwt
