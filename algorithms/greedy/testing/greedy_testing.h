// What tests of greedy's parts share: greedy by definition, and instances of all kinds.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "algorithms/greedy/greedy_marks.h"
#include "algorithms/registry.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/mesh/constraint_insertion.h"
#include "geometry/mesh/in_circle.h"
#include "geometry/point_set.h"
#include "geometry/testing/shapes.h"

namespace mwt::test {

/// The edges of greedy_naive, sorted.
inline std::vector<Edge> greedy_edges(Points points) {
  const AlgorithmInfo& info = find_algorithm("greedy_naive");
  Context context;
  context.parameters = Parameters(info.name, info.parameters, {});
  return edges_of(info.function(points, context).triangulation);
}

/// The sum of check(points, name) over all shapes and families, for so many seeds, with 3 to smaller_n + 2 points.
template <class Check>
std::size_t sum_over_instances(std::uint64_t seeds, Index smaller_n, Check check) {
  std::size_t sum = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Index n = 3 + static_cast<Index>(7 * seed) % smaller_n;
    const std::string size = " n=" + std::to_string(n);
    for (const ShapeFamily& shape : shapes()) sum += check(make_shape(shape, n, seed), shape.name + size);
    for (const GeneratorInfo& family : generators()) {
      try {
        const PointSet set = make_point_set(generate(family.name, n, seed, {}), family.name);
        sum += check(set.points, family.name + size);
      } catch (const InputError&) {  // the family has no instance of this size
      }
    }
  }
  return sum;
}

/// Constrained Delaunay: the hull's edges and the given ones, sorted, are fixed.
inline PlanarMesh constrained_mesh(Points points, const std::vector<Edge>& constraints) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  insert_constraints(mesh, constraints);
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    const bool is_constraint = std::binary_search(constraints.begin(), constraints.end(), mesh.labelled_edge(e));
    if (is_constraint || mesh.is_hull(e)) mesh.marks(e) |= kFixedMark;
  }
  return mesh;
}

/// About one in `one_in` of the edges, in their order.
inline std::vector<Edge> some_of(const std::vector<Edge>& edges, std::uint64_t one_in, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Edge> some;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(some),
               [&](const Edge&) { return random() % one_in == 0; });
  return some;
}

/// The edges that are not fixed, of all faces at once.
inline std::vector<MeshEdge> inner_edges(const PlanarMesh& mesh) {
  std::vector<MeshEdge> inner;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if (!is_fixed_edge(mesh, e)) inner.push_back(e);
  }
  return inner;
}

/// The fixed edges in the caller's numbers, sorted.
inline std::vector<Edge> fixed_edges(const PlanarMesh& mesh) {
  std::vector<Edge> fixed;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if (is_fixed_edge(mesh, e)) fixed.push_back(mesh.labelled_edge(e));
  }
  std::sort(fixed.begin(), fixed.end());
  return fixed;
}

/// No edge that is not fixed has a point of its one triangle inside the circle of the other.
inline void expect_constrained_delaunay(const PlanarMesh& mesh, const std::string& what) {
  for (const MeshEdge e : inner_edges(mesh)) {
    const Halfedge h = 2 * e;
    EXPECT_LE(fast_in_circle(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)), mesh.point(mesh.apex(h)),
                             mesh.point(mesh.apex(h + 1))),
              0)
        << what;
  }
}

}  // namespace mwt::test
