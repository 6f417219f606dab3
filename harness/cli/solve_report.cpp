#include "harness/cli/solve_report.h"

#include "base/number_text.h"
#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

std::string text_of(const Interval& interval) {
  if (interval.lower == interval.upper) return number_text(interval.lower);
  return '[' + number_text(interval.lower) + ", " + number_text(interval.upper) + ']';
}

std::string text_of(const std::map<std::string, std::string>& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters) text += ' ' + name + '=' + value;
  return text;
}

std::string points_text(const SolveReport& report) {
  std::string text = std::to_string(report.n);
  if (report.duplicates > 0) text += ", " + std::to_string(report.distinct) + " distinct";
  return text + ", " + std::to_string(report.hull_size) + " on the hull";
}

void add_quality(AlignedTable& table, const SolveReport& report) {
  if (report.weight) table.add_row({"weight", text_of(*report.weight)});
  if (report.perimeter_sum) table.add_row({"sum of perimeters", number_text(*report.perimeter_sum)});
  if (report.count) table.add_row({"triangulations", *report.count});
  const std::string cached = report.optimum_cached ? ", cached" : "";
  if (report.optimum) table.add_row({"optimum (" + report.optimality + cached + ")", text_of(*report.optimum)});
  if (report.alpha) table.add_row({"alpha", text_of(*report.alpha)});
}

void add_costs(AlignedTable& table, const SolveReport& report) {
  table.add_row(
      {"time", readable_duration(report.wall_time_s) + " (CPU " + readable_duration(report.cpu_time_s) + ")"});
  table.add_row({"peak memory", fixed(static_cast<double>(report.peak_rss_bytes) / (1 << 20), 1) + " MB"});
  for (const auto& [name, seconds] : report.phases) table.add_row({"  " + name, readable_duration(seconds)});
  for (const auto& [name, value] : report.counters) table.add_row({"  " + name, number_text(value)});
}

}  // namespace

std::string readable_text(const SolveReport& report) {
  AlignedTable table({"algorithm", report.algorithm + text_of(report.parameters)}, {1});
  table.add_row({"points", points_text(report)});
  table.add_row(
      {"triangles", std::to_string(report.triangles) + (report.valid ? ", checked" : ", NOT a triangulation")});
  if (report.edges) table.add_row({"edges", std::to_string(*report.edges)});
  add_quality(table, report);
  if (report.stop_reason) table.add_row({"stopped early", std::string(phrase_of(*report.stop_reason))});
  add_costs(table, report);
  return table.text();
}

}  // namespace mwt
