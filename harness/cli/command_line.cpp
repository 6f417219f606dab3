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

int complain(const std::string& message, ExitCode code) {
  std::cerr << "mwt: " << one_line(message) << std::endl;
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
CLI::Option* add_number(CLI::App& app, const std::string& name, const std::string& help, NumberRange<Number> range,
                        const Use& use) {
  const auto read = [name, range, use](const std::string& text) {
    use(given_number(name + ' ' + shown(text), text, range));
  };
  return app.add_option_function<std::string>(name, read, help)
      ->type_name(std::floating_point<Number> ? "NUMBER" : "N");
}

int run_and_flush(const Command& command) {
  const int code = command.run();
  if (!std::cout.flush()) throw InputError("standard output cannot be written (disk full or pipe closed)");
  return code;
}

int parse_and_run(std::span<const Command> commands, int argument_count, char** arguments) {
  CLI::App app("Laboratory for minimum weight triangulations: see README.md", "mwt");
  app.require_subcommand(1);
  app.set_version_flag("--version", "mwt " + version(), "Print the version and exit");
  std::vector<CLI::App*> parsers;
  for (const Command& command : commands) {
    parsers.push_back(app.add_subcommand(command.name, command.summary));
    CommandOptions options(*parsers.back());
    command.declare(options);
  }
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    const bool in_command = !app.get_subcommands().empty();
    throw InputError(one_line(error.what()) + "; see mwt " +
                     (in_command ? app.get_subcommands().front()->get_name() + " " : "") + "--help");
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (parsers[i]->parsed()) return run_and_flush(commands[i]);
  }
  return kExitOk;
}

}  // namespace

void CommandOptions::argument(const std::string& name, std::string& value, const std::string& help) {
  app_.add_option(name, value, help)->required();
}

void CommandOptions::optional_argument(const std::string& name, std::string& value, const std::string& help) {
  app_.add_option(name, value, help);
}

void CommandOptions::arguments(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  app_.add_option(name, values, help)->required();
}

void CommandOptions::optional_arguments(const std::string& name, std::vector<std::string>& values,
                                        const std::string& help) {
  app_.add_option(name, values, help);
}

void CommandOptions::flag(const std::string& name, bool& value, const std::string& help) {
  app_.add_flag(name, value, help);
}

void CommandOptions::required(const std::string& name, std::string& value, const std::string& help) {
  app_.add_option(name, value, help)->required();
}

void CommandOptions::option(const std::string& name, std::optional<std::string>& value, const std::string& help) {
  app_.add_option(name, value, help);
}

void CommandOptions::option(const std::string& name, std::uint64_t& value, const std::string& help) {
  constexpr NumberRange<std::uint64_t> kAll{0, std::numeric_limits<std::uint64_t>::max()};
  add_number(app_, name, help, kAll, [&value](std::uint64_t given) {
    value = given;
  })->default_str(std::to_string(value));
}

void CommandOptions::option(const std::string& name, std::optional<Index>& value, const std::string& help) {
  constexpr NumberRange<Index> kAll{0, kNoIndex - 1};
  add_number(app_, name, help, kAll, [&value](Index given) { value = given; });
}

void CommandOptions::positive(const std::string& name, int& value, const std::string& help, int most) {
  const NumberRange<int> range{1, most};
  add_number(app_, name, help, range, [&value](int given) { value = given; })->default_str(std::to_string(value));
}

void CommandOptions::positive(const std::string& name, std::optional<double>& value, const std::string& help) {
  constexpr NumberRange<double> kPositive{1e-9, 1e9};
  add_number(app_, name, help, kPositive, [&value](double given) { value = given; });
}

void CommandOptions::repeated(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  app_.add_option(name, values, help)->allow_extra_args(false);
}

int run_command_line(std::span<const Command> commands, int argument_count, char** arguments) {
  try {
    require_known_command(commands, argument_count, arguments);
    return parse_and_run(commands, argument_count, arguments);
  } catch (const InputError& error) {
    return complain(error.what(), kExitUserMistake);
  } catch (const NotApplicable& reason) {
    return complain(reason.what(), kExitUserMistake);
  } catch (const CommandFailure& failure) {
    return complain(fmt::format("the command failed ({}): {}", name_of(failure.status()), failure.what()),
                    kExitNegative);
  } catch (const std::bad_alloc&) {
    return complain("internal failure: out of memory", kExitFailure);
  } catch (const std::exception& failure) {
    return complain(std::string("internal failure: ") + failure.what(), kExitFailure);
  }
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
