#include <fmt/core.h>

#include <map>

#include "harness/cli/documents/shell_completion.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

// The part that is the same whatever the commands are. _mwt_kind COMMAND KEY prints what KEY's value is, where KEY is
// an option or the place of an argument; _mwt_options COMMAND and _mwt_words KIND print lists.
constexpr const char* kBashEngine = R"sh(
_mwt() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command= place=1 kind= i
  COMPREPLY=()
  [[ $previous == '=' ]] && previous=${COMP_WORDS[COMP_CWORD-2]}
  [[ $current == '=' ]] && current=
  for ((i = 1; i < COMP_CWORD; i++)); do
    if [[ ${COMP_WORDS[i]} == -?* ]]; then
      if [[ -n $(_mwt_kind "$command" "${COMP_WORDS[i]}") ]]; then
        ((i++))
        [[ ${COMP_WORDS[i]} == '=' ]] && ((i++))
      fi
    elif [[ -z $command ]]; then
      command=${COMP_WORDS[i]}
    else
      ((place++))
    fi
  done
  if [[ $previous == -?* ]]; then
    kind=$(_mwt_kind "$command" "$previous")
  fi
  if [[ -z $kind && $current == -* ]]; then
    COMPREPLY=($(compgen -W "$(_mwt_options "$command")" -- "$current"))
    return
  fi
  if [[ -z $kind && -z $command ]]; then
    COMPREPLY=($(compgen -W "$(_mwt_commands)" -- "$current"))
    return
  fi
  [[ -z $kind ]] && kind=$(_mwt_kind "$command" "$place")
  COMPREPLY=($(compgen -W "$(_mwt_words "$kind")" -- "$current"))
  case $kind in
    FILE | STUDY)
      compopt -o filenames 2>/dev/null
      COMPREPLY+=($(compgen -f -- "$current"))
      ;;
    FOLDER)
      compopt -o filenames 2>/dev/null
      COMPREPLY+=($(compgen -d -- "$current"))
      ;;
  esac
}
complete -F _mwt mwt
complete -o default -W '--help --version' mwt_verify
)sh";

std::string pattern_of(const std::string& command, const DeclaredOption& option, int place) {
  if (option.is_argument())
    return option.repeats ? fmt::format("'{} '[0-9]*", command) : fmt::format("'{} {}'", command, place);
  std::string pattern;
  for (const std::string& name : split(option.names, ','))
    pattern += (pattern.empty() ? "" : " | ") + fmt::format("'{} {}'", command, name);
  return pattern;
}

std::string options_line(const Command& command, const std::vector<DeclaredOption>& options) {
  std::vector<std::string> names = {"--help"};
  for (const DeclaredOption& option : options) {
    if (option.is_argument()) continue;
    const std::vector<std::string> all = split(option.names, ',');
    names.insert(names.end(), all.begin(), all.end());
  }
  return fmt::format("    {}) echo '{}' ;;\n", command.name, joined(names, " "));
}

// One case of _mwt_kind per value.
std::string kind_lines(const Command& command, const std::vector<DeclaredOption>& options) {
  std::string lines;
  int place = 0;
  for (const DeclaredOption& option : options) {
    if (option.is_argument()) ++place;
    if (!option.is_flag())
      lines += fmt::format("    {}) echo '{}' ;;\n", pattern_of(command.name, option, place), option.value.word);
  }
  return lines;
}

}  // namespace

std::string bash_completion(std::span<const Command> commands) {
  std::string options_of;
  std::string kind_of;
  std::vector<std::string> names;
  std::map<std::string, std::string> words;
  for (const Command& command : commands) {
    const std::vector<DeclaredOption> options = declared_options(command);
    names.push_back(command.name);
    options_of += options_line(command, options);
    kind_of += kind_lines(command, options);
    for (const DeclaredOption& option : options) {
      if (option.value.choices) words[option.value.word] = joined(option.value.choices(), " ");
    }
  }
  std::string words_of;
  for (const auto& [kind, list] : words) words_of += fmt::format("    {}) echo '{}' ;;\n", kind, list);
  return fmt::format(
             "# Completion of mwt for bash, made by: mwt completion bash\n"
             "_mwt_commands() {{\n  echo '{}'\n}}\n"
             "_mwt_options() {{\n  case $1 in\n    '') echo '--help --version' ;;\n{}  esac\n}}\n"
             "_mwt_kind() {{\n  case \"$1 $2\" in\n{}  esac\n}}\n"
             "_mwt_words() {{\n  case $1 in\n{}  esac\n}}\n",
             joined(names, " "), options_of, kind_of, words_of) +
         kBashEngine;
}

}  // namespace mwt
