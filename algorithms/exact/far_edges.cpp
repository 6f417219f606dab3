#include "algorithms/exact/far_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "algorithms/exact/direction_bins.h"

namespace mwt {

namespace {

// How many times the distance of the nearest neighbour is far. Nearer edges the diamond test sees precisely enough.
constexpr float kFar = 100;
constexpr std::size_t kWitnesses = 64;  // nearest neighbours that are looked at

struct Neighbour {
  float square;
  float x;
  float y;
  Index vertex;
};

// By distance: the nearest first, up to kWitnesses of them in order.
void collect_neighbours(const Star& star, std::vector<Neighbour>& neighbours) {
  neighbours.clear();
  for (std::uint32_t i = 0; i < star.count; ++i) {
    const float x = star.x()[i], y = star.y()[i];
    neighbours.push_back({x * x + y * y, x, y, star.target()[i]});
  }
  const auto end = neighbours.begin() + static_cast<std::ptrdiff_t>(std::min(neighbours.size(), kWitnesses));
  std::partial_sort(neighbours.begin(), end, neighbours.end(),
                    [](const Neighbour& a, const Neighbour& b) { return a.square < b.square; });
}

// Whether both triangles of the edge to `far` hold a neighbour. Those at most a tenth as far away are under the rising
// sides of the triangles; sine and tangent are compared with a margin far above what products of floats lose.
bool is_excluded(const std::vector<Neighbour>& neighbours, const Neighbour& far) {
  constexpr float kMargin = 1e-5F;
  constexpr auto kTangent = static_cast<float>(kTangentOfDiamondAngle);
  const std::size_t count = std::min(neighbours.size(), kWitnesses);
  bool left = false, right = false;
  for (std::size_t i = 0; i < count && neighbours[i].square * 100 < far.square && !(left && right); ++i) {
    const Neighbour& near = neighbours[i];
    const float along = far.x * near.x + far.y * near.y;
    const float height = far.x * near.y - far.y * near.x;
    const bool is_inside = std::abs(height) > kMargin * along && std::abs(height) < (kTangent - kMargin) * along;
    left = left || (is_inside && height > 0);
    right = right || (is_inside && height < 0);
  }
  return left && right;
}

void remove_target(Star& star, Index target) {
  std::uint32_t* const end = star.target() + star.count;
  const auto position = static_cast<std::size_t>(std::lower_bound(star.target(), end, target) - star.target());
  if (position == star.count || star.target()[position] != target) return;
  for (std::size_t row = 0; row < 4; ++row) {
    std::uint32_t* const words = star.words + row * star.capacity;
    std::copy(words + position + 1, words + star.count, words + position);
  }
  --star.count;
}

bool has_far_edges(const Star& star) {
  float smallest = std::numeric_limits<float>::infinity(), largest = 0;
  for (std::uint32_t i = 0; i < star.count; ++i) {
    const float square = star.x()[i] * star.x()[i] + star.y()[i] * star.y()[i];
    smallest = std::min(smallest, square);
    largest = std::max(largest, square);
  }
  return largest > kFar * kFar * smallest;
}

}  // namespace

std::size_t delete_far_edges(StarTable& stars) {
  std::vector<std::pair<Index, Index>> excluded;
  std::vector<Neighbour> neighbours;
  for (Index v = 0; v < stars.stars.size(); ++v) {
    if (!has_far_edges(stars.stars[v])) continue;
    collect_neighbours(stars.stars[v], neighbours);
    const float far = kFar * kFar * neighbours.front().square;
    for (const Neighbour& neighbour : neighbours) {
      if (neighbour.square > far && is_excluded(neighbours, neighbour)) excluded.emplace_back(v, neighbour.vertex);
    }
  }
  for (const auto& [v, w] : excluded) {
    remove_target(stars.stars[v], w);
    remove_target(stars.stars[w], v);
  }
  return excluded.size();
}

}  // namespace mwt
