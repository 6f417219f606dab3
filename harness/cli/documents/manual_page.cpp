#include "harness/cli/documents/manual_page.h"

#include <fmt/core.h>

#include <cctype>

#include "harness/run/machine/build_info.h"

namespace mwt {

namespace {

// Text as roff prints it unchanged: a hyphen that can be copied, no escapes, no control lines.
std::string roff(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (letter == '\\') {
      safe += "\\e";
    } else if (letter == '-') {
      safe += "\\-";
    } else {
      safe += letter;
    }
  }
  if (safe.starts_with('.') || safe.starts_with('\'')) safe.insert(0, "\\&");
  return safe;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string head(const std::string& program, const std::string& name_line) {
  std::string title = program;
  std::string what = name_line;  // whatis and apropos list these: lower case
  what.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(what.front())));
  for (char& letter : title) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return fmt::format(
      ".\\\" Made by mwt manual from the program's own commands and options.\n"
      ".TH {} 1 \"\" \"mwt {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n",
      title, version(), roff(program), roff(what));
}

// "-o, --output FILE" in bold and italics.
std::string heading_of(const DeclaredOption& option) {
  std::string names;
  for (const char letter : option.names) names += letter == ',' ? std::string(", ") : std::string(1, letter);
  std::string heading = option.is_argument() ? italic(names) : bold(names);
  if (!option.is_argument() && !option.is_flag()) heading += ' ' + italic(option.value.word);
  return heading + (option.is_argument() && option.repeats ? "..." : "");
}

std::string paragraph_of(const DeclaredOption& option) {
  std::string text = fmt::format(".TP\n{}\n{}", heading_of(option), roff(option.help));
  if (!option.default_value.empty()) text += roff(" [default: " + option.default_value + "]");
  if (!option.is_argument() && option.is_required) text += " (required)";
  return text + '\n';
}

std::string synopsis_of(const std::string& name, const std::vector<DeclaredOption>& options) {
  std::string line = bold(name);
  for (const DeclaredOption& option : options) {
    if (option.is_argument()) {
      const std::string shown = italic(option.names) + (option.repeats ? "..." : "");
      line += option.is_required ? ' ' + shown : " [" + shown + ']';
    } else if (option.is_required) {
      line += ' ' + bold(option.names.substr(option.names.find(',') + 1)) + ' ' + italic(option.value.word);
    }
  }
  return line + " [" + italic("options") + "]\n";
}

std::string paragraphs_of(const std::vector<DeclaredOption>& options) {
  std::string text;
  for (const DeclaredOption& option : options) text += paragraph_of(option);
  return text;
}

std::string exit_status() { return ".SH EXIT STATUS\n" + roff(exit_codes_text()) + '\n'; }

}  // namespace

std::string manual_page(const std::string& program, const std::string& name_line, std::span<const Command> commands) {
  std::string text = head(program, name_line);
  text += fmt::format(".SH SYNOPSIS\n{0} {1} [{2}]\n.br\n{0} [{1}] {3}\n.br\n{0} {4}\n.SH COMMANDS\n", bold(program),
                      italic("command"), italic("options"), bold("--help"), bold("--version"));
  for (const Command& command : commands) {
    const std::vector<DeclaredOption> options = declared_options(command);
    text += ".SS " + synopsis_of(program + ' ' + command.name, options) + roff(command.summary) + ".\n";
    text += paragraphs_of(options);
  }
  return text + exit_status() + ".SH ENVIRONMENT\n.TP\n" + bold("MWT_CACHE_DIR") +
         "\nthe folder of proved optima; if it is not set, $XDG_CACHE_HOME/mwt/optima or ~/.cache/mwt/optima\n" +
         ".SH SEE ALSO\n.BR mwt_verify (1)\n";
}

std::string manual_page(const Command& program) {
  const std::vector<DeclaredOption> options = declared_options(program);
  return head(program.name, program.summary) + ".SH SYNOPSIS\n" + synopsis_of(program.name, options) + ".SH OPTIONS\n" +
         paragraphs_of(options) + exit_status() + ".SH SEE ALSO\n.BR mwt (1)\n";
}

}  // namespace mwt
