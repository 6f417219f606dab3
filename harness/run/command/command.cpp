#include "harness/run/command/command.h"

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/points/point_file.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_lines.h"
#include "harness/run/command/command_folder.h"
#include "harness/run/command/command_reply.h"
#include "harness/run/command/external_process.h"

namespace mwt {

namespace {

constexpr int kNotApplicable = 77;                // of "skip" in many test programs
constexpr auto kGrace = std::chrono::seconds(5);  // studies kill earlier, by their own limits
constexpr std::size_t kErrorTail = 500;           // bytes of standard error in messages
constexpr std::size_t kMaxStatement = std::size_t{1} << 20;
const std::vector<std::string> kFileNames = {"points", "triangles", "edges"};
const std::vector<std::string> kValueNames = {"seed", "threads", "time_limit", "n"};

using Values = std::map<std::string, std::string>;

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

// Calls `use` with every {name} in a word, and replaces it by what that returns. "{{" stands for "{".
template <class Use>
std::string with_placeholders(const std::string& word, const Use& use) {
  std::string result;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word.compare(i, 2, "{{") == 0) {
      result += '{';
      ++i;
      continue;
    }
    const std::size_t end = word[i] == '{' ? word.find('}', i) : std::string::npos;
    const std::string name = end == std::string::npos ? "" : word.substr(i + 1, end - i - 1);
    if (!is_name(name)) {
      result += word[i];
      continue;
    }
    result += use(name);
    i = end;
  }
  return result;
}

bool has_placeholder(const ExternalCommand& command, const std::string& name) {
  bool found = false;
  const auto look = [&](const std::string& placeholder) {
    found = found || placeholder == name;
    return "";
  };
  for (const std::string& word : command.words) static_cast<void>(with_placeholders(word, look));
  for (const auto& [variable, value] : command.environment) static_cast<void>(with_placeholders(value, look));
  return found;
}

// Of a file of text, at most so many bytes from its end.
std::string end_of(const std::string& file, std::size_t size) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return "";
  const auto end = static_cast<std::size_t>(stream.tellg());
  std::string content(std::min(end, size), '\0');
  stream.seekg(static_cast<std::streamoff>(end - content.size()));
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  return content;
}

bool speaks_of_memory(const std::string& errors) {
  static const std::vector<std::string> words = {"MemoryError",  "bad_alloc",    "annot allocate memory",
                                                 "ut of memory", "ut of Memory", "emory exhausted"};
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& phrase) { return errors.find(phrase) != std::string::npos; });
}

// One execution of the command.
class CommandExecution {
 public:
  CommandExecution(const ExternalCommand& command, Points points, Context& context)
      : command_(command), points_(points), context_(context) {}

  Solution run() {
    const std::string points_file = folder_.file("points." + command_.points_format);
    write_points(points_file, points_);
    ProcessOrder order;
    for (const std::string& word : command_.words) order.words.push_back(filled_in(word, points_file));
    for (const auto& [name, value] : command_.environment) order.environment[name] = filled_in(value, points_file);
    order.folder = command_.folder;
    order.mark = folder_.path();
    order.input_file = has_placeholder(command_, "points") ? "/dev/null" : points_file;
    order.output_file = folder_.file("output.csv");
    order.error_file = folder_.file("errors.txt");
    if (context_.deadline) order.kill_at = *context_.deadline + kGrace;
    const ProcessEndState end = run_process(order);
    context_.outside = {end.wall_time_s, end.cpu_time_s, end.peak_rss_bytes};
    require_success(end);
    return solution();
  }

 private:
  [[nodiscard]] std::string filled_in(const std::string& word, const std::string& points_file) const {
    return with_placeholders(word, [&](const std::string& name) -> std::string {
      if (name == "points") return points_file;
      if (name == "triangles" || name == "edges") return folder_.file(name + ".csv");
      if (name == "seed") return std::to_string(context_.seed);
      if (name == "threads") return std::to_string(context_.threads);
      if (name == "n") return std::to_string(points_.size());
      if (name == "time_limit") return time_limit();
      return context_.parameters.text(name);
    });
  }

  [[nodiscard]] std::string time_limit() const {
    if (!context_.deadline) return "1000000000";
    const std::chrono::duration<double> left = *context_.deadline - Context::Clock::now();
    return fmt::format("{:.3f}", std::max(left.count(), 0.0));
  }

  [[nodiscard]] std::string with_errors(const std::string& message) const {
    const std::string errors = one_line(end_of(folder_.file("errors.txt"), kErrorTail));
    return errors.empty() ? message : message + "; standard error: " + errors;
  }

  void require_success(const ProcessEndState& end) const {
    if (end.is_late) throw CommandFailure(RunStatus::timeout, "it was killed after its time limit");
    if (!end.exit_code) {
      const std::string how = fmt::format("signal {} ({})", end.signal, strsignal(end.signal));
      throw CommandFailure(end.signal == SIGKILL ? RunStatus::out_of_memory : RunStatus::crashed, with_errors(how));
    }
    if (*end.exit_code == 0) return;
    const std::string message = with_errors(fmt::format("it exits with {}", *end.exit_code));
    if (*end.exit_code == kNotApplicable) throw NotApplicable(message);
    throw CommandFailure(speaks_of_memory(message) ? RunStatus::out_of_memory : RunStatus::error, message);
  }

  [[nodiscard]] Solution solution() const {
    try {
      return read_solution();
    } catch (const CommandFailure& failure) {
      throw CommandFailure(failure.status(), with_errors(failure.what()));
    }
  }

  [[nodiscard]] Solution read_solution() const {
    Solution result;
    const std::string output_file = folder_.file("output.csv");
    for (const auto kind : {ReplyKind::triangles, ReplyKind::edges}) {
      const std::string name = kind == ReplyKind::triangles ? "triangles" : "edges";
      if (!has_placeholder(command_, name)) continue;
      std::string output = end_of(output_file, kMaxStatement);
      take_statement(output, result);
      result.triangulation = read_reply(folder_.file(name + ".csv"), kind, points_);
      return result;
    }
    std::string output = read_file(output_file);
    take_statement(output, result);
    const std::string rest = folder_.file("triangles.csv");
    write_file_atomically(rest, output);
    result.triangulation = read_reply(rest, ReplyKind::triangles, points_);
    return result;
  }

  const ExternalCommand& command_;
  Points points_;
  Context& context_;
  CommandFolder folder_;
};

void require_known_placeholders(const std::string& text, const Values& defaults) {
  static_cast<void>(with_placeholders(text, [&](const std::string& name) {
    const bool is_known = std::ranges::find(kFileNames, name) != kFileNames.end() ||
                          std::ranges::find(kValueNames, name) != kValueNames.end() || defaults.contains(name);
    if (!is_known) {
      throw InputError("unknown placeholder {" + name +
                       "}; known: {points}, {triangles}, {edges}, {seed}, {threads}, "
                       "{time_limit}, {n} and the parameters; write {{ for a brace");
    }
    return "";
  }));
}

}  // namespace

AlgorithmInfo algorithm_of(const std::string& name, const ExternalCommand& command, const Values& defaults) {
  static const std::vector<std::string> formats = {"txt", "csv", "tsp", "json"};
  if (!is_name(name)) throw InputError(shown(name) + ": a name consists of letters, digits and '_'");
  if (command.words.empty()) throw InputError("'command' is empty; give the program and its arguments");
  if (std::ranges::find(formats, command.points_format) == formats.end())
    throw InputError("unknown format of points " + shown(command.points_format) + "; known: " + joined(formats, ", "));
  for (const std::string& word : command.words) require_known_placeholders(word, defaults);
  for (const auto& [variable, value] : command.environment) require_known_placeholders(value, defaults);
  if (has_placeholder(command, "triangles") && has_placeholder(command, "edges"))
    throw InputError("the command has both {triangles} and {edges}; it answers with one of them");
  AlgorithmInfo info;
  info.name = name;
  info.summary = "command: " + joined(command.words, " ");
  info.source = "a program of its own";
  info.guarantee = "none known";
  info.time = info.space = "unknown";
  info.runs_outside = true;
  for (const auto& [parameter, value] : defaults)
    info.parameters.push_back({parameter, ParameterType::text, value, "of the command", {}});
  info.function = [command](Points points, Context& context) {
    return CommandExecution(command, points, context).run();
  };
  return info;
}

std::string content_hash_of(const ExternalCommand& command) {
  std::string content = joined(command.words, "\n") + '\n' + command.points_format;
  for (const auto& [name, value] : command.environment) content += '\n' + name + '=' + value;
  for (const std::string& word : command.words) {
    const std::filesystem::path path = std::filesystem::path(command.folder) / word;
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error)) content += '\n' + sha256_of_file(path.string());
  }
  return short_hash(content);
}

}  // namespace mwt
