#include "harness/statistics/power_law.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace mwt {

namespace {

using Line = Eigen::Vector2d;  // height at log n = 0, slope

/// Those of the measurements that `chosen` names, as the rows of the least-squares problem.
struct Design {
  Eigen::MatrixX2d matrix;
  Eigen::VectorXd log_y;
};

Design design_of(std::span<const Measurement> measurements, std::span<const std::size_t> chosen) {
  Design design{Eigen::MatrixX2d(chosen.size(), 2), Eigen::VectorXd(chosen.size())};
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    design.matrix(row, 0) = 1;
    design.matrix(row, 1) = std::log(measurements[chosen[i]].n);
    design.log_y(row) = std::log(measurements[chosen[i]].y);
  }
  return design;
}

Line least_squares(const Design& design) { return design.matrix.colPivHouseholderQr().solve(design.log_y); }

constexpr double kConstant = 1e-11;  // of the logarithms

std::optional<double> explained_share(const Design& design, const Line& line) {
  if (design.log_y.maxCoeff() - design.log_y.minCoeff() <= kConstant) return std::nullopt;
  const double all = (design.log_y.array() - design.log_y.mean()).matrix().squaredNorm();
  return 1 - (design.log_y - design.matrix * line).squaredNorm() / all;
}

/// The number of every measurement's group: those with the same n.
std::vector<std::size_t> groups_by_size(std::span<const Measurement> measurements) {
  std::map<double, std::size_t> group_of_n;
  std::vector<std::size_t> groups;
  for (const Measurement& measurement : measurements)
    groups.push_back(group_of_n.emplace(measurement.n, group_of_n.size()).first->second);
  return groups;
}

void require_positive(std::span<const Measurement> measurements) {
  const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
  for (const Measurement& measurement : measurements) {
    if (!is_positive(measurement.n) || !is_positive(measurement.y))
      throw std::invalid_argument("a power law needs positive finite measurements");
  }
}

/// The least-squares line through the drawn logarithms at log_n. A resample has every group, so at least two log n.
double height_at(std::span<const double> log_n, std::span<const double> log_y, std::span<const std::size_t> drawn,
                 double place) {
  double mean_n = 0, mean_y = 0;
  for (const std::size_t i : drawn) {
    mean_n += log_n[i];
    mean_y += log_y[i];
  }
  mean_n /= static_cast<double>(drawn.size());
  mean_y /= static_cast<double>(drawn.size());
  double products = 0, squares = 0;
  for (const std::size_t i : drawn) {
    products += (log_n[i] - mean_n) * (log_y[i] - mean_y);
    squares += (log_n[i] - mean_n) * (log_n[i] - mean_n);
  }
  return mean_y + products / squares * (place - mean_n);
}

}  // namespace

std::vector<Estimate> power_law_band(std::span<const Measurement> measurements, std::span<const double> places,
                                     const BootstrapOptions& options) {
  require_positive(measurements);
  const std::vector<std::size_t> groups = groups_by_size(measurements);
  const bool has_line = std::ranges::any_of(groups, [](std::size_t group) { return group > 0; });
  if (!has_line) throw std::invalid_argument("a power law needs two sizes");
  std::vector<double> log_n, log_y;
  for (const Measurement& measurement : measurements) {
    log_n.push_back(std::log(measurement.n));
    log_y.push_back(std::log(measurement.y));
  }
  std::vector<Estimate> band;
  for (const double place : places) {
    const auto height = [&](std::span<const std::size_t> drawn) {
      return height_at(log_n, log_y, drawn, std::log(place));
    };
    const Estimate logarithm = bootstrap_over(measurements.size(), height, options, groups);
    band.push_back({std::exp(logarithm.value), std::exp(logarithm.lower), std::exp(logarithm.upper)});
  }
  return band;
}

std::optional<PowerLaw> fit_power_law(std::span<const Measurement> measurements, const BootstrapOptions& options) {
  require_positive(measurements);
  const std::vector<std::size_t> groups = groups_by_size(measurements);
  const std::size_t group_count = groups.empty() ? 0 : *std::max_element(groups.begin(), groups.end()) + 1;
  if (group_count < 2) return std::nullopt;

  std::vector<std::size_t> all(measurements.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto coefficient = [&](Eigen::Index which) {
    return bootstrap_over(
        measurements.size(),
        [&](std::span<const std::size_t> drawn) { return least_squares(design_of(measurements, drawn))(which); },
        options, groups);
  };
  const Design design = design_of(measurements, all);
  PowerLaw law;
  law.log_factor = coefficient(0);
  law.exponent = coefficient(1);
  law.r_squared = explained_share(design, least_squares(design));
  law.has_interval = group_count < measurements.size();
  return law;
}

}  // namespace mwt
