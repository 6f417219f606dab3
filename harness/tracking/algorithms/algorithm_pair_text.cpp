#include "harness/tracking/algorithms/algorithm_pair_text.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"
#include "harness/tracking/measures.h"

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kLegend =
    "B/A: typical ratio (Hodges-Lehmann) with its exact 95% interval; effect: rank-biserial correlation, -1 where B is "
    "better on every instance, 1 where A is; q: Wilcoxon's signed-rank test, two-sided, adjusted for all cells "
    "(Benjamini-Hochberg)";

/// One of the two tables.
struct PairTable {
  std::string title;
  const std::vector<PairRow>& rows;
  std::string unit;  ///< of the medians
};

std::vector<PairTable> tables_of(const AlgorithmPair& pair) {
  return {{"alpha", pair.alpha, ""}, {pair.time_measure, pair.times, measure_named(pair.time_measure).unit}};
}

std::string median_text(const std::optional<double>& value, const std::string& unit) {
  if (!value) return "-";
  return unit == "s" ? readable_duration(*value) : fixed(*value, 4);
}

std::string ratio_text(double log_ratio) { return fixed(std::exp(log_ratio), 4); }

std::string interval_of(const PairRow& row) {
  const auto& interval = row.comparison.interval;
  return interval ? ratio_text(interval->lower) + " .. " + ratio_text(interval->upper) : "-";
}

/// Without parameters, unless the other one has the same name.
std::string short_name(const std::string& label, const std::string& other) {
  const std::string name = split(label, ' ').front();
  return name == split(other, ' ').front() ? label : name;
}

std::string verdict_text(const AlgorithmPair& pair, PairVerdict verdict) {
  switch (verdict) {
    case PairVerdict::a_is_better: return short_name(pair.a, pair.b) + " better";
    case PairVerdict::b_is_better: return short_name(pair.b, pair.a) + " better";
    case PairVerdict::equal: return "equal";
    case PairVerdict::not_sure: return "not sure";
  }
  return "";
}

CsvRow header(const std::string& title) {
  return {title, "n", "pairs", "A", "B", "B/A", "95% interval", "effect", "B better/equal/A", "q", "verdict"};
}

CsvRow cells_of(const AlgorithmPair& pair, const PairTable& table, const PairRow& row) {
  const PairedComparison& found = row.comparison;
  return {row.family,
          row.n == 0 ? "" : std::to_string(row.n),
          std::to_string(found.pairs()),
          median_text(row.a, table.unit),
          median_text(row.b, table.unit),
          ratio_text(found.shift),
          interval_of(row),
          fixed(found.effect, 2),
          fmt::format("{}/{}/{}", found.negative, found.zero, found.positive),
          row.q_value < 0.0005 ? "<0.001" : fixed(row.q_value, 3),
          verdict_text(pair, row.verdict)};
}

std::string sentence(const AlgorithmPair& pair, const PairTable& table) {
  if (table.rows.empty()) return table.title + ": nothing to compare";
  const PairRow& all = table.rows.back();
  const PairedComparison& found = all.comparison;
  const std::string counts = fmt::format("{} better on {} of {}, equal on {}", short_name(pair.b, pair.a),
                                         found.negative, counted(found.pairs(), "instance"), found.zero);
  return fmt::format("{}: {} ({}; B/A x{}{})", table.title, verdict_text(pair, all.verdict), counts,
                     ratio_text(found.shift), found.interval ? ", 95% interval " + interval_of(all) : "");
}

Json json_of(const AlgorithmPair& pair, const PairRow& row) {
  const PairedComparison& found = row.comparison;
  Json object = {{"family", row.family}, {"n", row.n}};
  if (row.a) object["a"] = *row.a;
  if (row.b) object["b"] = *row.b;
  object.update({{"pairs", found.pairs()},
                 {"b_better", found.negative},
                 {"equal", found.zero},
                 {"a_better", found.positive},
                 {"ratio", std::exp(found.shift)},
                 {"ratio_lower", nullptr},
                 {"ratio_upper", nullptr},
                 {"effect", found.effect},
                 {"p", found.p_value},
                 {"q", row.q_value},
                 {"verdict", verdict_text(pair, row.verdict)}});
  if (found.interval) {
    object["ratio_lower"] = std::exp(found.interval->lower);
    object["ratio_upper"] = std::exp(found.interval->upper);
  }
  return object;
}

}  // namespace

std::string summary_of(const AlgorithmPair& pair) {
  std::string text;
  for (const PairTable& table : tables_of(pair)) text += sentence(pair, table) + '\n';
  return text;
}

std::string algorithm_pair_text(const AlgorithmPair& pair) {
  std::string text = fmt::format("A = {}, B = {}, in {}\n{}", pair.a, pair.b, pair.folder, summary_of(pair));
  for (const std::string& note : pair.notes) text += "  " + note + '\n';
  for (const PairTable& table : tables_of(pair)) {
    if (table.rows.empty()) continue;
    AlignedTable aligned(header(table.title), {10});
    for (const PairRow& row : table.rows) aligned.add_row(cells_of(pair, table, row));
    text += '\n' + aligned.text();
  }
  return text + '\n' + kLegend + '\n';
}

std::string algorithm_pair_markdown(const AlgorithmPair& pair) {
  const auto line = [](const CsvRow& cells) { return "| " + joined(cells, " | ") + " |\n"; };
  std::string text = fmt::format("A = {}, B = {}, in {}\n\n", pair.a, pair.b, pair.folder);
  for (const PairTable& table : tables_of(pair)) text += "- " + sentence(pair, table) + '\n';
  for (const std::string& note : pair.notes) text += "- " + note + '\n';
  for (const PairTable& table : tables_of(pair)) {
    if (table.rows.empty()) continue;
    text += '\n' + line(header(table.title)) + line(CsvRow(header(table.title).size(), "---"));
    for (const PairRow& row : table.rows) text += line(cells_of(pair, table, row));
  }
  return text + '\n' + kLegend + '\n';
}

std::string algorithm_pair_json(const AlgorithmPair& pair) {
  Json object = {{"folder", pair.folder},
                 {"a", pair.a},
                 {"b", pair.b},
                 {"time_measure", pair.time_measure},
                 {"error_rate", pair.error_rate},
                 {"notes", pair.notes},
                 {"alpha", Json::array()},
                 {"times", Json::array()}};
  for (const PairRow& row : pair.alpha) object["alpha"].push_back(json_of(pair, row));
  for (const PairRow& row : pair.times) object["times"].push_back(json_of(pair, row));
  return object.dump(1) + '\n';
}

}  // namespace mwt
