#include "harness/statistics/lack_of_fit.h"

#include <Eigen/QR>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

/// The measurements of one size, as logarithms.
struct Group {
  double log_n = 0;
  std::vector<double> log_y;

  [[nodiscard]] double middle() const { return median(log_y); }

  /// Sum of the squared distances from the mean.
  [[nodiscard]] double scatter() const {
    const Eigen::Map<const Eigen::ArrayXd> values(log_y.data(), static_cast<Eigen::Index>(log_y.size()));
    return (values - values.mean()).square().sum();
  }

  /// One over the variance of the median, in units of that of a measurement.
  [[nodiscard]] double precision() const {
    const auto count = static_cast<double>(log_y.size());
    return log_y.size() <= 2 ? count : count * 2 / std::numbers::pi;
  }
};

std::vector<Group> groups_of(std::span<const Measurement> measurements) {
  std::map<double, Group> by_n;
  for (const Measurement& measurement : measurements) {
    Group& group = by_n[measurement.n];
    group.log_n = std::log(measurement.n);
    group.log_y.push_back(std::log(measurement.y));
  }
  std::vector<Group> groups;
  for (auto& [n, group] : by_n) groups.push_back(std::move(group));
  return groups;
}

/// What the best polynomial of this degree in log n leaves of the medians: the weighted sum of squares.
double left_by_polynomial(const std::vector<Group>& groups, int degree) {
  const auto rows = static_cast<Eigen::Index>(groups.size());
  Eigen::MatrixXd matrix(rows, degree + 1);
  Eigen::VectorXd medians(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const Group& group = groups[static_cast<std::size_t>(row)];
    const double weight = std::sqrt(group.precision());
    for (Eigen::Index power = 0; power <= degree; ++power)
      matrix(row, power) = weight * std::pow(group.log_n, static_cast<double>(power));
    medians(row) = weight * group.middle();
  }
  const Eigen::VectorXd coefficients = matrix.colPivHouseholderQr().solve(medians);
  return (medians - matrix * coefficients).squaredNorm();
}

/// P(F >= f) for f = (explained / its degrees) / (noise / its degrees). Without noise any rest is one too many, but for
/// the rounding of logarithms.
double f_test(double explained, std::size_t explained_degrees, double noise, std::size_t noise_degrees) {
  constexpr double kRounding = 1e-24;
  if (explained <= kRounding) return 1;
  if (noise <= 0) return 0;
  const auto first = static_cast<double>(explained_degrees), second = static_cast<double>(noise_degrees);
  const double f = (explained / first) / (noise / second);
  return boost::math::cdf(boost::math::complement(boost::math::fisher_f_distribution<>(first, second), f));
}

std::optional<double> p_value_of(const std::vector<Group>& groups, std::size_t measurements) {
  const std::size_t sizes = groups.size();
  if (measurements > sizes && sizes >= 3) {
    double scatter = 0;
    for (const Group& group : groups) scatter += group.scatter();
    return f_test(left_by_polynomial(groups, 1), sizes - 2, scatter, measurements - sizes);
  }
  if (sizes < 4) return std::nullopt;
  const double by_line = left_by_polynomial(groups, 1), by_parabola = left_by_polynomial(groups, 2);
  return f_test(std::max(0.0, by_line - by_parabola), 1, by_parabola, sizes - 3);
}

}  // namespace

LackOfFit test_lack_of_fit(std::span<const Measurement> measurements, const PowerLaw& law) {
  const std::vector<Group> groups = groups_of(measurements);
  LackOfFit result;
  for (const Group& group : groups) {
    const double misfit = std::fabs(group.middle() - law.log_factor.value - law.exponent.value * group.log_n);
    result.max_misfit = std::max(result.max_misfit, std::exp(misfit));
  }
  result.p_value = p_value_of(groups, measurements.size());
  return result;
}

}  // namespace mwt
