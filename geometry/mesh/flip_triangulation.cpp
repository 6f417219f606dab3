#include "geometry/mesh/flip_triangulation.h"

#include <algorithm>

namespace mwt {

namespace {

// The corner of a triangle's neighbour that lies across from the triangle.
std::size_t corner_facing(const std::array<Index, 3>& neighbours, Index triangle) {
  return static_cast<std::size_t>(std::find(neighbours.begin(), neighbours.end(), triangle) - neighbours.begin());
}

}  // namespace

FlipTriangulation::FlipTriangulation(const Triangulation& triangulation) : point_count_(triangulation.point_count) {
  const std::vector<Triangle>& triangles = triangulation.triangles;
  const std::vector<std::array<Index, 3>> adjacent = adjacency_of(triangulation);
  // The half-edge of each triangle opposite each corner.
  std::vector<std::array<Index, 3>> half_edges(triangles.size(), {kNoIndex, kNoIndex, kNoIndex});
  origin_.reserve(3 * triangles.size() + triangles.size() / 8);
  for (Index t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (half_edges[t][i] != kNoIndex) continue;
      const auto half_edge = static_cast<Index>(origin_.size());
      half_edges[t][i] = half_edge;
      const Index other = adjacent[t][i];
      if (other != kNoIndex) half_edges[other][corner_facing(adjacent[other], t)] = half_edge + 1;
      const Edge side = directed_edge(triangles[t], static_cast<int>(i));
      origin_.push_back(side.a);
      origin_.push_back(side.b);
    }
  }
  next_.assign(origin_.size(), kNoIndex);
  for (const std::array<Index, 3>& around : half_edges) {
    for (std::size_t i = 0; i < 3; ++i) next_[around[i]] = around[(i + 1) % 3];
  }
}

void FlipTriangulation::flip(Index e) {
  const Index h = 2 * e, twin = h + 1;
  const Index bc = next_[h], ca = next_[bc];
  const Index ad = next_[twin], db = next_[ad];
  origin_[h] = origin_[db];     // h runs from d to c now, with a on its left
  origin_[twin] = origin_[ca];  // and its twin from c to d, with b on its left
  next_[h] = ca;
  next_[ca] = ad;
  next_[ad] = h;
  next_[twin] = db;
  next_[db] = bc;
  next_[bc] = twin;
}

Triangulation FlipTriangulation::triangulation() const {
  Triangulation result;
  result.point_count = point_count_;
  result.triangles.reserve(origin_.size() / 3);
  for (Index h = 0; h < origin_.size(); ++h) {
    if (next_[h] == kNoIndex) continue;
    const Index second = next_[h], third = next_[second];
    if (h < second && h < third) result.triangles.push_back({origin_[h], origin_[second], origin_[third]});
  }
  return result;
}

}  // namespace mwt
