// What tests of greedy's parts share: greedy by definition, and instances of all kinds.
#pragma once

#include <string>
#include <vector>

#include "algorithms/registry.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/mesh/testing/shapes_for_tests.h"
#include "geometry/point_set.h"

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

}  // namespace mwt::test
