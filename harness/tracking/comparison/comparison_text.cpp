#include "harness/tracking/comparison/comparison_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

const CsvRow kAlgorithmHeader = {"algorithm", "observations", "ratio", "95% interval", "q slower", "verdict"};
const CsvRow kCellHeader = {"algorithm", "instance",     "observations", "base",   "new",
                            "ratio",     "95% interval", "q slower",     "verdict"};
const CsvRow kFindingHeader = {"algorithm", "instance", "what", "verdict"};

std::string interval_text(const TimeRow& row) { return fixed(row.ratio.lower, 3) + " .. " + fixed(row.ratio.upper, 3); }

std::string small_number(double value) { return value < 0.0005 ? "<0.001" : fixed(value, 3); }

std::string time_text(const std::optional<double>& value, const Comparison& comparison) {
  if (!value) return "-";
  return measure_named(comparison.time_measure).unit == "s" ? readable_duration(*value) : fixed(*value, 3);
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

/// Of a finding about an algorithm as a whole there is no instance.
std::string place_of(const ExactFinding& finding) {
  return finding.cell.generator.empty() ? "all instances" : instance_label(finding.cell);
}

CsvRow finding_cells(const ExactFinding& finding) {
  return {algorithm_label(finding.cell), place_of(finding), finding.text,
          !finding.is_confirmed   ? "not confirmed"
          : finding.is_regression ? "regression"
                                  : "improvement"};
}

/// Which cells are listed.
enum class Cells { that_differ, that_differ_or_are_unclear, all };

bool is_told(const TimeRow& row, Cells cells) {
  if (row.verdict == Verdict::regression || row.verdict == Verdict::improvement) return true;
  return cells == Cells::all || (cells == Cells::that_differ_or_are_unclear && row.verdict == Verdict::unclear);
}

/// A titled table, whatever it will look like.
struct Section {
  std::string title;
  CsvRow header;
  std::vector<std::size_t> left_aligned;
  std::vector<CsvRow> rows;
};

std::vector<Section> sections_of(const Comparison& comparison, Cells listed) {
  std::vector<Section> sections;
  Section findings{"quality, memory, failures, counts", kFindingHeader, {1, 2, 3}, {}};
  for (const ExactFinding& finding : comparison.findings) findings.rows.push_back(finding_cells(finding));
  Section algorithms{"times by algorithm (" + comparison.time_measure + ")", kAlgorithmHeader, {5}, {}};
  for (const TimeRow& row : comparison.algorithms) algorithms.rows.push_back(algorithm_cells(row));
  Section cells{"times by cell (" + comparison.time_measure + ")", kCellHeader, {1, 8}, {}};
  for (const TimeRow& row : comparison.cells) {
    if (is_told(row, listed)) cells.rows.push_back(cell_cells(row, comparison));
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

/// " x1.150 (1.121 .. 1.180)".
std::string factor_text(const TimeRow& row) {
  return fmt::format(" x{:.3f} ({})", row.ratio.value, interval_text(row));
}

/// " in 3 of 8 cells": those that have the algorithm's verdict by themselves, too. Nothing of a row that is not sure.
std::string cells_like(const Comparison& comparison, const TimeRow& algorithm) {
  if (algorithm.verdict == Verdict::unclear) return "";
  std::size_t cells = 0, alike = 0;
  for (const TimeRow& row : comparison.cells) {
    if (algorithm.algorithm != kAllAlgorithms && row.algorithm != algorithm.algorithm) continue;
    ++cells;
    alike += row.verdict == algorithm.verdict ? 1 : 0;
  }
  return fmt::format(", by itself in {} of {}", alike, counted(cells, "cell"));
}

/// The rows with this verdict to report: algorithms first; cells only of algorithms that are not among them.
std::vector<std::string> reported_times(const Comparison& comparison, Verdict verdict) {
  std::vector<std::string> names;
  std::vector<std::string> algorithms;
  for (const TimeRow& row : comparison.algorithms) {
    if (row.verdict != verdict) continue;
    algorithms.push_back(row.algorithm);
    names.push_back("time of " + row.algorithm + factor_text(row) + cells_like(comparison, row));
  }
  for (const TimeRow& row : comparison.cells) {
    const bool covered = std::find(algorithms.begin(), algorithms.end(), row.algorithm) != algorithms.end();
    if (row.verdict == verdict && !covered)
      names.push_back(fmt::format("time of {} on {}{}", row.algorithm, row.instance, factor_text(row)));
  }
  return names;
}

std::vector<std::string> reported(const Comparison& comparison, Verdict verdict) {
  std::vector<std::string> names = reported_times(comparison, verdict);
  for (const ExactFinding& finding : comparison.findings) {
    if (finding.is_confirmed && finding.is_regression == (verdict == Verdict::regression))
      names.push_back(fmt::format("{} on {}: {}", algorithm_label(finding.cell), place_of(finding), finding.text));
  }
  return names;
}

Json json_of(const TimeRow& row) {
  Json object = {{"algorithm", row.algorithm}, {"instance", row.instance}, {"observations", row.observations}};
  if (row.base) object["base"] = *row.base;
  if (row.now) object["now"] = *row.now;
  object.update({{"ratio", row.ratio.value},
                 {"ratio_lower", row.ratio.lower},
                 {"ratio_upper", row.ratio.upper},
                 {"q_slower", row.q_slower},
                 {"q_faster", row.q_faster},
                 {"verdict", name_of(row.verdict)}});
  return object;
}

Json json_of(const ExactFinding& finding) {
  return {{"algorithm", algorithm_label(finding.cell)}, {"instance", place_of(finding)},
          {"aspect", name_of(finding.aspect)},          {"regression", finding.is_regression},
          {"confirmed", finding.is_confirmed},          {"text", finding.text}};
}

template <class Rows>
Json json_array(const Rows& rows) {
  Json array = Json::array();
  for (const auto& row : rows) array.push_back(json_of(row));
  return array;
}

Json json_of(const Comparison& comparison) {
  return {{"outcome", name_of(comparison.outcome())},
          {"verdict", verdict_line(comparison)},
          {"regression", comparison.has_regression()},
          {"threshold", comparison.options.threshold},
          {"error_rate", comparison.options.error_rate},
          {"paired", comparison.options.paired},
          {"time_measure", comparison.time_measure},
          {"compared_cells", comparison.compared_cells},
          {"notes", comparison.notes},
          {"base_commit", comparison.base_commit},
          {"new_commit", comparison.new_commit},
          {"only_in_base", comparison.only_in_base},
          {"only_in_new", comparison.only_in_new},
          {"untimed", comparison.untimed},
          {"algorithms", json_array(comparison.algorithms)},
          {"cells", json_array(comparison.cells)},
          {"findings", json_array(comparison.findings)}};
}

/// " (a; b; ...)", or nothing.
std::string in_brackets(const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 5;
  if (names.empty()) return "";
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, names.size()));
  return " (" + joined({names.begin(), end}, "; ") + (names.size() > kNamed ? "; ..." : "") + ")";
}

std::vector<std::string> labels_of(const std::set<TrackedCell>& cells) {
  std::vector<std::string> labels;
  for (const TrackedCell& cell : cells) labels.push_back(algorithm_label(cell) + " on " + instance_label(cell));
  return labels;
}

constexpr std::size_t kShortCommit = 10;
constexpr const char* kInTurn = "what these folders leave open, run by both builds in turn";

std::string commits_text(const Comparison& comparison) {
  return fmt::format("base: commit {}; new: commit {}", comparison.base_commit.substr(0, kShortCommit),
                     comparison.new_commit.substr(0, kShortCommit));
}

std::string text_of(const Comparison& comparison, Cells listed) {
  std::string text = verdict_line(comparison) + '\n' + "  " + commits_text(comparison) + '\n';
  for (const std::string& note : comparison.notes) text += "  " + note + '\n';
  for (const Section& section : sections_of(comparison, listed)) {
    AlignedTable table(section.header, section.left_aligned);
    for (const CsvRow& row : section.rows) table.add_row(row);
    text += '\n' + section.title + '\n' + table.text();
  }
  return text;
}

std::string markdown_of(const Comparison& comparison, Cells listed) {
  std::string text = "**" + verdict_line(comparison) + "**\n\n- " + commits_text(comparison) + '\n';
  for (const std::string& note : comparison.notes) text += "- " + note + '\n';
  for (const Section& section : sections_of(comparison, listed)) {
    text += fmt::format("\n### {}\n\n{}{}", section.title, markdown_row(section.header),
                        markdown_row(CsvRow(section.header.size(), "---")));
    for (const CsvRow& row : section.rows) text += markdown_row(row);
  }
  return text;
}

Cells listed_cells(bool every_cell) { return every_cell ? Cells::all : Cells::that_differ_or_are_unclear; }

/// Both parts, each made by `text_of_part`; what the folders leave unclear is listed where it was settled.
template <class TextOf>
std::string both_texts(const Settled& settled, bool every_cell, const std::string& title, TextOf text_of_part) {
  const Cells listed = listed_cells(every_cell);
  if (!settled.in_turn) return text_of_part(settled.folders, listed);
  return fmt::format("{}\n{}\n\n{}", text_of_part(settled.folders, every_cell ? Cells::all : Cells::that_differ), title,
                     text_of_part(*settled.in_turn, listed));
}

}  // namespace

std::string verdict_line(const Comparison& comparison) {
  const std::vector<std::string> worse = reported(comparison, Verdict::regression);
  const std::vector<std::string> better = reported(comparison, Verdict::improvement);
  const std::vector<std::string> open = reported_times(comparison, Verdict::unclear);
  const std::string unclear = open.empty() ? "" : fmt::format(", {} unclear{}", open.size(), in_brackets(open));
  const bool is_refused = comparison.outcome() == Outcome::not_compared;
  return fmt::format("{}{}, {}{}{} in {}{}", counted(worse.size(), "regression"), in_brackets(worse),
                     counted(better.size(), "improvement"), in_brackets(better), unclear,
                     counted(comparison.compared_cells, "cell"),
                     is_refused ? "; times were not compared: the machines differ" : "");
}

std::string verdict_line(const Settled& settled) {
  std::string line = settled.in_turn ? verdict_line(*settled.in_turn) + " run in turn" : verdict_line(settled.folders);
  std::vector<std::string> worse;
  for (const ExactFinding& finding : settled.folders.findings) {
    if (finding.is_regression && finding.is_confirmed && !finding.depends_on_speed)
      worse.push_back(fmt::format("{} on {}: {}", algorithm_label(finding.cell), place_of(finding), finding.text));
  }
  if (settled.in_turn && !worse.empty())
    line += "; before: " + counted(worse.size(), "regression") + in_brackets(worse);
  if (!settled.not_run.empty())
    line += "; not run in turn, for the study does not have them: " + counted(settled.not_run.size(), "cell") +
            in_brackets(labels_of(settled.not_run));
  return line;
}

std::string comparison_text(const Comparison& comparison, bool every_cell) {
  return text_of(comparison, listed_cells(every_cell));
}

std::string comparison_markdown(const Comparison& comparison, bool every_cell) {
  return markdown_of(comparison, listed_cells(every_cell));
}

std::string comparison_json(const Comparison& comparison) { return json_of(comparison).dump(1) + '\n'; }

std::string settled_text(const Settled& settled, bool every_cell) {
  return fmt::format("{}: {}\n\n{}", name_of(settled.outcome()), verdict_line(settled),
                     both_texts(settled, every_cell, kInTurn, text_of));
}

std::string settled_markdown(const Settled& settled, bool every_cell) {
  return fmt::format("**{}**: {}\n\n{}", name_of(settled.outcome()), verdict_line(settled),
                     both_texts(settled, every_cell, std::string("## ") + kInTurn, markdown_of));
}

std::string settled_json(const Settled& settled) {
  Json object = {{"outcome", name_of(settled.outcome())},
                 {"verdict", verdict_line(settled)},
                 {"regression", settled.outcome() == Outcome::regression},
                 {"suspected", json_of(settled.folders)},
                 {"confirmed", nullptr},
                 {"not_run", labels_of(settled.not_run)}};
  if (settled.in_turn) object["confirmed"] = json_of(*settled.in_turn);
  return object.dump(1) + '\n';
}

}  // namespace mwt
