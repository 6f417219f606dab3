#include "harness/tracking/comparison_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/aligned_table.h"
#include "harness/text.h"

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

const CsvRow kAlgorithmHeader = {"algorithm", "observations", "ratio", "95% interval", "q slower", "verdict"};
const CsvRow kCellHeader = {"algorithm", "instance",     "observations", "base",   "new",
                            "ratio",     "95% interval", "q slower",     "verdict"};
const CsvRow kFindingHeader = {"algorithm", "instance", "what", "verdict"};

std::string interval_text(const TimeRow& row) { return fixed(row.ratio.lower, 3) + " .. " + fixed(row.ratio.upper, 3); }

std::string small_number(double value) { return value < 0.0005 ? "<0.001" : fixed(value, 3); }

std::string time_text(double value, const Comparison& comparison) {
  return measure_named(comparison.time_measure).unit == "s" ? readable_duration(value) : fixed(value, 3);
}

CsvRow algorithm_cells(const TimeRow& row) {
  return {row.algorithm,      std::to_string(row.observations), fixed(row.ratio.value, 3),
          interval_text(row), small_number(row.q_slower),       name_of(row.verdict)};
}

CsvRow cell_cells(const TimeRow& row, const Comparison& comparison) {
  const bool judged = row.verdict != Verdict::identical_binary;
  return {row.algorithm,
          row.instance,
          std::to_string(row.observations),
          time_text(row.base, comparison),
          time_text(row.now, comparison),
          fixed(row.ratio.value, 3),
          judged ? interval_text(row) : "-",
          judged ? small_number(row.q_slower) : "-",
          name_of(row.verdict)};
}

CsvRow finding_cells(const ExactFinding& finding) {
  return {algorithm_label(finding.cell), instance_label(finding.cell), finding.text,
          finding.is_regression ? "regression" : "improvement"};
}

bool is_told(const TimeRow& row, bool every_cell) {
  return every_cell || row.verdict == Verdict::regression || row.verdict == Verdict::improvement;
}

/// A titled table, whatever it will look like.
struct Section {
  std::string title;
  CsvRow header;
  std::vector<std::size_t> left_aligned;
  std::vector<CsvRow> rows;
};

std::vector<Section> sections_of(const Comparison& comparison, bool every_cell) {
  std::vector<Section> sections;
  Section findings{"quality, memory, failures", kFindingHeader, {1, 2, 3}, {}};
  for (const ExactFinding& finding : comparison.findings) findings.rows.push_back(finding_cells(finding));
  Section algorithms{"times by algorithm (" + comparison.time_measure + ")", kAlgorithmHeader, {5}, {}};
  for (const TimeRow& row : comparison.algorithms) algorithms.rows.push_back(algorithm_cells(row));
  Section cells{"times by cell (" + comparison.time_measure + ")", kCellHeader, {1, 8}, {}};
  for (const TimeRow& row : comparison.cells) {
    if (is_told(row, every_cell)) cells.rows.push_back(cell_cells(row, comparison));
  }
  for (Section* section : {&findings, &algorithms, &cells}) {
    if (!section->rows.empty()) sections.push_back(std::move(*section));
  }
  return sections;
}

std::string markdown_row(const CsvRow& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += ' ' + cell + " |";
  return line + '\n';
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

/// The regressions (or improvements) to report: algorithms first; cells only of algorithms that are not among them.
std::vector<std::string> told(const Comparison& comparison, Verdict verdict) {
  std::vector<std::string> names;
  std::vector<std::string> algorithms;
  for (const TimeRow& row : comparison.algorithms) {
    if (row.verdict != verdict) continue;
    algorithms.push_back(row.algorithm);
    names.push_back("time of " + row.algorithm + " x" + fixed(row.ratio.value, 3));
  }
  for (const TimeRow& row : comparison.cells) {
    const bool covered = std::find(algorithms.begin(), algorithms.end(), row.algorithm) != algorithms.end();
    if (row.verdict == verdict && !covered)
      names.push_back("time of " + row.algorithm + " on " + row.instance + " x" + fixed(row.ratio.value, 3));
  }
  for (const ExactFinding& finding : comparison.findings) {
    if (finding.is_regression == (verdict == Verdict::regression))
      names.push_back(algorithm_label(finding.cell) + " on " + instance_label(finding.cell) + ": " + finding.text);
  }
  return names;
}

Json json_of(const TimeRow& row) {
  return {{"algorithm", row.algorithm},
          {"instance", row.instance},
          {"observations", row.observations},
          {"base", row.base},
          {"now", row.now},
          {"ratio", row.ratio.value},
          {"ratio_lower", row.ratio.lower},
          {"ratio_upper", row.ratio.upper},
          {"q_slower", row.q_slower},
          {"q_faster", row.q_faster},
          {"verdict", name_of(row.verdict)}};
}

Json json_of(const ExactFinding& finding) {
  return {{"algorithm", algorithm_label(finding.cell)},
          {"instance", instance_label(finding.cell)},
          {"aspect", name_of(finding.aspect)},
          {"regression", finding.is_regression},
          {"text", finding.text}};
}

template <class Rows>
Json json_array(const Rows& rows) {
  Json array = Json::array();
  for (const auto& row : rows) array.push_back(json_of(row));
  return array;
}

}  // namespace

std::string verdict_line(const Comparison& comparison) {
  const std::vector<std::string> worse = told(comparison, Verdict::regression);
  const std::vector<std::string> better = told(comparison, Verdict::improvement);
  const auto list = [](const std::vector<std::string>& names) {
    constexpr std::size_t kNamed = 5;
    if (names.empty()) return std::string();
    const std::vector<std::string> first(names.begin(),
                                         names.begin() + static_cast<long>(std::min(kNamed, names.size())));
    return " (" + joined(first, "; ") + (names.size() > kNamed ? "; ..." : "") + ")";
  };
  return counted(worse.size(), "regression") + list(worse) + ", " + counted(better.size(), "improvement") +
         list(better) + " in " + counted(comparison.compared_cells, "cell");
}

std::string comparison_text(const Comparison& comparison, bool every_cell) {
  std::string text = verdict_line(comparison) + '\n';
  for (const std::string& note : comparison.notes) text += "  " + note + '\n';
  for (const Section& section : sections_of(comparison, every_cell)) {
    AlignedTable table(section.header, section.left_aligned);
    for (const CsvRow& row : section.rows) table.add_row(row);
    text += '\n' + section.title + '\n' + table.text();
  }
  return text;
}

std::string comparison_markdown(const Comparison& comparison, bool every_cell) {
  std::string text = "**" + verdict_line(comparison) + "**\n\n";
  for (const std::string& note : comparison.notes) text += "- " + note + '\n';
  for (const Section& section : sections_of(comparison, every_cell)) {
    text += "\n### " + section.title + "\n\n" + markdown_row(section.header) +
            markdown_row(CsvRow(section.header.size(), "---"));
    for (const CsvRow& row : section.rows) text += markdown_row(row);
  }
  return text;
}

std::string comparison_json(const Comparison& comparison) {
  const Json object = {{"verdict", verdict_line(comparison)},
                       {"regression", comparison.has_regression()},
                       {"threshold", comparison.options.threshold},
                       {"error_rate", comparison.options.error_rate},
                       {"paired", comparison.options.paired},
                       {"time_measure", comparison.time_measure},
                       {"compared_cells", comparison.compared_cells},
                       {"notes", comparison.notes},
                       {"algorithms", json_array(comparison.algorithms)},
                       {"cells", json_array(comparison.cells)},
                       {"findings", json_array(comparison.findings)}};
  return object.dump(1) + '\n';
}

}  // namespace mwt
