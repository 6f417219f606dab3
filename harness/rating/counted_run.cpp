#include "harness/rating/counted_run.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/text/csv.h"
#include "harness/io/text/text.h"
#include "harness/io/triangulation_file.h"
#include "harness/run/command/command_folder.h"
#include "harness/run/command/external_process.h"

namespace mwt {

namespace {

constexpr double kSlowdown = 300;  // of a program under callgrind with simulated caches, at most; usually 50 to 100
constexpr double kPatienceWithValgrind = 600;  // s, for what is not counted, and for a busy machine
constexpr std::uint64_t kMemoryOfValgrind = std::uint64_t{2} << 30;
constexpr std::uint64_t kMemoryOfCounting = 4;
constexpr double kEqualWeight = 1e-9;

std::vector<std::string> words_of(const std::string& program, const Request& request, const CommandFolder& folder) {
  std::vector<std::string> words = {"valgrind",
                                    "--tool=callgrind",
                                    "--instr-atstart=no",
                                    "--cache-sim=yes",
                                    "--branch-sim=yes",
                                    "--I1=32768,8,64",
                                    "--D1=32768,8,64",
                                    "--LL=8388608,16,64",
                                    "--callgrind-out-file=" + folder.file("profile"),
                                    program,
                                    "solve",
                                    folder.file("points.txt"),
                                    "--algorithm",
                                    request.algorithm->name,
                                    "--seed",
                                    std::to_string(request.seed),
                                    "--json",
                                    "--no-cache"};
  for (const auto& [name, value] : request.parameters.all()) {
    words.emplace_back("--param");
    words.push_back(name + '=' + (request.start && name == "start" ? folder.file("start.csv") : value));
  }
  return words;
}

void write_input(const Request& request, Points points, const CommandFolder& folder) {
  std::string text;
  for (const Point& point : points) text += number_text(point.x) + ' ' + number_text(point.y) + '\n';
  write_file_atomically(folder.file("points.txt"), text);
  if (request.start) write_triangles(folder.file("start.csv"), request.start->triangles);
}

/// What the program writes must be of the same triangulation as far as its weight shows.
void require_same_weight(const std::string& output, const RatedRun& measured) {
  const nlohmann::json object = nlohmann::json::parse(output);
  const double weight = object.at("weight_upper").get<double>();
  const double expected = measured.weight_upper.value();
  if (std::fabs(weight - expected) > kEqualWeight * expected)
    throw std::runtime_error(fmt::format("its triangulation weighs {} under valgrind, {} without", number_text(weight),
                                         number_text(expected)));
}

// What happens in the process: the counts in a line, then the functions as CSV.
std::string count_here(const std::string& program, const Request& request, Points points, const RatedRun& measured,
                       double limit_s) {
  const CommandFolder folder;
  write_input(request, points, folder);
  const auto limit =
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(limit_s));
  ProcessOrder order;
  order.words = words_of(program, request, folder);
  order.input_file = "/dev/null";
  order.output_file = folder.file("output");
  order.error_file = folder.file("errors");
  order.environment["LD_BIND_NOW"] = "1";  // the dynamic linker's work is none of the algorithm's
  order.kill_at = std::chrono::steady_clock::now() + limit;
  const ProcessEndState end = run_process(order);
  if (end.is_late) throw std::runtime_error(fmt::format("not done after {:.0f} s under valgrind", limit_s));
  const std::string output = read_file(order.output_file);
  if (output.empty()) {  // what is certified under valgrind may be contradictory, and the exit code with it
    const std::string errors = read_file(order.error_file);
    constexpr std::size_t kTail = 300;
    throw std::runtime_error("it fails under valgrind: " +
                             one_line(errors.substr(errors.size() - std::min(errors.size(), kTail))));
  }
  require_same_weight(output, measured);
  const CallgrindProfile profile = parse_callgrind(read_file(folder.file("profile")));
  const CallgrindCounts& counts = profile.counts;
  return fmt::format("{} {} {} {}\n{}", counts.instructions, counts.l1_misses, counts.ll_misses, counts.branch_misses,
                     to_csv(profile.functions));
}

CallgrindProfile decoded_profile(const std::string& text) {
  const std::size_t line_end = text.find('\n');
  std::vector<std::uint64_t> counts;
  for (const std::string& field : split(text.substr(0, line_end), ' '))
    counts.push_back(parse_whole_number<std::uint64_t>(field).value());
  return {{counts.at(0), counts.at(1), counts.at(2), counts.at(3)}, functions_of_csv(text.substr(line_end + 1))};
}

CountedRun counted_after(const ProcessResult& process) {
  if (process.end == ProcessEnd::finished) return {decoded_profile(process.output), ""};
  return {std::nullopt, process.error_tail.empty() ? process.how : process.error_tail};
}

}  // namespace

bool has_valgrind() {
  const char* const variable = std::getenv("PATH");
  for (const std::string& folder : split(variable == nullptr ? "/usr/bin:/bin" : variable, ':')) {
    std::error_code error;
    if (std::filesystem::is_regular_file(std::filesystem::path(folder) / "valgrind", error)) return true;
  }
  return false;
}

bool can_be_counted(const RatedRun& run, const Request& request) {
  const bool is_complete = run.status == RunStatus::ok && !run.stopped_early.value_or(false);
  return is_complete && run.weight_upper && request.threads == 1 && !request.algorithm->runs_outside;
}

void start_counted_run(ProcessPool& pool, const std::string& program, const Request& request, const Instance& instance,
                       const RunLimits& limits, const RatedRun& measured, std::function<void(CountedRun)> when_done) {
  const double limit_s = kPatienceWithValgrind + kSlowdown * measured.cpu_time_s.value_or(0);
  ProcessLimits process;
  process.wall_s = process.cpu_s = 2 * kPatienceWithValgrind + limit_s;
  process.memory_bytes = kMemoryOfCounting * limits.memory_bytes + kMemoryOfValgrind;
  const Points points = instance.set.points;
  const auto work = [&] { return count_here(program, request, points, measured, limit_s); };
  pool.start(work, process, [when_done = std::move(when_done)](const ProcessResult& result) {
    if (result.end != ProcessEnd::finished) remove_abandoned_command_folders();
    when_done(counted_after(result));
  });
}

}  // namespace mwt
