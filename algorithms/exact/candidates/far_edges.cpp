#include "algorithms/exact/candidates/far_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "algorithms/exact/candidates/direction_bins.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// Edges longer than this many times the distance of the nearest neighbour are far: for shorter ones the diamond test is
// precise enough.
constexpr float kFar = 100;
// A neighbour is a witness if the edge is at least this many times as long as its distance: it then lies under the
// rising side of a diamond triangle if its direction is within the base angle, whatever is at the far end.
constexpr float kWitnessRatio = 10;
constexpr std::size_t kMaxWitnesses = 64;  // nearest neighbours that are examined

struct Neighbour {
  float square;
  float x;
  float y;
  Index vertex;
};

// By distance: the nearest first, up to kMaxWitnesses of them in order. Those whose vectors floats cannot hold are left
// out.
void collect_neighbours(const Star& star, std::vector<Neighbour>& neighbours) {
  neighbours.clear();
  for (std::uint32_t i = 0; i < star.count; ++i) {
    const float x = star.x()[i], y = star.y()[i], square = x * x + y * y;
    if (!std::isnan(square)) neighbours.push_back({square, x, y, star.target()[i]});
  }
  const auto end = neighbours.begin() + static_cast<std::ptrdiff_t>(std::min(neighbours.size(), kMaxWitnesses));
  std::partial_sort(neighbours.begin(), end, neighbours.end(),
                    [](const Neighbour& a, const Neighbour& b) { return a.square < b.square; });
}

class FarEdgeTest {
 public:
  FarEdgeTest(Points points, Index v, const std::vector<Neighbour>& neighbours)
      : points_(points), v_(v), neighbours_(neighbours) {}

  // Whether both triangles of the edge to `far` hold a neighbour. Those at most a tenth as far away are under the
  // rising sides of the triangles if their direction is near enough to that of the edge.
  [[nodiscard]] bool is_excluded(const Neighbour& far) const {
    const std::size_t count = std::min(neighbours_.size(), kMaxWitnesses);
    constexpr float kSquareRatio = kWitnessRatio * kWitnessRatio;
    bool left = false, right = false;
    for (std::size_t i = 0; i < count && neighbours_[i].square * kSquareRatio < far.square && !(left && right); ++i) {
      const int side = side_of(far, neighbours_[i]);
      left = left || side > 0;
      right = right || side < 0;
    }
    return left && right;
  }

 private:
  // On which side of the edge a neighbour lies in the triangle; 0 if in neither, or if floats cannot tell.
  [[nodiscard]] int side_of(const Neighbour& far, const Neighbour& near) const {
    constexpr float kMargin = 1e-5F;  // relative; products of floats lose about 2e-7
    constexpr auto kTangent = static_cast<float>(kTangentOfDiamondAngle);
    const float along = far.x * near.x + far.y * near.y;
    const float height = far.x * near.y - far.y * near.x;
    const bool is_under_side = std::abs(height) < (kTangent - kMargin) * along;
    if (!is_under_side) return 0;
    if (std::abs(height) > kMargin * along) return height > 0 ? 1 : -1;
    return orientation(points_[v_], points_[far.vertex], points_[near.vertex]);
  }

  Points points_;
  Index v_;
  const std::vector<Neighbour>& neighbours_;
};

void remove_target(Star& star, Index target) {
  const auto targets = star.targets();
  const auto place = std::lower_bound(targets.begin(), targets.end(), target);
  if (place != targets.end() && *place == target) star.erase(static_cast<std::uint32_t>(place - targets.begin()));
}

bool has_far_edges(const Star& star) {
  float smallest = std::numeric_limits<float>::infinity(), largest = 0;
  for (std::uint32_t i = 0; i < star.count; ++i) {
    const float square = star.x()[i] * star.x()[i] + star.y()[i] * star.y()[i];
    if (std::isnan(square)) continue;
    smallest = std::min(smallest, square);
    largest = std::max(largest, square);
  }
  return largest > kFar * kFar * smallest;
}

}  // namespace

std::size_t delete_far_edges(Points points, StarTable& stars) {
  std::vector<std::pair<Index, Index>> excluded;
  std::vector<Neighbour> neighbours;
  for (Index v = 0; v < stars.stars.size(); ++v) {
    if (!has_far_edges(stars.stars[v])) continue;
    collect_neighbours(stars.stars[v], neighbours);
    const FarEdgeTest test(points, v, neighbours);
    const float far = kFar * kFar * neighbours.front().square;
    for (const Neighbour& neighbour : neighbours) {
      if (neighbour.square > far && test.is_excluded(neighbour)) excluded.emplace_back(v, neighbour.vertex);
    }
  }
  for (const auto& [v, w] : excluded) {
    remove_target(stars.stars[v], w);
    remove_target(stars.stars[w], v);
  }
  return excluded.size();
}

}  // namespace mwt
