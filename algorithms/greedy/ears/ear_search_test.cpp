#include "algorithms/greedy/ears/ear_search.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/greedy/faces/face_boundary.h"
#include "algorithms/greedy/testing/greedy_testing.h"
#include "generators/registry.h"

namespace mwt {

namespace {

EarSite site_of(const FaceBoundary& boundary, Corner c) {
  const Corner next = boundary.next(c), previous = boundary.previous(c);
  return {boundary.wedge(c),
          boundary.point(c),
          boundary.point(next),
          boundary.point(previous),
          {boundary.point(boundary.next(next)), boundary.point(boundary.previous(previous))}};
}

// Returns how many ears were certain.
std::size_t expect_found_ears_greedy(Points points, const std::string& what) {
  const std::vector<Edge> greedy = test::greedy_edges(points);
  std::size_t certain = 0;
  for (const std::uint64_t one_in : {1000, 4, 2}) {
    const PlanarMesh mesh = test::constrained_mesh(points, test::some_of(greedy, one_in, points.size()));
    const EdgeOrder order(mesh.points(), mesh.labels());
    const FaceBoundary boundary(mesh, test::inner_edges(mesh));
    EarSearch search(mesh, order);
    for (Corner c = 0; c < boundary.size(); ++c) {
      if (boundary.is_of_triangle(c) || !search.is_certain(site_of(boundary, c), 1000)) continue;
      const Edge ear =
          make_edge(mesh.label(boundary.point(boundary.next(c))), mesh.label(boundary.point(boundary.previous(c))));
      EXPECT_TRUE(std::binary_search(greedy.begin(), greedy.end(), ear)) << what;
      ++certain;
    }
  }
  return certain;
}

TEST(EarSearch, CertainEarsAreGreedy) { EXPECT_GT(test::sum_over_instances(6, 60, expect_found_ears_greedy), 1000U); }

// On a circle nothing is nearer than the next points: the shortest of its ears is certain.
TEST(EarSearch, FindsTheShortestEarOfACircle) {
  const std::vector<Point> points = generate("circle", 50, 1, {});
  const PlanarMesh mesh = test::constrained_mesh(points, {});
  const EdgeOrder order(mesh.points(), mesh.labels());
  const FaceBoundary boundary(mesh, test::inner_edges(mesh));
  EarSearch search(mesh, order);
  std::size_t certain = 0;
  for (Corner c = 0; c < boundary.size(); ++c) certain += search.is_certain(site_of(boundary, c), 1000) ? 1 : 0;
  EXPECT_GT(certain, 0U);
}

// Some ears of these are certain only for those who search long enough.
TEST(EarSearch, GivesUpAfterSoManySteps) {
  std::size_t found_later = 0;
  for (const char* family : {"uniform", "spiral", "circle", "roads"}) {
    const std::vector<Point> points = generate(family, 400, 1, {});
    const PlanarMesh mesh = test::constrained_mesh(points, test::some_of(test::greedy_edges(points), 2, 1));
    const EdgeOrder order(mesh.points(), mesh.labels());
    const FaceBoundary boundary(mesh, test::inner_edges(mesh));
    EarSearch search(mesh, order);
    for (Corner c = 0; c < boundary.size(); ++c) {
      if (boundary.is_of_triangle(c) || search.is_certain(site_of(boundary, c), 0) || !search.gave_up()) continue;
      found_later += search.is_certain(site_of(boundary, c), 1000) ? 1 : 0;
      EXPECT_FALSE(search.gave_up());
    }
  }
  EXPECT_GT(found_later, 10U);
}

}  // namespace

}  // namespace mwt
