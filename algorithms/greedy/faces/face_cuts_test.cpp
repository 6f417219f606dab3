#include "algorithms/greedy/faces/face_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "algorithms/greedy/testing/greedy_testing.h"
#include "geometry/mesh/constraint_insertion.h"
#include "geometry/mesh/distance.h"
#include "geometry/mesh/edge_order.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// Constrained Delaunay: the hull's edges and the given ones are fixed.
PlanarMesh constrained_mesh(Points points, const std::vector<Edge>& constraints) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  insert_constraints(mesh, constraints);
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    const bool is_constraint = std::binary_search(constraints.begin(), constraints.end(), mesh.labelled_edge(e));
    if (is_constraint || mesh.is_hull(e)) mesh.marks(e) |= kFixedMark;
  }
  return mesh;
}

// The edges that are not fixed, of all faces at once.
std::vector<MeshEdge> inner_edges(const PlanarMesh& mesh) {
  std::vector<MeshEdge> inner;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if ((mesh.marks(e) & kFixedMark) == 0) inner.push_back(e);
  }
  return inner;
}

// About one in `one_in` of the edges, sorted.
std::vector<Edge> some_of(const std::vector<Edge>& edges, std::uint64_t one_in, std::mt19937_64& random) {
  std::vector<Edge> some;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(some),
               [&](const Edge&) { return random() % one_in == 0; });
  return some;
}

// The shorter third of the edges, sorted.
std::vector<Edge> short_ones(Points points, std::vector<Edge> edges) {
  sort_by_length(points, edges);
  edges.resize(edges.size() / 3);
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Returns how many cuts were found, with several sets of greedy edges for constraints.
std::size_t expect_greedy(Points points, const std::string& what) {
  const std::vector<Edge> greedy = test::greedy_edges(points);
  std::mt19937_64 random(points.size());
  std::size_t found = 0;
  for (const auto& constraints : {std::vector<Edge>{}, short_ones(points, greedy), some_of(greedy, 4, random),
                                  some_of(greedy, 2, random), some_of(greedy, 2, random)}) {
    const PlanarMesh mesh = constrained_mesh(points, constraints);
    FaceCuts cuts(mesh);
    for (const MeshEdge e : cuts.find(inner_edges(mesh))) {
      EXPECT_TRUE(std::binary_search(greedy.begin(), greedy.end(), mesh.labelled_edge(e))) << what;
      ++found;
    }
  }
  return found;
}

TEST(FaceCuts, AreGreedy) { EXPECT_GT(test::sum_over_instances(6, 60, expect_greedy), 5000U); }

TEST(FaceCutsSlow, AreGreedyOnManyInstances) { EXPECT_GT(test::sum_over_instances(100, 120, expect_greedy), 200'000U); }

// Two rows of points, bent away from each other by jumps: the way across is shortest in the middle of every part.
std::vector<Point> make_gorge() {
  std::vector<Point> points;
  for (int i = -300; i <= 300; ++i) {
    const double from_middle = (i + 3000) % 30 - 14.8, bend = .004 * from_middle * from_middle;
    points.insert(points.end(), {{.1 * i, -bend}, {.1 * i + .01, 1 + bend}});
  }
  return points;
}

TEST(FaceCuts, LeadTheShortestWaysAcross) {
  const std::vector<Point> points = make_gorge();
  std::vector<Edge> rows;
  for (Index i = 0; i + 2 < points.size(); ++i) rows.push_back({i, i + 2});
  const PlanarMesh mesh = constrained_mesh(points, rows);
  const std::vector<MeshEdge> inner = inner_edges(mesh);
  FaceCuts cuts(mesh);
  std::size_t across = 0;
  for (const MeshEdge e : cuts.find(inner)) {
    const Edge edge = mesh.labelled_edge(e);
    across += edge.a % 2 != edge.b % 2 ? 1 : 0;
  }
  EXPECT_GE(across, 15U);  // of 20
  EXPECT_TRUE(cuts.is_promising(inner));
}

// Every point of a fan is seen from its hub at another distance: there is but one shortest way.
TEST(FaceCuts, AreFewInAFan) {
  std::vector<Point> points{{0, 0}};
  for (int i = 0; i <= 2000; ++i) points.push_back({i - 1000.0, 2000 + .0001 * i * i});
  const PlanarMesh mesh = constrained_mesh(points, {});
  EXPECT_FALSE(FaceCuts(mesh).is_promising(inner_edges(mesh)));
}

// By definition: is a point seen from the apex of the window through it, as near as that?
bool shows_near(const PlanarMesh& mesh, Halfedge window, double squared) {
  const Index apex = mesh.apex(window), from = mesh.origin(window), to = mesh.target(window);
  const Point& c = mesh.point(apex);
  for (Index v = 0; v < mesh.point_count(); ++v) {
    const Point& p = mesh.point(v);
    if (v == apex || orientation(c, mesh.point(from), p) <= 0 || orientation(c, p, mesh.point(to)) <= 0) continue;
    if (rounded_squared_distance(c, p) > squared) continue;
    bool is_hidden = false;
    for (Index w = 0; w < mesh.point_count(); ++w) {
      is_hidden |=
          w != v && w != apex && orientation(c, p, mesh.point(w)) == 0 && in_segment_interior(mesh.point(w), c, p);
    }
    for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
      const Point &q = mesh.point(mesh.origin(2 * e)), &r = mesh.point(mesh.target(2 * e));
      is_hidden |= (mesh.marks(e) & kFixedMark) != 0 && segments_cross(c, p, q, r);
    }
    if (!is_hidden) return true;
  }
  return false;
}

TEST(WindowSearch, SeesWhatIsThere) {
  std::size_t nothing = 0, found_nothing = 0, something = 0;
  const auto compare = [&](Points points, const std::string& what) {
    std::mt19937_64 random(7);
    const PlanarMesh mesh = constrained_mesh(points, some_of(test::greedy_edges(points), 3, random));
    WindowSearch search(mesh);
    for (Halfedge h = 0; h < 2 * mesh.edge_count(); ++h) {
      const bool is_outer =
          mesh.is_hull(edge_of(h)) &&
          orientation(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)), mesh.point(mesh.apex(h))) <= 0;
      if (is_outer) continue;
      const Point& c = mesh.point(mesh.apex(h));
      const double length = rounded_squared_distance(c, mesh.point(mesh.origin(h)));
      if (!(length > 1e-200 && length < 1e200)) continue;
      for (const double squared : {length, 2 * length}) {
        const bool answer = search.shows_nothing_near(h, squared, 10'000);
        if (shows_near(mesh, h, squared)) {
          EXPECT_FALSE(answer) << what;
          ++something;
        } else {
          ++nothing;
          found_nothing += answer ? 1 : 0;
        }
      }
    }
    return std::size_t{1};
  };
  test::sum_over_instances(5, 30, compare);
  EXPECT_GT(something, 1000U);
  EXPECT_GT(found_nothing, nothing * 9 / 10);
}

TEST(WindowSearch, GivesUpAfterSoManySteps) {
  const PlanarMesh mesh = constrained_mesh(make_gorge(), {});
  std::size_t given_up = 0;
  for (const MeshEdge e : inner_edges(mesh)) {
    const double far = 4 * static_cast<double>(mesh.record(e).squared_length);
    WindowSearch patient(mesh), impatient(mesh);
    if (!patient.shows_nothing_near(2 * e, far, 10'000) || patient.steps() <= 3) continue;
    EXPECT_FALSE(impatient.shows_nothing_near(2 * e, far, 3));
    EXPECT_LE(impatient.steps(), 4U);
    ++given_up;
  }
  EXPECT_GT(given_up, 10U);
}

}  // namespace

}  // namespace mwt
