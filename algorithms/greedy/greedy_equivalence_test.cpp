// The registry's greedy against the registry's greedy_naive, edge for edge, on all families and shapes.
#include <gtest/gtest.h>

#include "algorithms/greedy/greedy_builder.h"
#include "algorithms/registry.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/point_set.h"
#include "geometry/testing/shapes.h"

namespace mwt {

namespace {

std::vector<Edge> edges_by(const std::string& algorithm, Points points) {
  const AlgorithmInfo& info = find_algorithm(algorithm);
  Context context;
  context.parameters = Parameters(info.name, info.parameters, {});
  return edges_of(info.function(points, context).triangulation);
}

// Faces with more edges than that are treated as those that no cache holds.
std::vector<Edge> edges_with_large_faces_from(std::size_t large_face, Points points) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  build_greedy(mesh, Context{}, large_face);
  return edges_of(mesh.triangulation());
}

std::vector<Edge> edges_by_certain_ears(Points points) { return edges_with_large_faces_from(0, points); }
std::vector<Edge> edges_by_queue_alone(Points points) { return edges_with_large_faces_from(points.size() * 3, points); }

// Compares on one instance; returns whether there was one.
bool compare_on_family(const GeneratorInfo& family, Index n, std::uint64_t seed) {
  try {
    const PointSet set = make_point_set(generate(family.name, n, seed, {}), family.name);
    const std::vector<Edge> expected = edges_by("greedy_naive", set.points);
    EXPECT_EQ(edges_by("greedy", set.points), expected) << family.name << " n=" << n << " seed=" << seed;
    EXPECT_EQ(edges_by_certain_ears(set.points), expected) << family.name << " n=" << n << " seed=" << seed;
    return true;
  } catch (const InputError&) {
    return false;  // the family has no instance of this size
  }
}

void compare_on_shape(const test::ShapeFamily& shape, std::size_t n, std::uint64_t seed) {
  const std::vector<Point> points = test::make_shape(shape, n, seed);
  const std::vector<Edge> expected = edges_by("greedy_naive", points);
  EXPECT_EQ(edges_by("greedy", points), expected) << shape.name << " n=" << n << " seed=" << seed;
  EXPECT_EQ(edges_by_certain_ears(points), expected) << shape.name << " n=" << n << " seed=" << seed;
}

// Instances of up to `max_n` points: many small ones, a few as large as that.
std::size_t compare_on_all(std::uint64_t seeds, Index smaller_n, Index max_n) {
  std::size_t instances = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Index n = seed % 30 == 0 ? max_n : 3 + static_cast<Index>(7 * seed) % smaller_n;
    for (const GeneratorInfo& family : generators()) instances += compare_on_family(family, n, seed) ? 1 : 0;
    for (const test::ShapeFamily& shape : test::shapes()) compare_on_shape(shape, n, seed);
    instances += test::shapes().size();
  }
  return instances;
}

TEST(GreedyEquivalence, EqualsGreedyNaive) { EXPECT_GT(compare_on_all(4, 40, 100), 100U); }

// Fans of thousands of edges and ears whose search is put off, which small instances do not have.
TEST(GreedyEquivalence, CertainEarsAgreeWithTheQueueOnCurves) {
  for (const char* family : {"circle", "convex_position", "ellipse", "spiral", "insertion_trap", "roads"}) {
    const std::vector<Point> points = generate(family, 4000, 1, {});
    EXPECT_EQ(edges_by_certain_ears(points), edges_by_queue_alone(points)) << family;
  }
}

TEST(GreedyEquivalenceSlow, EqualsGreedyNaiveOnFiveThousandInstances) {
  EXPECT_GE(compare_on_all(150, 60, 500), 5000U);
}

}  // namespace

}  // namespace mwt
