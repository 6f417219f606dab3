#include "algorithms/greedy/queue/edge_sorter.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/testing/shapes.h"

namespace mwt {

namespace {

void expect_sorted(const test::ShapeFamily& shape, std::size_t n) {
  const std::vector<Point> points = test::make_shape(shape, n, 1);
  const PlanarMesh mesh = PlanarMesh::delaunay(points);
  const EdgeOrder order(mesh.points(), mesh.labels());
  std::vector<MeshEdge> expected(mesh.edge_count());
  for (MeshEdge e = 0; e < expected.size(); ++e) expected[e] = e;
  EdgeSorter sorter(mesh, order);
  sorter.sort(expected);
  const auto key = [&](MeshEdge e) { return order.key(mesh.origin(2 * e), mesh.target(2 * e)); };
  std::sort(expected.begin(), expected.end(),
            [&](MeshEdge one, MeshEdge two) { return order.precedes(key(one), key(two)); });
  ASSERT_EQ(sorter.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(sorter.edge(i), expected[i]) << shape.name << " n=" << n;
}

TEST(EdgeSorter, SortsInTheExactOrder) {
  for (const test::ShapeFamily& shape : test::shapes()) {
    for (const std::size_t n : {5, 60, 1000}) expect_sorted(shape, std::min(n, shape.max_n));
  }
}

TEST(EdgeSorter, ForgetsTheEdgesOfTheLastCall) {
  const std::vector<Point> points = test::make_shape(test::shapes().front(), 50, 1);
  const PlanarMesh mesh = PlanarMesh::delaunay(points);
  const EdgeOrder order(mesh.points(), mesh.labels());
  EdgeSorter sorter(mesh, order);
  sorter.sort(std::vector<MeshEdge>{3, 1, 2});
  sorter.sort(std::vector<MeshEdge>{7});
  ASSERT_EQ(sorter.size(), 1U);
  EXPECT_EQ(sorter.edge(0), 7U);
}

}  // namespace

}  // namespace mwt
