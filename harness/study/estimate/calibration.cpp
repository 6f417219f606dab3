#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "harness/rating/isolated_run.h"
#include "harness/study/estimate/estimate.h"

namespace mwt {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongestStep = 0.3;  // s: a cell that is predicted to take longer is not tried
constexpr double kLimit = 1;          // s

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// The sizes of an algorithm on a family, from small to large.
struct Series {
  std::vector<const PlannedWork*> sizes;
  std::size_t next = 0;  // the smallest size worth trying
  double doubt_s = 0;    // how far apart the ends of its prediction are

  [[nodiscard]] bool is_exhausted() const { return next == sizes.size(); }
};

class Calibration {
 public:
  Calibration(TimeModel& model, const Study& study, const Plan& plan, const std::vector<PlannedWork>& work)
      : model_(model), study_(study), plan_(plan) {
    std::map<std::pair<std::string, std::string>, std::vector<const PlannedWork*>> series;
    for (const PlannedWork& item : work) {
      if (!item.has_start_file) series[{item.cell.algorithm, item.cell.family}].push_back(&item);
    }
    for (auto& [name, sizes] : series) {
      std::sort(sizes.begin(), sizes.end(),
                [](const PlannedWork* a, const PlannedWork* b) { return a->cell.n < b->cell.n; });
      series_.push_back({std::move(sizes)});
      assess(series_.back());
    }
  }

  std::size_t run(double budget_s) {
    const Clock::time_point begin = Clock::now();
    while (seconds_since(begin) < budget_s) {
      const auto worst = std::max_element(series_.begin(), series_.end(),
                                          [](const Series& a, const Series& b) { return a.doubt_s < b.doubt_s; });
      if (worst == series_.end() || worst->doubt_s <= 0) break;
      try_next(*worst);
      const std::string algorithm = worst->sizes.front()->cell.algorithm;
      for (Series& series : series_) {
        if (series.sizes.front()->cell.algorithm == algorithm) assess(series);
      }
    }
    return runs_;
  }

 private:
  void assess(Series& series) const {
    series.doubt_s = 0;
    if (series.is_exhausted()) return;
    for (const PlannedWork* item : series.sizes) {
      const TimePrediction prediction = model_.predict(item->cell, item->limit_s);
      if (prediction.basis <= TimeBasis::measured) continue;
      series.doubt_s += static_cast<double>(item->count) * (prediction.high - prediction.low);
    }
  }

  // The largest size that is predicted to be quick, or the smallest without any observation.
  void try_next(Series& series) {
    std::size_t chosen = series.next;
    for (std::size_t i = series.next; i < series.sizes.size(); ++i) {
      const TimePrediction prediction = model_.predict(series.sizes[i]->cell, kLimit);
      const bool is_known = prediction.basis < TimeBasis::other_variants;
      if (is_known && prediction.high <= kLongestStep) chosen = i;
    }
    const PlannedWork& item = *series.sizes[chosen];
    const TimePrediction prediction = model_.predict(item.cell, kLimit);
    series.next = chosen + 1;
    const bool is_too_long = prediction.basis < TimeBasis::nothing && prediction.seconds > kLongestStep;
    if (is_too_long) series.next = series.sizes.size();
    if (is_too_long || prediction.basis <= TimeBasis::measured) return;
    if (!measure(item)) series.next = series.sizes.size();
  }

  // False if larger sizes would take longer still or fail, too.
  bool measure(const PlannedWork& item) {
    ++runs_;
    std::optional<Instance> instance;
    try {
      const PlannedInstance& planned = plan_.instances[item.instance];
      instance = make_instance(planned.make_points(), planned.label());
    } catch (const std::exception&) {
      return false;  // the study's rows will say so
    }
    Request request;
    request.algorithm = item.algorithm;
    request.parameters = item.parameters;
    request.threads = study_.threads;
    request.time_limit_s = kLimit;
    RunLimits limits = study_.limits;
    limits.time_s = kLimit;
    limits.grace_s = kLimit;
    RatedRun result;
    ProcessPool pool(1);
    start_isolated_run(pool, request, *instance, limits, {1e-9, false}, [&](RatedRun run) { result = std::move(run); });
    while (!pool.is_empty()) pool.wait(std::chrono::milliseconds(100));
    const bool at_limit = result.status == RunStatus::timeout || result.stopped_early.value_or(false);
    if (result.status == RunStatus::ok || at_limit) {
      model_.add(item.cell, {undisturbed_time_s(result, request.threads).value_or(2 * kLimit), at_limit, false});
    } else {
      model_.add(item.cell, {0, false, false});  // it will fail or be refused in the study as well
    }
    return !at_limit;
  }

  TimeModel& model_;
  const Study& study_;
  const Plan& plan_;
  std::vector<Series> series_;
  std::size_t runs_ = 0;
};

}  // namespace

std::size_t calibrate(TimeModel& model, const Study& study, const Plan& plan, const std::vector<PlannedWork>& work,
                      double budget_s) {
  return Calibration(model, study, plan, work).run(budget_s);
}

}  // namespace mwt
