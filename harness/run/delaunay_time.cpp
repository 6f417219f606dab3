#include "harness/run/delaunay_time.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/cpu_clock.h"
#include "geometry/delaunay.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr std::size_t kMeasurements = 7;
constexpr double kEnoughTime = 0.5;

/// One measurement without what other programs took, where it is long enough to have been interrupted; the median takes
/// care of the few shorter ones that were.
double undisturbed_measurement_s(Points points) {
  constexpr double kLongEnough = 0.01;
  const double cpu_start = process_cpu_time_s();
  const double wall = measure_delaunay_time_s(points);
  const double cpu = process_cpu_time_s() - cpu_start;
  return wall < kLongEnough ? wall : std::min(wall, cpu);
}

}  // namespace

double delaunay_time_s(Points points) {
  std::vector<double> times;
  do {
    times.push_back(undisturbed_measurement_s(points));
  } while (times.size() < kMeasurements && std::accumulate(times.begin(), times.end(), 0.0) < kEnoughTime);
  return median(times);
}

}  // namespace mwt
