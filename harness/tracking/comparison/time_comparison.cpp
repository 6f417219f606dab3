#include "harness/tracking/comparison/time_comparison.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "harness/statistics/quantile.h"
#include "harness/statistics/rank_tests.h"
#include "harness/statistics/shift.h"

namespace mwt {

namespace {

/// Every value times `sign`, less `offset`.
std::vector<double> moved(const std::vector<double>& values, double sign, double offset) {
  std::vector<double> result;
  for (const double value : values) result.push_back(sign * value - offset);
  return result;
}

Estimate exponential(const Estimate& estimate) {
  return {std::exp(estimate.value), std::exp(estimate.lower), std::exp(estimate.upper)};
}

/// The standard deviation of the values' bulk, were it normal.
double robust_deviation(const std::vector<double>& values) {
  const double middle = median(values);
  std::vector<double> distances;
  for (const double value : values) distances.push_back(std::fabs(value - middle));
  constexpr double kDeviationsPerMedian = 1.4826022185056018;  // 1 / the 75% quantile of the standard normal
  return kDeviationsPerMedian * median(distances);
}

/// P(T >= t) for a heavy-tailed T; 1 or 0 where nothing scatters.
double heavy_upper_tail(double excess, double deviation) {
  if (deviation == 0) return excess > 0 ? 0 : 1;
  return boost::math::cdf(boost::math::complement(boost::math::students_t_distribution<>(3), excess / deviation));
}

}  // namespace

TimeJudgement judge_log_ratios(const std::vector<double>& log_ratios, double threshold) {
  const double least = std::log1p(threshold);
  return {exponential(bootstrap_pseudo_median(log_ratios)), signed_rank_p_value(moved(log_ratios, 1, least)),
          signed_rank_p_value(moved(log_ratios, -1, least)), signed_rank_p_value(moved(log_ratios, -1, -least)),
          signed_rank_p_value(moved(log_ratios, 1, -least))};
}

TimeJudgement judge_log_times(const std::vector<double>& base, const std::vector<double>& now, double threshold) {
  const double least = std::log1p(threshold);
  return {exponential(bootstrap_shift(base, now)), rank_sum_p_value(base, moved(now, 1, least)),
          rank_sum_p_value(now, moved(base, 1, least)), rank_sum_p_value(now, moved(base, 1, -least)),
          rank_sum_p_value(base, moved(now, 1, -least))};
}

void require_standing_out(TimeJudgement& judgement, const std::vector<double>& log_ratios_of_all, double threshold) {
  const double least = std::log1p(threshold);
  const double deviation = robust_deviation(log_ratios_of_all);
  const double own = std::log(judgement.ratio.value);
  judgement.p_slower = std::max(judgement.p_slower, heavy_upper_tail(own - least, deviation));
  judgement.p_faster = std::max(judgement.p_faster, heavy_upper_tail(-own - least, deviation));
  judgement.p_not_slower = std::max(judgement.p_not_slower, heavy_upper_tail(least - own, deviation));
  judgement.p_not_faster = std::max(judgement.p_not_faster, heavy_upper_tail(least + own, deviation));
}

void require_difference_from_others(TimeJudgement& judgement, const std::vector<double>& own,
                                    const std::vector<double>& others, double threshold) {
  if (others.empty()) return;
  const double least = std::log1p(threshold);
  judgement.p_slower = std::max(judgement.p_slower, rank_sum_p_value(others, moved(own, 1, least)));
  judgement.p_faster = std::max(judgement.p_faster, rank_sum_p_value(moved(own, 1, -least), others));
}

}  // namespace mwt
