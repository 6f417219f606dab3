#include "harness/report/failures.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxLines = 50;
constexpr std::size_t kLongestMessage = 300;

// Algorithm, parameters, status, and the message without its numbers.
using Kind = std::tuple<std::string, std::string, RunStatus, std::string>;

struct RunsOfAKind {
  std::size_t count = 0;
  const RunRecord* first = nullptr;

  void add(const RunRecord& run) {
    if (count++ == 0) first = &run;
  }
};

bool is_part_of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; }

// Positions, weights and seeds differ between runs that fail for one reason.
std::string without_numbers(const std::string& message) {
  std::string pattern;
  for (const char c : message) {
    const char shown = is_part_of_number(c) ? '#' : c;
    if (shown != '#' || !pattern.ends_with('#')) pattern += shown;
  }
  return pattern;
}

std::string shortened(const std::string& message) {
  return message.size() <= kLongestMessage ? message : message.substr(0, kLongestMessage) + " ...";
}

std::vector<std::string> row_of(const RunsOfAKind& failures) {
  const RunRecord& run = *failures.first;
  return {name_with_parameters(run.algorithm, run.params), std::string(name_of(run.status)),
          std::to_string(failures.count), label_of_instance(run), shortened(run.message)};
}

}  // namespace

std::string failure_table(const std::vector<RunRecord>& runs) {
  std::map<Kind, RunsOfAKind> kinds;
  for (const RunRecord& run : runs) {
    if (is_failure(run.status)) kinds[{run.algorithm, run.params, run.status, without_numbers(run.message)}].add(run);
  }
  std::vector<RunsOfAKind> ordered;
  for (const auto& [kind, failures] : kinds) ordered.push_back(failures);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const RunsOfAKind& a, const RunsOfAKind& b) { return a.count > b.count; });
  AlignedTable table({"failed", "how", "runs", "first on", "message"}, {1, 3, 4});
  for (std::size_t i = 0; i < std::min(ordered.size(), kMaxLines); ++i) table.add_row(row_of(ordered[i]));
  if (table.is_empty()) return "";
  const std::size_t left_out = ordered.size() - std::min(ordered.size(), kMaxLines);
  return table.text() + (left_out == 0 ? "" : fmt::format("{} more kinds of failure: see runs.csv\n", left_out));
}

std::string stopped_early_table(const std::vector<RunRecord>& runs) {
  std::map<std::pair<std::string, StopReason>, RunsOfAKind> kinds;
  for (const RunRecord& run : runs) {
    if (run.stop_reason) kinds[{run.algorithm, *run.stop_reason}].add(run);
  }
  AlignedTable table({"stopped early", "why", "runs", "first on"}, {1, 3});
  for (const auto& [key, kind] : kinds) {
    table.add_row(
        {key.first, std::string(phrase_of(key.second)), std::to_string(kind.count), label_of_instance(*kind.first)});
  }
  return table.is_empty() ? "" : table.text();
}

}  // namespace mwt
