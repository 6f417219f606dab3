#include "algorithms/flip/best_first.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/common/start.h"
#include "algorithms/flip/improving_flip.h"
#include "geometry/testing/shapes.h"

namespace mwt {

namespace {

using test::make_shape;
using test::ShapeFamily;
using test::shapes;

// The definition, word for word: looks at all edges before every flip.
std::vector<Flip> flip_best_by_definition(PlanarMesh& mesh) {
  std::vector<Flip> flips;
  while (true) {
    std::optional<std::pair<double, MeshEdge>> best;
    for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
      if (improves(mesh, e)) best = std::max(best, std::optional(std::pair(gain_of(mesh, e), e)));
    }
    if (!best) return flips;
    const Edge removed = mesh.labelled_edge(best->second);
    mesh.flip(best->second);
    flips.push_back({removed, mesh.labelled_edge(best->second), best->first * mesh.unit()});
  }
}

void expect_same(const PlanarMesh& mesh, const PlanarMesh& expected, const std::string& which) {
  ASSERT_EQ(mesh.edge_count(), expected.edge_count());
  std::size_t different = 0;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    const EdgeRecord &one = mesh.record(e), &two = expected.record(e);
    different += one.origins != two.origins || one.next != two.next || one.previous != two.previous ||
                 one.squared_length != two.squared_length || one.marks != two.marks;
  }
  EXPECT_EQ(different, 0U) << which;
}

// Every edge with marks of its own, so that it shows which were flipped and which are as they were.
PlanarMesh marked_start(const std::vector<Point>& points, std::size_t random_flips, std::uint64_t seed) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  flip_at_random(mesh, seed, random_flips);
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) mesh.marks(e) |= (e + 1) << 16;
  return mesh;
}

// From Delaunay, from a few random flips (bursts of gains that grow) and from many.
template <class Check>
void for_all_starts(std::size_t n, std::uint64_t seeds, Check check) {
  for (const ShapeFamily& shape : shapes()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const std::vector<Point> points = make_shape(shape, n, seed);
      for (const std::size_t flips : {std::size_t{0}, n / 10, 10 * n}) {
        const std::string which = shape.name + " n=" + std::to_string(n) + " seed=" + std::to_string(seed) +
                                  " random flips=" + std::to_string(flips);
        check(marked_start(points, flips, seed), which);
      }
    }
  }
}

TEST(BestFirst, IsTheSearchByDefinitionWhateverThePortion) {
  for (const std::size_t n : {5, 12, 40}) {
    for_all_starts(n, 6, [](const PlanarMesh& start, const std::string& which) {
      PlanarMesh expected = start;
      const std::size_t flips = flip_best_by_definition(expected).size();
      for (const std::size_t portion : {1, 2, 7, 30, 1000}) {
        PlanarMesh mesh = start;
        EXPECT_EQ(flip_best_first(mesh, Context{}, false, portion).flips, flips) << which;
        expect_same(mesh, expected, which + " portion=" + std::to_string(portion));
      }
    });
  }
}

TEST(BestFirst, TracesTheSearchByDefinition) {
  for_all_starts(40, 3, [](const PlanarMesh& start, const std::string& which) {
    PlanarMesh mesh = start, expected = start;
    const std::vector<Flip> flips = flip_best_by_definition(expected);
    const std::vector<Flip> trace = flip_best_first(mesh, Context{}, true).trace;
    ASSERT_EQ(trace.size(), flips.size()) << which;
    for (std::size_t i = 0; i < flips.size(); ++i) {
      EXPECT_EQ(trace[i].removed, flips[i].removed) << which;
      EXPECT_EQ(trace[i].added, flips[i].added) << which;
      EXPECT_EQ(trace[i].gain, flips[i].gain) << which;
    }
  });
}

TEST(BestFirst, IsTheSameInSmallPortionsAsAtOnceOnManyPoints) {
  for_all_starts(1000, 1, [](const PlanarMesh& start, const std::string& which) {
    PlanarMesh expected = start;
    const FlipResult at_once = flip_best_first(expected, Context{}, true);
    for (const std::size_t portion : {1, 300}) {
      PlanarMesh mesh = start;
      EXPECT_EQ(flip_best_first(mesh, Context{}, false, portion).flips, at_once.flips) << which;
      expect_same(mesh, expected, which + " portion=" + std::to_string(portion));
    }
  });
}

TEST(BestFirst, LooksAtFewEdgesAgain) {
  PlanarMesh mesh = PlanarMesh::delaunay(make_shape(shapes().front(), 20000, 1));
  PlanarMesh same = mesh;
  const std::size_t at_once = flip_best_first(same, Context{}, true).tests;
  EXPECT_LT(flip_best_first(mesh, Context{}, false, 500).tests, at_once + at_once / 20);
}

TEST(BestFirst, StopsAtTheDeadlineInAnyPortion) {
  const PlanarMesh start = marked_start(make_shape(shapes().front(), 20000, 1), 200000, 1);
  Context context;
  context.deadline = Context::Clock::now();
  for (const std::size_t portion : {std::size_t{100}, kBestFirstPortion, start.edge_count()}) {
    PlanarMesh mesh = start;
    const FlipResult result = flip_best_first(mesh, context, false, portion);
    EXPECT_TRUE(result.stopped_early);
    EXPECT_LT(result.flips, 5000U);
  }
}

}  // namespace

}  // namespace mwt
