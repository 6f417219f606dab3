#include "harness/cli/verify_program.h"
#include "harness/io/standard_streams.h"

int main(int argument_count, char** arguments) {
  mwt::open_closed_standard_streams();
  return mwt::run_single_command(mwt::verify_program(), argument_count, arguments);
}
