#include "harness/io/given_triangulation.h"

#include <fmt/core.h>

#include "base/error.h"
#include "geometry/checker.h"
#include "geometry/edge_faces.h"

namespace mwt {

namespace {

// The checker would name the corner only as out of range of the distinct points.
template <class Figure>
std::optional<std::string> corner_out_of_range(const std::vector<Figure>& figures, std::size_t point_count,
                                               const char* kind) {
  for (std::size_t f = 0; f < figures.size(); ++f) {
    for (const Index corner : figures[f]) {
      if (corner < point_count) continue;
      return fmt::format("{}: {} {} has corner {}, but points go from 0 to {}",
                         name_of(TriangulationRule::indices_in_range), kind, f, corner, point_count - 1);
    }
  }
  return std::nullopt;
}

std::vector<std::array<Index, 2>> ends_of(const std::vector<Edge>& edges) {
  std::vector<std::array<Index, 2>> ends;
  for (const auto& [a, b] : edges) ends.push_back({a, b});
  return ends;
}

// Precondition: all corners in range.
Triangulation triangulation_of(const PointSet& set, const std::vector<Point>& input, const GivenSolution& solution) {
  if (solution.edges.empty()) return from_input_indices(set, input, solution.triangles);
  std::vector<Triangle> as_triangles;
  for (const auto& [a, b] : solution.edges) as_triangles.push_back({a, b, b});
  std::vector<Edge> edges;
  for (const Triangle& t : from_input_indices(set, input, as_triangles).triangles)
    edges.push_back(make_edge(t[0], t[1]));
  return triangulation_of(set.points, edges);
}

}  // namespace

std::optional<std::string> broken_rule(const PointSet& set, const std::vector<Point>& input,
                                       const GivenSolution& solution) {
  if (auto complaint = corner_out_of_range(solution.triangles, input.size(), "triangle")) return complaint;
  if (auto complaint = corner_out_of_range(ends_of(solution.edges), input.size(), "edge")) return complaint;
  for (std::size_t e = 0; e < solution.edges.size(); ++e) {
    const auto& [a, b] = solution.edges[e];
    if (input[a] == input[b]) return fmt::format("edge {} ends where it begins, at point {}", e, a);
  }
  const auto violation = find_violation(set.points, triangulation_of(set, input, solution));
  if (!violation) return std::nullopt;
  return (solution.edges.empty() ? "" : "the triangles that the edges bound: ") + violation->message +
         (set.duplicates() > 0 ? " (points numbered without the duplicates)" : "");
}

Triangulation read_triangulation(const std::string& path, const PointSet& set, const std::vector<Point>& input) {
  const GivenSolution solution = read_solution(path, input.size());
  if (const auto rule = broken_rule(set, input, solution)) {
    throw InputError(path + ": not a triangulation of these points: " + *rule);
  }
  return triangulation_of(set, input, solution);
}

}  // namespace mwt
