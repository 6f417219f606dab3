#include "harness/yardstick.h"

#include <numeric>
#include <vector>

#include "geometry/delaunay.h"
#include "harness/study/summary.h"

namespace mwt {

namespace {

constexpr std::size_t kMeasurements = 7;
constexpr double kEnoughTime = 0.5;

}  // namespace

double yardstick_time_s(Points points) {
  std::vector<double> times;
  do {
    times.push_back(measure_yardstick_s(points));
  } while (times.size() < kMeasurements && std::accumulate(times.begin(), times.end(), 0.0) < kEnoughTime);
  return median(times);
}

}  // namespace mwt
