#include "harness/run/delaunay_time.h"

#include <numeric>
#include <vector>

#include "geometry/delaunay.h"
#include "harness/run/branch_history.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

constexpr std::size_t kMeasurements = 15;
constexpr double kEnoughTime = 0.5;

}  // namespace

double delaunay_time_s(Points points) {
  std::vector<double> times;
  BranchHistory history;
  do {
    history.overwrite();
    times.push_back(time_delaunay_once_s(points));
  } while (times.size() < kMeasurements && std::accumulate(times.begin(), times.end(), 0.0) < kEnoughTime);
  return median(times);
}

}  // namespace mwt
