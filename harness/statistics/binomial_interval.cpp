#include "harness/statistics/binomial_interval.h"

#include <boost/math/distributions/beta.hpp>
#include <stdexcept>

namespace mwt {

ProbabilityInterval clopper_pearson(std::uint64_t successes, std::uint64_t trials, double confidence) {
  if (successes > trials) throw std::invalid_argument("more successes than trials");
  if (!(confidence > 0 && confidence < 1)) throw std::invalid_argument("a confidence lies between 0 and 1");
  const double outside = (1 - confidence) / 2;
  const double good = static_cast<double>(successes);
  const double bad = static_cast<double>(trials - successes);
  ProbabilityInterval interval;
  if (successes > 0) interval.lower = boost::math::quantile(boost::math::beta_distribution<>(good, bad + 1), outside);
  if (successes < trials) {
    interval.upper =
        boost::math::quantile(boost::math::complement(boost::math::beta_distribution<>(good + 1, bad), outside));
  }
  return interval;
}

}  // namespace mwt
