#include "harness/study/estimate/time_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

// Factors between what was observed and what a run may take: judgement, held against runs of the study `report`.
constexpr double kSameCell = 1.5;
constexpr double kBetweenSizes = 2;
constexpr double kBeyondSizes = 2;  // times n's ratio to the power kDrift
constexpr double kDrift = 0.25;
constexpr double kOtherFamily = 3;
constexpr double kOtherVariant = 6;
constexpr double kShortest = 1e-6;  // s

TimePrediction within(double seconds, double factor, TimeBasis basis, double limit_s) {
  const double capped = std::min(seconds, limit_s);
  return {capped, std::min(seconds / factor, limit_s), std::min(seconds * factor, limit_s), basis};
}

// The size's median time, and whether a run met its limit there.
struct SizeTime {
  Index n = 0;
  double seconds = 0;
  bool at_limit = false;
  bool is_record = false;
};

SizeTime time_of(const std::pair<const Index, std::vector<TimeObservation>>& size) {
  const auto& [n, observations] = size;
  std::vector<double> seconds;
  SizeTime time{n, 0, false, false};
  for (const TimeObservation& observation : observations) {
    seconds.push_back(std::max(observation.seconds, kShortest));
    time.at_limit = time.at_limit || observation.at_limit;
    time.is_record = time.is_record || observation.is_record;
  }
  time.seconds = median(seconds);
  return time;
}

// It takes at least what was observed, and at most what it gets.
TimePrediction at_limit(double observed, double limit_s, TimeBasis basis) {
  const double least = std::min(observed, limit_s);
  return {std::sqrt(least * limit_s), least, limit_s, basis};
}

TimePrediction same_cell(const SizeTime& time, double limit_s) {
  const TimeBasis basis = time.is_record ? TimeBasis::recorded : TimeBasis::measured;
  if (time.at_limit && time.seconds < limit_s) return at_limit(time.seconds, limit_s, basis);
  return within(time.seconds, kSameCell, basis, limit_s);
}

double slope(const SizeTime& a, const SizeTime& b) {
  return std::log(b.seconds / a.seconds) / std::log(static_cast<double>(b.n) / static_cast<double>(a.n));
}

double grown(const SizeTime& from, Index n, double exponent) {
  return from.seconds * std::pow(static_cast<double>(n) / static_cast<double>(from.n), exponent);
}

// Grows on from the largest size observed, at least linearly. Where times are tiny or sizes close together, noise would
// make any exponent: it is kept within what most heuristics have.
TimePrediction beyond(const SizeTime& last, const std::optional<SizeTime>& before, Index n, double limit_s) {
  constexpr double kTellingTime = 1e-4;  // s
  constexpr double kTellingRatio = 1.3;
  const bool is_telling = before && last.seconds >= kTellingTime && last.n >= kTellingRatio * before->n;
  const double exponent = std::max(1.0, before ? slope(*before, last) : 1.0);
  const double ratio = static_cast<double>(n) / static_cast<double>(last.n);
  const double factor = kBeyondSizes * std::pow(ratio, is_telling ? kDrift : 2 * kDrift);
  return within(grown(last, n, is_telling ? exponent : std::min(exponent, 1.5)), factor, TimeBasis::other_sizes,
                limit_s);
}

std::string_view without_parameters(std::string_view name) { return name.substr(0, name.find(' ')); }

// The middle of several predictions, and how far apart they are.
std::optional<TimePrediction> combined(const std::vector<TimePrediction>& predictions, double factor, TimeBasis basis,
                                       double limit_s) {
  if (predictions.empty()) return std::nullopt;
  std::vector<double> seconds;
  for (const TimePrediction& prediction : predictions) seconds.push_back(prediction.seconds);
  TimePrediction result = within(median(seconds), factor, basis, limit_s);
  result.low = std::min(result.low, quantile(seconds, 0.1));
  result.high = std::min(limit_s, std::max(result.high, quantile(seconds, 0.9)));
  return result;
}

}  // namespace

std::optional<double> undisturbed_time_s(const RatedRun& run, int threads) {
  constexpr double kLongEnough = 0.005;
  if (!run.wall_time_s || !std::isfinite(*run.wall_time_s)) return std::nullopt;
  const bool is_disturbed = threads == 1 && run.cpu_time_s && *run.wall_time_s > kLongEnough;
  return is_disturbed ? std::min(*run.wall_time_s, std::max(*run.cpu_time_s, kLongEnough)) : *run.wall_time_s;
}

void TimeModel::add(const TimedCell& cell, const TimeObservation& observation) {
  algorithms_[cell.algorithm][cell.family][cell.n].push_back(observation);
}

std::optional<TimePrediction> TimeModel::within_family(const Sizes& sizes, Index n, double limit_s) {
  if (sizes.empty()) return std::nullopt;
  const auto here = sizes.find(n);
  if (here != sizes.end()) return same_cell(time_of(*here), limit_s);
  const auto above = sizes.upper_bound(n);
  const TimeBasis basis = TimeBasis::other_sizes;
  if (above == sizes.begin()) {
    const SizeTime smallest = time_of(*above);
    return within(grown(smallest, n, 1), kBetweenSizes, basis, limit_s);
  }
  const auto below = std::prev(above);
  const SizeTime last = time_of(*below);
  if (last.at_limit) return at_limit(last.seconds, limit_s, basis);
  if (above != sizes.end()) {
    const SizeTime next = time_of(*above);
    return within(grown(last, n, slope(last, next)), kBetweenSizes, basis, limit_s);
  }
  return beyond(last, below == sizes.begin() ? std::nullopt : std::optional(time_of(*std::prev(below))), n, limit_s);
}

std::optional<TimePrediction> TimeModel::within_algorithm(const Families& families, const std::string& family, Index n,
                                                          double limit_s) {
  const auto own = families.find(family);
  if (own != families.end()) return within_family(own->second, n, limit_s);
  std::vector<TimePrediction> predictions;
  for (const auto& [name, sizes] : families) {
    if (const auto prediction = within_family(sizes, n, limit_s)) predictions.push_back(*prediction);
  }
  return combined(predictions, kOtherFamily, TimeBasis::other_families, limit_s);
}

TimePrediction TimeModel::predict(const TimedCell& cell, double limit_s) const {
  const auto own = algorithms_.find(cell.algorithm);
  if (own != algorithms_.end()) {
    if (const auto prediction = within_algorithm(own->second, cell.family, cell.n, limit_s)) return *prediction;
  }
  std::vector<TimePrediction> predictions;
  for (const auto& [name, families] : algorithms_) {
    if (without_parameters(name) != without_parameters(cell.algorithm)) continue;
    if (const auto prediction = within_algorithm(families, cell.family, cell.n, limit_s))
      predictions.push_back(*prediction);
  }
  const auto of_variants = combined(predictions, kOtherVariant, TimeBasis::other_variants, limit_s);
  return of_variants.value_or(TimePrediction{limit_s, 0, limit_s, TimeBasis::nothing});
}

}  // namespace mwt
