#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/cli/json_output.h"
#include "harness/explore/frame.h"
#include "harness/explore/jobs.h"
#include "harness/explore/server/explore_server.h"
#include "harness/io/input_file.h"
#include "harness/io/points/point_file.h"
#include "harness/run/interrupt.h"

namespace mwt {

namespace {

struct ExploreArguments {
  std::string points;
  std::optional<std::string> columns;
  int port = 0;
  std::optional<double> time_limit_s;
  std::optional<std::string> view;
  bool open = false;
};

std::string given_points(const ExploreArguments& options, const JobLimits& limits) {
  if (options.points.empty()) return "";
  const std::vector<Point> points = read_points(options.points, column_names(options.columns));
  if (points.size() > limits.max_n)
    throw InputError(source_name(options.points) + ": " + std::to_string(points.size()) +
                     " points; the explorer takes at most " + std::to_string(limits.max_n));
  return encoded(points_frame(source_name(options.points), points));
}

void open_in_browser(const std::string& address) {
  std::array<char*, 3> arguments = {const_cast<char*>("xdg-open"), const_cast<char*>(address.c_str()), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
    std::cerr << "mwt: warning: xdg-open is missing; open the address yourself\n";
}

int explore(const ExploreArguments& options) {
  const Catalogue catalogue = Catalogue::built_in();
  JobLimits limits;
  limits.max_time_s = options.time_limit_s.value_or(limits.max_time_s);
  ExploreOptions server_options;
  server_options.port = options.port;
  server_options.parallel_jobs = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 2U, 8U));
  server_options.given_points = given_points(options, limits);
  server_options.catalogue = "{\"algorithms\":" + to_json(catalogue.algorithms()) +
                             ",\"generators\":" + to_json(catalogue.generators()) +
                             ",\"max_time_s\":" + number_text(limits.max_time_s) + "}";
  const JobHost host(
      [&](const std::string& request, const JobAnswer& answer) { do_job(catalogue, limits, request, answer); },
      limits.job_time_s(), limits.job_memory_bytes());
  ExploreServer server(host, std::move(server_options));
  const InterruptWatch watch;
  std::thread serving([&] { server.serve(); });
  const std::string address = server.address() + (options.view ? "#" + *options.view : "");
  std::cout << address << "\nCtrl-C ends it. Whoever has this address can use it, on this computer only.\n"
            << std::flush;
  if (options.open) open_in_browser(address);
  while (!InterruptWatch::requested()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  server.stop();
  serving.join();
  return kExitOk;
}

}  // namespace

Command explore_command() {
  const auto options = std::make_shared<ExploreArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.optional_argument("points", options->points, kFile, "point file to begin with; - for stdin");
    declare_columns(declared, options->columns);
    declared.positive("--port", options->port, "port on the loopback address; any free one if not given", 65535);
    declared.positive("--time-limit", options->time_limit_s,
                      "the longest that the page may let an algorithm run, in seconds; 60 if not given");
    declared.option("--view", options->view, kText,
                    "what the page shows first: the part behind # of a link of an earlier one");
    declared.flag("--open", options->open, "open the page with xdg-open");
  };
  return {"explore", "Look at algorithms at work on a page in the browser, served by this program", declare,
          [options] { return explore(*options); }};
}

}  // namespace mwt
