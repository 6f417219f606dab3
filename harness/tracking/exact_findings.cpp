#include "harness/tracking/exact_findings.h"

#include <algorithm>
#include <map>
#include <optional>

#include "geometry/number_text.h"
#include "harness/text.h"

namespace mwt {

namespace {

constexpr double kMemorySlack = 4 << 20;  // two huge pages

using Runs = std::vector<const RunRecord*>;

std::string change_text(const std::string& what, double before, double after) {
  return what + ' ' + number_text(before) + " -> " + number_text(after);
}

/// The certified interval that holds the weights of all repeatable runs; nothing if there is none.
std::optional<Interval> weights_of(const Runs& runs) {
  std::optional<Interval> all;
  for (const RunRecord* run : runs) {
    if (run->status != RunStatus::ok || run->stopped_early.value_or(false)) continue;
    if (!run->weight_lower || !run->weight_upper) continue;
    if (!all) all = Interval{*run->weight_lower, *run->weight_upper};
    all->lower = std::min(all->lower, *run->weight_lower);
    all->upper = std::max(all->upper, *run->weight_upper);
  }
  return all;
}

std::size_t proved(const Runs& runs) {
  return static_cast<std::size_t>(
      std::count_if(runs.begin(), runs.end(), [](const RunRecord* run) { return run->optimality == "proved"; }));
}

void compare_quality(const TrackedCell& cell, const Runs& base, const Runs& now, std::vector<ExactFinding>& findings) {
  const auto before = weights_of(base);
  const auto after = weights_of(now);
  if (before && after && (after->lower > before->upper || after->upper < before->lower)) {
    const Measure& alpha = measure_named("alpha");
    const auto alpha_before = typical(alpha, base);
    const auto alpha_after = typical(alpha, now);
    const std::string text = alpha_before && alpha_after ? change_text("alpha", alpha_before->value, alpha_after->value)
                                                         : change_text("weight", before->middle(), after->middle());
    findings.push_back({cell, Aspect::quality, after->lower > before->upper, text});
  }
  if (proved(base) == base.size() && proved(now) == 0 && after)
    findings.push_back({cell, Aspect::quality, true, "the optimum was proved and is not any more"});
}

struct Failures {
  std::size_t count = 0;
  std::size_t runs = 0;
  std::string statuses;

  explicit Failures(const Runs& all) : runs(all.size()) {
    std::vector<std::string> names;
    for (const RunRecord* run : all) {
      if (!is_failure(run->status)) continue;
      ++count;
      const std::string name(name_of(run->status));
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    statuses = joined(names);
  }

  [[nodiscard]] std::string text() const {
    if (count == 0) return "none";
    return std::to_string(count) + " of " + std::to_string(runs) + " (" + statuses + ")";
  }
};

void compare_failures(const TrackedCell& cell, const Runs& base, const Runs& now, std::vector<ExactFinding>& findings) {
  const Failures before(base);
  const Failures after(now);
  const std::size_t share_before = before.count * after.runs;
  const std::size_t share_after = after.count * before.runs;
  if (share_before == share_after) return;
  findings.push_back(
      {cell, Aspect::failures, share_after > share_before, "failed runs: " + before.text() + " -> " + after.text()});
}

bool is_clearly_larger(double larger, double smaller, double threshold) {
  return larger > smaller * (1 + threshold) + kMemorySlack;
}

void compare_memory(const TrackedCell& cell, const Runs& base, const Runs& now, double threshold,
                    std::vector<ExactFinding>& findings) {
  const Measure& memory = measure_named("peak_rss_bytes");
  const std::vector<double> before = values_of(memory, base);
  const std::vector<double> after = values_of(memory, now);
  if (before.empty() || after.empty()) return;
  const auto [least_before, most_before] = std::minmax_element(before.begin(), before.end());
  const auto [least_after, most_after] = std::minmax_element(after.begin(), after.end());
  const bool more = is_clearly_larger(*least_after, *most_before, threshold);
  const bool less = is_clearly_larger(*least_before, *most_after, threshold);
  if (!more && !less) return;
  findings.push_back({cell, Aspect::memory, more,
                      change_text("peak_rss_bytes", typical(memory, base)->value, typical(memory, now)->value)});
}

}  // namespace

std::vector<ExactFinding> exact_findings(const TrackedCell& cell, const Runs& base, const Runs& now, double threshold) {
  std::vector<ExactFinding> findings;
  compare_quality(cell, base, now, findings);
  compare_failures(cell, base, now, findings);
  compare_memory(cell, base, now, threshold, findings);
  return findings;
}

}  // namespace mwt
