#include "harness/tracking/history/changes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "harness/io/text/text.h"
#include "harness/run/callgrind/profile.h"
#include "harness/statistics/change_points.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr double kNoiseOfTime = 0.005;  // at least, relatively
constexpr double kNoiseOfMemory = 0.002;
constexpr double kSameQuality = 1e-9;
constexpr std::size_t kNightsApart = 2;

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(std::log(value));
  return result;
}

/// Logarithms relative to the first value, rounded to what counts as a difference.
std::vector<double> rounded_logarithms(const std::vector<double>& values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(std::round(std::log(value / values.front()) / kSameQuality));
  return result;
}

std::vector<Step> steps_of(const Series& series, Aspect aspect) {
  switch (aspect) {
    case Aspect::time: return find_steps(logarithms(series.values), {.min_noise = kNoiseOfTime});
    case Aspect::memory: return find_steps(logarithms(series.values), {.min_noise = kNoiseOfMemory});
    case Aspect::quality: return find_exact_steps(rounded_logarithms(series.values));
    case Aspect::failures: return find_exact_steps(series.values);
    case Aspect::counts: return find_steps_beyond(logarithms(series.values), std::log1p(kCountThreshold));
  }
  return {};
}

double level(const Series& series, std::size_t begin, std::size_t end) {
  return median(std::span(series.values).subspan(begin, end - begin));
}

bool is_worth_telling(const SeriesStep& step, Aspect aspect, const ChangeOptions& options) {
  if (aspect == Aspect::quality || aspect == Aspect::failures) return true;
  if (aspect == Aspect::counts) return std::fabs(std::log(step.after / step.before)) > std::log1p(kCountThreshold);
  return std::fabs(std::log(step.after / step.before)) >= std::log1p(options.min_change);
}

std::vector<SeriesStep> series_steps(const Series& series, Aspect aspect, const ChangeOptions& options) {
  const std::vector<Step> found = steps_of(series, aspect);
  std::vector<SeriesStep> steps;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t begin = i == 0 ? 0 : found[i - 1].first;
    const std::size_t end = i + 1 < found.size() ? found[i + 1].first : series.values.size();
    const std::size_t first = found[i].first;
    const SeriesStep step{series.key,
                          series.nightly_runs[first],
                          series.nightly_runs[first - 1],
                          level(series, begin, first),
                          level(series, first, end),
                          found[i].error};
    if (is_worth_telling(step, aspect, options)) steps.push_back(step);
  }
  return steps;
}

/// Which series are looked at: of the times only one measure, and of the counts.
class SeriesChoice {
 public:
  explicit SeriesChoice(const std::vector<Series>& all) {
    for (const Series& series : all) {
      measures_of_[{series.key.study, series.key.environment}].insert(series.key.measure);
    }
  }

  [[nodiscard]] bool has(const SeriesKey& key) const {
    const std::set<std::string>& measures = measures_of_.at({key.study, key.environment});
    switch (measure_named(key.measure).aspect) {
      case Aspect::time: return key.measure == (measures.contains("relative_time") ? "relative_time" : "wall_time_s");
      case Aspect::counts: {
        const auto compared =
            std::ranges::find_if(kComparedCounts, [&](const char* name) { return measures.contains(name); });
        return compared != std::end(kComparedCounts) && key.measure == *compared;
      }
      default: return true;
    }
  }

 private:
  std::map<std::pair<std::string, std::string>, std::set<std::string>> measures_of_;
};

/// What steps have in common that may make one change.
using ChangeKey = std::tuple<std::string, std::string, std::string, Aspect, bool>;

/// Consecutive steps that are at most kNightsApart apart. Precondition: ordered by nightly run.
std::vector<std::vector<SeriesStep>> groups_in_time(const std::vector<SeriesStep>& steps) {
  std::vector<std::vector<SeriesStep>> groups;
  for (const SeriesStep& step : steps) {
    if (groups.empty() || step.nightly_run > groups.back().back().nightly_run + kNightsApart) groups.emplace_back();
    groups.back().push_back(step);
  }
  return groups;
}

void choose_nightly_run(Change& change) {
  std::map<std::size_t, std::size_t> votes;
  for (const SeriesStep& step : change.steps) ++votes[step.nightly_run];
  const auto chosen =
      std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  change.nightly_run = chosen->first;
  for (const SeriesStep& step : change.steps) {
    if (step.nightly_run == change.nightly_run)
      change.previous_nightly_run = std::max(change.previous_nightly_run, step.previous_nightly_run);
  }
}

Change change_of(const ChangeKey& key, std::vector<SeriesStep> steps) {
  Change change;
  std::tie(change.study, change.environment, change.algorithm, change.aspect, change.is_regression) = key;
  change.steps = std::move(steps);
  choose_nightly_run(change);
  double sum = 0;
  for (const SeriesStep& step : change.steps)
    sum += change.aspect == Aspect::failures ? step.after - step.before : std::log(step.after / step.before);
  const double mean = sum / static_cast<double>(change.steps.size());
  change.factor = change.aspect == Aspect::failures ? mean : std::exp(mean);
  change.lower = change.upper = change.factor;
  if (change.aspect != Aspect::time && change.aspect != Aspect::memory) return change;
  double error = 0;
  for (const SeriesStep& step : change.steps) error += step.log_error / static_cast<double>(change.steps.size());
  constexpr double kErrors = 1.96;
  change.lower = std::exp(mean - kErrors * error);
  change.upper = std::exp(mean + kErrors * error);
  return change;
}

/// The instructions of the steps' cells in the nightly runs before and after, function by function.
std::string changed_function(const Change& change, const std::vector<NightlyRun>& nightly_runs) {
  FunctionCounts before, after;
  for (const SeriesStep& step : change.steps) {
    const auto add = [&step](const NightlyRun& nightly_run, FunctionCounts& functions) {
      for (const NightlyFunction& function : nightly_run.functions) {
        if (function.cell == step.key.cell) functions[function.name] += function.instructions;
      }
    };
    add(nightly_runs[step.previous_nightly_run], before);
    add(nightly_runs[step.nightly_run], after);
  }
  const auto changed = most_changed(before, after);
  return changed ? changed->text() : "";
}

std::string amount(const Change& change) {
  const std::string sign = change.is_regression ? "+" : "";
  if (change.aspect == Aspect::failures) return sign + fixed(100 * change.factor, 0) + "% of runs";
  if (change.aspect == Aspect::quality) return sign + fixed(100 * (change.factor - 1), 6) + '%';
  if (change.aspect == Aspect::counts) return fmt::format("x{:.4f}", change.factor);
  return fmt::format("x{:.3f} ({:.3f} .. {:.3f})", change.factor, change.lower, change.upper);
}

std::string where(const Change& change) {
  std::vector<std::string> places;
  for (const SeriesStep& step : change.steps) {
    const TrackedCell& cell = step.key.cell;
    const std::string place = fmt::format("{} n={}", family_label(cell), cell.n);
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  }
  constexpr std::size_t kNamed = 4;
  const std::size_t more = places.size() > kNamed ? places.size() - kNamed : 0;
  places.resize(places.size() - more);
  return joined(places) + (more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string short_commit(const std::string& commit) { return commit.substr(0, 10); }

}  // namespace

std::vector<Change> find_changes(const std::vector<NightlyRun>& nightly_runs, const ChangeOptions& options) {
  const std::vector<Series> all = series_of(nightly_runs);
  const SeriesChoice choice(all);
  std::map<ChangeKey, std::vector<SeriesStep>> steps_by_key;
  for (const Series& series : all) {
    if (!choice.has(series.key)) continue;
    const Aspect aspect = measure_named(series.key.measure).aspect;
    for (const SeriesStep& step : series_steps(series, aspect, options)) {
      const bool is_regression = step.after > step.before;
      steps_by_key[{step.key.study, step.key.environment, algorithm_label(step.key.cell), aspect, is_regression}]
          .push_back(step);
    }
  }
  std::vector<Change> changes;
  for (auto& [key, steps] : steps_by_key) {
    std::stable_sort(steps.begin(), steps.end(),
                     [](const SeriesStep& a, const SeriesStep& b) { return a.nightly_run < b.nightly_run; });
    for (auto& group : groups_in_time(steps)) {
      Change& change = changes.emplace_back(change_of(key, std::move(group)));
      if (change.aspect == Aspect::counts) change.function = changed_function(change, nightly_runs);
    }
  }
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
    return std::tuple(a.nightly_run, !a.is_regression, a.algorithm) <
           std::tuple(b.nightly_run, !b.is_regression, b.algorithm);
  });
  return changes;
}

std::string describe(const Change& change, const std::vector<NightlyRun>& nightly_runs) {
  const NightlyRun& nightly_run = nightly_runs[change.nightly_run];
  return fmt::format("{} {}{}: {} {} on {}{} ({}..{})", nightly_run.recorded_at.substr(0, 10),
                     change.is_regression ? "regression " : "improvement ", change.algorithm, name_of(change.aspect),
                     amount(change), where(change), change.function.empty() ? "" : ", most in " + change.function,
                     short_commit(nightly_runs[change.previous_nightly_run].git_commit),
                     short_commit(nightly_run.git_commit));
}

}  // namespace mwt
