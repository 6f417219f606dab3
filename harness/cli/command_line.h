// Parsing the command line. Only command_line.cpp includes CLI11.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "harness/cli/value_kind.h"
#include "harness/io/exit_code.h"

namespace CLI {
class App;
}

namespace mwt {

/// One argument or option, as declared.
struct DeclaredOption {
  std::string names;  ///< "-o,--output", or "points" for an argument
  ValueKind value;
  std::string help;
  std::string default_value{};  ///< empty if there is none to state
  bool is_required = false;
  bool repeats = false;  ///< it may be given several times

  [[nodiscard]] bool is_argument() const { return !names.starts_with('-'); }
  [[nodiscard]] bool is_flag() const { return value.word.empty(); }
};

/// Declares what a command takes. Every `value` gets its value when the command line is parsed, before Command::run,
/// and keeps its default if the option is not given.
class CommandOptions {
 public:
  /// Declares to the parser; what was declared is appended to `declared`.
  CommandOptions(CLI::App& app, std::vector<DeclaredOption>& declared) : app_(app), declared_(declared) {}

  void argument(const std::string& name, std::string& value, const ValueKind& kind, const std::string& help);
  void optional_argument(const std::string& name, std::string& value, const ValueKind& kind, const std::string& help);

  /// One or more.
  void arguments(const std::string& name, std::vector<std::string>& values, const ValueKind& kind,
                 const std::string& help);
  void optional_arguments(const std::string& name, std::vector<std::string>& values, const ValueKind& kind,
                          const std::string& help);

  void flag(const std::string& names, bool& value, const std::string& help);
  void required(const std::string& names, std::string& value, const ValueKind& kind, const std::string& help);
  void option(const std::string& names, std::optional<std::string>& value, const ValueKind& kind,
              const std::string& help);

  /// Numbers, all read by base/given_number.h: decimal, and within a range or an InputError. The first two have the
  /// whole range of their type; `positive` is from 1 to `most`, or from 1e-9 to 1e9.
  void option(const std::string& name, std::uint64_t& value, const std::string& help);
  void option(const std::string& name, std::optional<Index>& value, const std::string& help);
  void positive(const std::string& name, int& value, const std::string& help, int most = 1 << 20);
  void positive(const std::string& name, std::optional<double>& value, const std::string& help);

  /// An option that may be given several times.
  void repeated(const std::string& name, std::vector<std::string>& values, const ValueKind& kind,
                const std::string& help);

 private:
  CLI::App& app_;
  std::vector<DeclaredOption>& declared_;
};

struct Command {
  std::string name;
  std::string summary;
  std::function<void(CommandOptions&)> declare;
  std::function<int()> run;  ///< returns the exit code
};

/// What the command takes, --help left out.
[[nodiscard]] std::vector<DeclaredOption> declared_options(const Command& command);

/// What --help ends with: the meaning of the exit codes.
[[nodiscard]] std::string exit_codes_text();

/// Parses, runs the command that the first argument names, and turns what it throws into an exit code and one line
/// "mwt: ..." on standard error: InputError and NotApplicable are the user's mistakes, everything else a failure.
[[nodiscard]] int run_command_line(std::span<const Command> commands, int argument_count, char** arguments);

/// The same for a program that is one command, such as mwt_verify.
[[nodiscard]] int run_single_command(const Command& program, int argument_count, char** arguments);

/// {"k=v", ...} as a map. InputError unless each has a name and a '=', and no name comes twice.
[[nodiscard]] std::map<std::string, std::string> parse_parameters(const std::vector<std::string>& texts);

}  // namespace mwt
