#include "harness/command_line.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <exception>
#include <iostream>
#include <new>

#include "algorithms/algorithm.h"
#include "geometry/error.h"
#include "harness/text.h"

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
  throw InputError("unknown command '" + name + "'; known: " + names_of(commands) + "; see mwt --help");
}

int run_and_flush(const Command& command) {
  const int code = command.run();
  if (!std::cout.flush()) throw InputError("standard output cannot be written (disk full or pipe closed)");
  return code;
}

int parse_and_run(std::span<const Command> commands, int argument_count, char** arguments) {
  CLI::App app("Laboratory for minimum weight triangulations: see README.md", "mwt");
  app.require_subcommand(1);
  std::vector<CLI::App*> parsers;
  for (const Command& command : commands) {
    parsers.push_back(app.add_subcommand(command.name, command.summary));
    CommandOptions options(*parsers.back());
    command.declare(options);
  }
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::Success& help) {
    return app.exit(help);
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
  app_.add_option(name, value, help)->capture_default_str();
}

void CommandOptions::option(const std::string& name, std::optional<Index>& value, const std::string& help) {
  app_.add_option(name, value, help);
}

void CommandOptions::positive(const std::string& name, int& value, const std::string& help) {
  app_.add_option(name, value, help)->capture_default_str()->check(CLI::Range(1, 1 << 20).description(""));
}

void CommandOptions::positive(const std::string& name, std::optional<double>& value, const std::string& help) {
  // Not CLI::Range alone, which NaN passes.
  const auto is_number = [](const std::string& text) {
    double number = 0;
    const bool is_one = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
    return is_one ? std::string() : "'" + text + "' is no number";
  };
  app_.add_option(name, value, help)->check(is_number)->check(CLI::Range(1e-9, 1e9).description(""));
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
