#include <vector>

#include "harness/cli/commands/commands.h"
#include "harness/io/standard_streams.h"

int main(int argument_count, char** arguments) {
  mwt::open_closed_standard_streams();
  std::vector<mwt::Command> commands = {
      mwt::list_command(),    mwt::generate_command(), mwt::solve_command(),   mwt::check_command(),
      mwt::draw_command(),    mwt::convert_command(),  mwt::run_command(),     mwt::merge_command(),
      mwt::cluster_command(), mwt::report_command(),   mwt::archive_command(), mwt::compare_command(),
      mwt::track_command(),   mwt::history_command(),  mwt::hunt_command(),    mwt::explore_command()};
  commands.push_back(mwt::completion_command(commands));
  commands.push_back(mwt::manual_command(commands));
  return mwt::run_command_line(commands, argument_count, arguments);
}
