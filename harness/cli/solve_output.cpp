#include "harness/cli/solve_output.h"

#include <fmt/core.h>

#include "base/number_text.h"
#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

std::string text_of(const Interval& interval) {
  if (interval.lower == interval.upper) return number_text(interval.lower);
  return fmt::format("[{}, {}]", number_text(interval.lower), number_text(interval.upper));
}

std::string text_of(const std::map<std::string, std::string>& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters) text += ' ' + name + '=' + value;
  return text;
}

std::string points_text(const SolveOutput& output) {
  std::string text = std::to_string(output.n);
  if (output.duplicates > 0) text += fmt::format(", {} distinct", output.distinct);
  return fmt::format("{}, {} on the hull", text, output.hull_size);
}

void add_quality(AlignedTable& table, const RatedRun& run, bool optimum_cached) {
  if (run.weight_upper) table.add_row({"weight", text_of(Interval{run.weight_lower.value(), *run.weight_upper})});
  if (run.perimeter_sum) table.add_row({"sum of perimeters", number_text(*run.perimeter_sum)});
  if (!run.triangulation_count.empty()) table.add_row({"triangulations", run.triangulation_count});
  const std::string cached = optimum_cached ? ", cached" : "";
  if (const auto optimum = optimum_of(run)) {
    table.add_row({"optimum (" + run.optimality + cached + ")", text_of(*optimum)});
  }
  if (run.alpha_upper) table.add_row({"alpha", text_of(Interval{run.alpha_lower.value(), *run.alpha_upper})});
}

void add_costs(AlignedTable& table, const RatedRun& run) {
  table.add_row({"time", readable_duration(run.wall_time_s.value_or(0)) + " (CPU " +
                             readable_duration(run.cpu_time_s.value_or(0)) + ")"});
  const auto bytes = static_cast<double>(run.peak_rss_bytes.value_or(0));
  table.add_row({"peak memory", fixed(bytes / (1 << 20), 1) + " MB"});
  for (const auto& [name, seconds] : run.phases) table.add_row({"  " + name, readable_duration(seconds)});
  for (const auto& [name, value] : run.counters) table.add_row({"  " + name, number_text(value)});
}

}  // namespace

std::string readable_text(const SolveOutput& output) {
  const RatedRun& run = output.run;
  AlignedTable table({"algorithm", output.algorithm + text_of(output.parameters)}, {1});
  table.add_row({"points", points_text(output)});
  table.add_row({"triangles", fmt::format("{}{}", run.triangles.value_or(0),
                                          run.checker == "ok" ? ", checked" : ", NOT a triangulation")});
  if (run.edges) table.add_row({"edges", std::to_string(*run.edges)});
  add_quality(table, run, output.optimum_cached);
  if (run.stop_reason) table.add_row({"stopped early", std::string(phrase_of(*run.stop_reason))});
  add_costs(table, run);
  return table.text();
}

}  // namespace mwt
