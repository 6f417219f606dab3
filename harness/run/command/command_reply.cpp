#include "harness/run/command/command_reply.h"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "geometry/edge_faces.h"
#include "geometry/predicates.h"
#include "harness/io/text/text_lines.h"
#include "harness/io/triangulation_file.h"
#include "harness/run/command/command.h"

namespace mwt {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxShown = 100;

[[noreturn]] void refuse(const std::string& what) { throw CommandFailure(RunStatus::invalid_output, what); }

double number_in(const json& value, const std::string& name) {
  if (!value.is_number()) refuse("its statement's \"" + name + "\" is no number");
  const auto number = value.get<double>();
  if (!std::isfinite(number)) refuse("its statement's \"" + name + "\" is not finite");
  return number;
}

// Corners are checked before anything is looked up by them.
template <class Figure>
void require_corners(const std::vector<Figure>& figures, std::size_t point_count, const char* kind) {
  for (const Figure& figure : figures) {
    for (const Index corner : figure) {
      if (corner < point_count) continue;
      refuse(fmt::format("a corner of its {} is {}, but points go from 0 to {}{}", kind, corner, point_count - 1,
                         corner == point_count ? "; perhaps it counts from 1" : ""));
    }
  }
}

void enter(const std::string& name, const json& value, Solution& solution) {
  if (name == "time_s") {
    solution.counters["stated_time_s"] = number_in(value, name);
  } else if (name == "lower_bound") {
    solution.claimed_lower = number_in(value, name);
  } else if (name == "stopped_early") {
    if (!value.is_boolean()) refuse("its statement's \"stopped_early\" is neither true nor false");
    if (value.get<bool>()) solution.stop_reason = StopReason::deadline;
  } else if (name == "counters") {
    if (!value.is_object()) refuse("its statement's \"counters\" is no object");
    for (const auto& [counter, number] : value.items()) solution.counters[counter] = number_in(number, counter);
  } else {
    refuse("its statement has the unknown key " + shown(name) +
           "; known: time_s, lower_bound, stopped_early, counters");
  }
}

}  // namespace

Triangulation read_reply(const std::string& file, ReplyKind kind, Points points) {
  if (!std::filesystem::is_regular_file(file)) refuse("it wrote no file of its result");
  try {
    if (kind == ReplyKind::triangles) {
      Triangulation result{static_cast<Index>(points.size()), read_triangles(file)};
      require_corners(result.triangles, points.size(), "triangles");
      for (Triangle& t : result.triangles) {
        if (orientation(points[t[0]], points[t[1]], points[t[2]]) < 0) std::swap(t[1], t[2]);
      }
      return result;
    }
    const std::vector<Edge> edges = read_edges(file);
    std::vector<std::array<Index, 2>> ends;
    for (const auto& [a, b] : edges) {
      ends.push_back({a, b});
      if (a == b) refuse(fmt::format("one of its edges ends where it begins, at point {}", a));
    }
    require_corners(ends, points.size(), "edges");
    return triangulation_of(points, edges);
  } catch (const InputError& error) {
    std::string what = error.what();
    const std::string name = std::filesystem::path(file).filename().string();
    if (const std::size_t at = what.find(file); at != std::string::npos) what.replace(at, file.size(), name);
    refuse("its result cannot be read: " + what);
  }
}

void take_statement(std::string& output, Solution& solution) {
  while (!output.empty() && (output.back() == '\n' || output.back() == '\r' || output.back() == ' ')) output.pop_back();
  const std::size_t begin = output.rfind('\n') == std::string::npos ? 0 : output.rfind('\n') + 1;
  if (begin >= output.size() || output[begin] != '{') return;
  const std::string line = output.substr(begin);
  output.erase(begin);
  const json statement = json::parse(line, nullptr, false);
  if (!statement.is_object())
    refuse("its last line begins like a JSON object, but is none: " + shown(line.substr(0, kMaxShown)));
  for (const auto& [name, value] : statement.items()) enter(name, value, solution);
}

}  // namespace mwt
