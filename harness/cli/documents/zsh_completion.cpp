#include <fmt/core.h>

#include "harness/cli/documents/shell_completion.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

// Text inside single quotes, and inside the brackets and between the colons of a specification of _arguments.
std::string zsh_escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (letter == '\'') {
      safe += "'\\''";
      continue;
    }
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') safe += '\\';
    safe += letter;
  }
  return safe;
}

std::string action_of(const ValueKind& kind) {
  if (kind.word == kFile.word) return "_files";
  if (kind.word == kFolder.word) return "_files -/";
  if (!kind.choices) return " ";
  const std::string words = joined(kind.choices(), " ");
  // Studies are files, too.
  return kind.word == study_kind().word ? "{compadd " + words + "; _files -g \"*.toml\"}" : "(" + words + ")";
}

std::string value_of(const ValueKind& kind) { return fmt::format(":{}:{}", zsh_escaped(kind.word), action_of(kind)); }

std::string argument_of(const DeclaredOption& argument, int place) {
  const std::string where = argument.repeats ? "*" : std::to_string(place);
  return fmt::format("'{}:{}:{}'", where, zsh_escaped(argument.names), action_of(argument.value));
}

std::string option_of(const DeclaredOption& option) {
  const std::vector<std::string> names = split(option.names, ',');
  const std::string rest =
      fmt::format("[{}]{}", zsh_escaped(option.help), option.is_flag() ? "" : value_of(option.value));
  if (option.repeats) return fmt::format("'*{}{}'", option.names, rest);
  return names.size() == 1 ? fmt::format("'{}{}'", option.names, rest)
                           : fmt::format("'({})'{{{}}}'{}'", joined(names, " "), option.names, rest);
}

std::string case_of(const Command& command) {
  std::string text =
      fmt::format("        {})\n          _arguments '--help[print the options and exit]'", command.name);
  int place = 0;
  for (const DeclaredOption& option : declared_options(command))
    text += " \\\n            " + (option.is_argument() ? argument_of(option, ++place) : option_of(option));
  return text + "\n          ;;\n";
}

}  // namespace

std::string zsh_completion(std::span<const Command> commands) {
  std::string names;
  std::string cases;
  for (const Command& command : commands) {
    names += fmt::format("        '{}:{}'\n", command.name, zsh_escaped(command.summary));
    cases += case_of(command);
  }
  return fmt::format(R"sh(#compdef mwt mwt_verify
# Completion of mwt for zsh, made by: mwt completion zsh
_mwt() {{
  local context state line
  typeset -A opt_args
  if [[ $service == mwt_verify ]]; then
    _arguments '--help' '--version' '1:points:_files' '2:proof:_files'
    return
  fi
  _arguments -C '--help[print the commands and exit]' '--version[print the version and exit]' '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      local -a commands=(
{})
      _describe -t commands 'command' commands
      ;;
    argument)
      case $words[1] in
{}      esac
      ;;
  esac
}}
_mwt "$@"
)sh",
                     names, cases);
}

}  // namespace mwt
