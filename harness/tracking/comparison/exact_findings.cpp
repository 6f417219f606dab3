#include "harness/tracking/comparison/exact_findings.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/number_text.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

constexpr double kMemorySlack = 4 << 20;  // two huge pages

using Runs = std::vector<const RunRecord*>;

std::string change_text(const std::string& what, double before, double after) {
  return fmt::format("{} {} -> {}", what, number_text(before), number_text(after));
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
  const auto ok = [](const RunRecord* run) { return run->status == RunStatus::ok; };
  if (proved(base) == base.size() && proved(now) == 0 && std::any_of(now.begin(), now.end(), ok))
    findings.push_back({cell, Aspect::quality, true, "the optimum was proved and is not any more", true});
}

/// The runs of a cell that something is wrong with.
struct Share {
  std::size_t count = 0;
  std::size_t runs = 0;
  std::vector<std::string> kinds;  ///< of what is wrong, each once

  void add(const std::optional<std::string>& kind) {
    ++runs;
    if (!kind) return;
    ++count;
    if (std::find(kinds.begin(), kinds.end(), *kind) == kinds.end()) kinds.push_back(*kind);
  }

  [[nodiscard]] std::string text() const {
    if (count == 0) return "none";
    return fmt::format("{} of {} ({})", count, runs, joined(kinds));
  }
};

template <class KindOf>
Share share_of(const Runs& runs, KindOf kind_of) {
  Share share;
  for (const RunRecord* run : runs) share.add(kind_of(*run));
  return share;
}

std::optional<std::string> kind_of_failure(const RunRecord& run) {
  return is_failure(run.status) ? std::optional(std::string(name_of(run.status))) : std::nullopt;
}

std::optional<std::string> kind_of_early_end(const RunRecord& run) {
  const bool is_early = run.status == RunStatus::ok && run.stopped_early.value_or(false);
  return is_early ? std::optional<std::string>("stopped early") : std::nullopt;
}

std::optional<std::string> kind_of_refusal(const RunRecord& run) {
  return run.status == RunStatus::not_applicable ? std::optional(std::string(name_of(run.status))) : std::nullopt;
}

void compare_shares(const TrackedCell& cell, const Share& before, const Share& after, const std::string& what,
                    std::vector<ExactFinding>& findings) {
  const std::size_t share_before = before.count * after.runs;
  const std::size_t share_after = after.count * before.runs;
  if (share_before == share_after) return;
  const bool worse = share_after > share_before;
  const std::vector<std::string>& kinds = worse ? after.kinds : before.kinds;
  const bool depends_on_speed = std::all_of(kinds.begin(), kinds.end(), [](const std::string& kind) {
    return kind == name_of(RunStatus::timeout) || kind == "stopped early";
  });
  findings.push_back({cell, Aspect::failures, worse, fmt::format("{}: {} -> {}", what, before.text(), after.text()),
                      depends_on_speed});
}

void compare_failures(const TrackedCell& cell, const Runs& base, const Runs& now, std::vector<ExactFinding>& findings) {
  const auto compare = [&](const std::string& what, auto kind_of) {
    compare_shares(cell, share_of(base, kind_of), share_of(now, kind_of), what, findings);
  };
  compare("failed runs", kind_of_failure);
  compare("runs that did not end by themselves", kind_of_early_end);
  compare("runs that the algorithm declines", kind_of_refusal);
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
  const auto [min_before, max_before] = std::minmax_element(before.begin(), before.end());
  const auto [min_after, max_after] = std::minmax_element(after.begin(), after.end());
  const bool more = is_clearly_larger(*min_after, *max_before, threshold);
  const bool less = is_clearly_larger(*min_before, *max_after, threshold);
  if (!more && !less) return;
  findings.push_back({cell, Aspect::memory, more,
                      change_text("peak_rss_bytes", typical(memory, base)->value, typical(memory, now)->value)});
}

/// ", most in find_pair +14.0%"; empty without profiles.
std::string place_of_change(const Runs& base, const Runs& now, const Profiles& profiles) {
  const auto first = [](const Runs& runs, const std::function<FunctionCounts(const RunRecord&)>& profile_of) {
    for (const RunRecord* run : runs) {
      FunctionCounts functions = profile_of ? profile_of(*run) : FunctionCounts{};
      if (!functions.empty()) return functions;
    }
    return FunctionCounts{};
  };
  const auto changed = most_changed(first(base, profiles.base), first(now, profiles.now));
  return changed ? ", most in " + changed->text() : "";
}

/// Whether they are equal but for the threshold is decided by the extremes: two runs of one program hardly differ.
void compare_counts(const TrackedCell& cell, const Runs& base, const Runs& now, const Profiles& profiles,
                    std::vector<ExactFinding>& findings) {
  for (const char* name : kComparedCounts) {
    const Measure& measure = measure_named(name);
    const std::vector<double> before = values_of(measure, base), after = values_of(measure, now);
    if (before.empty() || after.empty()) continue;
    const bool more = std::ranges::min(after) > std::ranges::max(before) * (1 + kCountThreshold);
    const bool less = std::ranges::min(before) > std::ranges::max(after) * (1 + kCountThreshold);
    if (!more && !less) return;
    const double a = typical(measure, base)->value, b = typical(measure, now)->value;
    ExactFinding finding{
        cell, Aspect::counts, more,
        fmt::format("{} {:.0f} -> {:.0f} (x{:.4f}){}", name, a, b, b / a,
                    std::string(name).starts_with("callgrind") ? place_of_change(base, now, profiles) : "")};
    finding.is_confirmed = before.size() > 1 && after.size() > 1;
    findings.push_back(std::move(finding));
    return;
  }
}

}  // namespace

std::vector<ExactFinding> exact_findings(const TrackedCell& cell, const Runs& base, const Runs& now, double threshold,
                                         const Profiles& profiles) {
  std::vector<ExactFinding> findings;
  compare_quality(cell, base, now, findings);
  compare_failures(cell, base, now, findings);
  compare_memory(cell, base, now, threshold, findings);
  compare_counts(cell, base, now, profiles, findings);
  return findings;
}

}  // namespace mwt
