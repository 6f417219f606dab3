// Instances of TSPLIB whose optima an independent solver found: tsplib/README.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "algorithms/common/testing/solver_testing.h"
#include "geometry/point_set.h"
#include "harness/io/points/point_file.h"

namespace mwt {
namespace {

std::string test_data(const std::string& file) {
  return (std::filesystem::path(MWT_SOURCE_DIR) / "harness/studies/tsplib" / file).string();
}

TEST(TsplibOptima, AreFoundByExact) {
  std::ifstream table(test_data("optima.csv"));
  std::string line;
  std::getline(table, line);
  int instances = 0;
  for (; std::getline(table, line); ++instances) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream row(line);
    std::string name;
    std::size_t distinct = 0, duplicates = 0;
    double lower = 0, upper = 0;
    row >> name >> distinct >> duplicates >> lower >> upper;
    SCOPED_TRACE(name);
    const PointSet set = make_point_set(read_points(test_data(name + ".tsp")), name);
    EXPECT_EQ(set.points.size(), distinct);
    EXPECT_EQ(set.duplicates(), duplicates);
    const Solution solution = solve_to_optimality("exact", set.points);
    EXPECT_TRUE(overlap(*solution.optimum, {lower, upper})) << solution.optimum->middle();
  }
  EXPECT_EQ(instances, 7);
}

TEST(TsplibOptima, IncludeALargerInstance) {
  const PointSet set = make_point_set(read_points(test_data("pcb3038.tsp")), "pcb3038");
  EXPECT_EQ(set.points.size(), 3038);
  (void)solve_to_optimality("exact", set.points);
}

}  // namespace
}  // namespace mwt
