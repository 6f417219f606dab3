#include "harness/cli/command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include <concepts>
#include <exception>
#include <iostream>
#include <limits>
#include <new>

#include "algorithms/algorithm.h"
#include "base/error.h"
#include "base/given_number.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_lines.h"
#include "harness/run/command/command.h"
#include "harness/run/machine/build_info.h"

namespace mwt {

namespace {

// "mwt: MESSAGE" on standard error.
int complain(const std::string& program, const std::string& message, ExitCode code) {
  std::cerr << program << ": " << one_line(message) << std::endl;
  return code;
}

std::string names_of(std::span<const Command> commands) {
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  return joined(names);
}

void require_known_command(std::span<const Command> commands, int argument_count, char** arguments) {
  if (argument_count < 2) throw InputError("no command given; known: " + names_of(commands) + "; see mwt --help");
  const std::string name = arguments[1];
  if (name.starts_with('-')) return;
  for (const Command& command : commands) {
    if (command.name == name) return;
  }
  throw InputError(fmt::format("unknown command '{}'; known: {}; see mwt --help", name, names_of(commands)));
}

// CLI11 would take 0100 for 64 and wrap -1 around, so it is given texts only.
template <class Number, class Use>
CLI::Option* add_number(CLI::App& app, const DeclaredOption& declared, NumberRange<Number> range, const Use& use) {
  const auto read = [name = declared.names, range, use](const std::string& text) {
    use(given_number(name + ' ' + shown(text), text, range));
  };
  CLI::Option* const option = app.add_option_function<std::string>(declared.names, read, declared.help);
  if (!declared.default_value.empty()) option->default_str(declared.default_value);
  return option->type_name(declared.value.word);
}

int run_and_flush(const Command& command) {
  const int code = command.run();
  if (!std::cout.flush()) throw InputError("standard output cannot be written (disk full or pipe closed)");
  return code;
}

// Runs the parser; the exit code of --help or --version if one of them was given.
std::optional<int> parse(CLI::App& app, int argument_count, char** arguments) {
  try {
    app.parse(argument_count, arguments);
    return std::nullopt;
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    std::string command = app.get_name();
    if (!app.get_subcommands().empty()) command += ' ' + app.get_subcommands().front()->get_name();
    throw InputError(fmt::format("{}; see {} --help", one_line(error.what()), command));
  }
}

void prepare(CLI::App& app) {
  app.set_version_flag("--version", app.get_name() + " " + version(), "Print the version and exit");
  app.footer(exit_codes_text());
}

int parse_and_run(std::span<const Command> commands, int argument_count, char** arguments) {
  require_known_command(commands, argument_count, arguments);
  CLI::App app("Laboratory for minimum weight triangulations: see README.md", "mwt");
  app.require_subcommand(1);
  prepare(app);
  std::vector<CLI::App*> parsers;
  std::vector<DeclaredOption> ignored;
  for (const Command& command : commands) {
    parsers.push_back(app.add_subcommand(command.name, command.summary));
    CommandOptions options(*parsers.back(), ignored);
    command.declare(options);
  }
  if (const auto code = parse(app, argument_count, arguments)) return *code;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (parsers[i]->parsed()) return run_and_flush(commands[i]);
  }
  return kExitOk;
}

int parse_and_run(const Command& program, int argument_count, char** arguments) {
  CLI::App app(program.summary, program.name);
  prepare(app);
  std::vector<DeclaredOption> ignored;
  CommandOptions options(app, ignored);
  program.declare(options);
  if (const auto code = parse(app, argument_count, arguments)) return *code;
  return run_and_flush(program);
}

// Turns what `run` throws into an exit code and a line.
int guarded(const std::string& program, const std::function<int()>& run) {
  try {
    return run();
  } catch (const InputError& error) {
    return complain(program, error.what(), kExitUserMistake);
  } catch (const NotApplicable& reason) {
    return complain(program, reason.what(), kExitUserMistake);
  } catch (const CommandFailure& failure) {
    return complain(program, fmt::format("the command failed ({}): {}", name_of(failure.status()), failure.what()),
                    kExitNegative);
  } catch (const std::bad_alloc&) {
    return complain(program, "internal failure: out of memory", kExitFailure);
  } catch (const std::exception& failure) {
    return complain(program, std::string("internal failure: ") + failure.what(), kExitFailure);
  }
}

}  // namespace

void CommandOptions::argument(const std::string& name, std::string& value, const ValueKind& kind,
                              const std::string& help) {
  app_.add_option(name, value, help)->required()->type_name(kind.word);
  declared_.push_back({.names = name, .value = kind, .help = help, .is_required = true});
}

void CommandOptions::optional_argument(const std::string& name, std::string& value, const ValueKind& kind,
                                       const std::string& help) {
  app_.add_option(name, value, help)->type_name(kind.word);
  declared_.push_back({.names = name, .value = kind, .help = help});
}

void CommandOptions::arguments(const std::string& name, std::vector<std::string>& values, const ValueKind& kind,
                               const std::string& help) {
  app_.add_option(name, values, help)->required()->type_name(kind.word);
  declared_.push_back({.names = name, .value = kind, .help = help, .is_required = true, .repeats = true});
}

void CommandOptions::optional_arguments(const std::string& name, std::vector<std::string>& values,
                                        const ValueKind& kind, const std::string& help) {
  app_.add_option(name, values, help)->type_name(kind.word);
  declared_.push_back({.names = name, .value = kind, .help = help, .repeats = true});
}

void CommandOptions::flag(const std::string& names, bool& value, const std::string& help) {
  app_.add_flag(names, value, help);
  declared_.push_back({.names = names, .value = {}, .help = help});
}

void CommandOptions::required(const std::string& names, std::string& value, const ValueKind& kind,
                              const std::string& help) {
  app_.add_option(names, value, help)->required()->type_name(kind.word);
  declared_.push_back({.names = names, .value = kind, .help = help, .is_required = true});
}

void CommandOptions::option(const std::string& names, std::optional<std::string>& value, const ValueKind& kind,
                            const std::string& help) {
  app_.add_option(names, value, help)->type_name(kind.word);
  declared_.push_back({.names = names, .value = kind, .help = help});
}

void CommandOptions::option(const std::string& name, std::uint64_t& value, const std::string& help) {
  constexpr NumberRange<std::uint64_t> kAll{0, std::numeric_limits<std::uint64_t>::max()};
  declared_.push_back({.names = name, .value = kWholeNumber, .help = help, .default_value = std::to_string(value)});
  add_number(app_, declared_.back(), kAll, [&value](std::uint64_t given) { value = given; });
}

void CommandOptions::option(const std::string& name, std::optional<Index>& value, const std::string& help) {
  constexpr NumberRange<Index> kAll{0, kNoIndex - 1};
  declared_.push_back({.names = name, .value = kWholeNumber, .help = help});
  add_number(app_, declared_.back(), kAll, [&value](Index given) { value = given; });
}

void CommandOptions::positive(const std::string& name, int& value, const std::string& help, int most) {
  const NumberRange<int> range{1, most};
  declared_.push_back({.names = name, .value = kWholeNumber, .help = help, .default_value = std::to_string(value)});
  add_number(app_, declared_.back(), range, [&value](int given) { value = given; });
}

void CommandOptions::positive(const std::string& name, std::optional<double>& value, const std::string& help) {
  constexpr NumberRange<double> kPositive{1e-9, 1e9};
  declared_.push_back({.names = name, .value = kNumber, .help = help});
  add_number(app_, declared_.back(), kPositive, [&value](double given) { value = given; });
}

void CommandOptions::repeated(const std::string& name, std::vector<std::string>& values, const ValueKind& kind,
                              const std::string& help) {
  app_.add_option(name, values, help)->allow_extra_args(false)->type_name(kind.word);
  declared_.push_back({.names = name, .value = kind, .help = help, .repeats = true});
}

std::vector<DeclaredOption> declared_options(const Command& command) {
  CLI::App unused;
  std::vector<DeclaredOption> declared;
  CommandOptions options(unused, declared);
  command.declare(options);
  return declared;
}

std::string exit_codes_text() {
  return "Exit codes: 0 success; 1 an invalid triangulation, a refused proof, a regression or failed runs; 2 a mistake "
         "in the input; 3 a bug.";
}

int run_command_line(std::span<const Command> commands, int argument_count, char** arguments) {
  return guarded("mwt", [&] { return parse_and_run(commands, argument_count, arguments); });
}

int run_single_command(const Command& program, int argument_count, char** arguments) {
  return guarded(program.name, [&] { return parse_and_run(program, argument_count, arguments); });
}

std::map<std::string, std::string> parse_parameters(const std::vector<std::string>& texts) {
  std::map<std::string, std::string> parameters;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw InputError("--param " + text + " is not of the form name=value");
    const auto [entry, is_new] = parameters.emplace(text.substr(0, equals), text.substr(equals + 1));
    if (!is_new) throw InputError("--param " + entry->first + " is given twice");
  }
  return parameters;
}

}  // namespace mwt
