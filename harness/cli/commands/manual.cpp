#include <iostream>
#include <memory>

#include "base/error.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/documents/manual_page.h"
#include "harness/cli/verify_program.h"

namespace mwt {

namespace {

struct ManualArguments {
  std::string program = "mwt";
};

int print_manual(const ManualArguments& options, std::span<const Command> commands) {
  if (options.program == "mwt") {
    std::cout << manual_page("mwt", "triangulate points, and measure how far from minimum weight", commands);
  } else if (options.program == "mwt_verify") {
    std::cout << manual_page(verify_program());
  } else {
    throw InputError("no manual page of '" + options.program + "'; known: mwt, mwt_verify");
  }
  return kExitOk;
}

}  // namespace

Command manual_command(const std::vector<Command>& commands) {
  const auto options = std::make_shared<ManualArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.optional_argument("program", options->program, one_of("PROGRAM", {"mwt", "mwt_verify"}),
                               "mwt or mwt_verify; mwt if not given");
  };
  return {"manual", "Print a manual page: mwt manual | man -l -", declare,
          [options, &commands] { return print_manual(*options, commands); }};
}

}  // namespace mwt
