#include "algorithms/exact/proof/outlined_region.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithms/proof/half_length.h"
#include "geometry/numbers/interval.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

DualRegion outline_of(const LocalRegion& local) {
  using Place = std::uint32_t;
  DualRegion result;
  std::vector<Place> place_of(local.points.size(), 0);
  std::vector<bool> has_place(local.points.size(), false);
  std::vector<std::vector<Index>> next(local.points.size());
  for (const Edge& side : local.boundary) next[side.a].push_back(side.b);
  const auto add_place = [&](Index v) {
    place_of[v] = static_cast<Place>(result.places.size());
    has_place[v] = true;
    result.places.push_back(v);
  };
  for (Index v = 0; v < local.points.size(); ++v) {
    while (!next[v].empty()) {
      const std::size_t first = result.places.size();
      for (Index at = v; !next[at].empty();) {
        add_place(at);
        const Index to = next[at].back();
        next[at].pop_back();
        at = to;
      }
      result.walk_sizes.push_back(static_cast<std::uint32_t>(result.places.size() - first));
    }
  }
  for (Index v = 0; v < local.points.size(); ++v) {
    if (!has_place[v]) add_place(v);
  }
  for (std::size_t i = local.boundary.size(); i < local.sides.size(); i += 2) {  // each in both directions
    const Place a = place_of[local.sides[i].a], b = place_of[local.sides[i].b];
    result.open_edges.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(result.open_edges.begin(), result.open_edges.end());
  return result;
}

OutlinedRegion::OutlinedRegion(DualRegion& region, const LocalRegion& local) : region_(region), local_(local) {
  for (const auto& [from, to] : region.open_edges) open_.push_back({region.places[from], region.places[to]});
}

FaceRegion OutlinedRegion::as_face(std::size_t components) const {
  FaceRegion face;
  face.vertices.resize(local_.points.size());
  std::iota(face.vertices.begin(), face.vertices.end(), Index{0});
  face.boundary = local_.boundary;
  face.candidates = undirected_edges(open_);
  face.components = components;
  return face;
}

double OutlinedRegion::longest_edge() const {
  double longest = 0;
  for (const auto& [a, b] : open_) longest = std::max(longest, length(local_.points[a], local_.points[b]).high);
  return longest;
}

void OutlinedRegion::choose_unit(double length) {
  region_.unit_exponent = std::ilogb(std::max(length, longest_edge())) + 1 - kBits;
}

std::int64_t OutlinedRegion::half(Index a, Index b) const {
  return std::max<std::int64_t>(0, half_length(length(local_.points[a], local_.points[b]), region_.unit_exponent));
}

std::int64_t OutlinedRegion::target_of(std::span<const Edge> diagonals) const {
  std::int64_t units = 0;
  for (const auto& [a, b] : diagonals) units += 2 * (half(a, b) - 1);
  return units;
}

void OutlinedRegion::prove(std::int64_t units) {
  region_.lower_bound = std::max(0.0, next_down(std::ldexp(static_cast<double>(units), region_.unit_exponent)));
}

double total_length(Points points, std::span<const Edge> edges) {
  double sum = 0;
  for (const auto& [a, b] : edges) sum += length(points[a], points[b]).high;
  return sum;
}

}  // namespace mwt
