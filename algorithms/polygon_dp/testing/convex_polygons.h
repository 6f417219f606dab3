// For tests only: convex polygons of many kinds, as cycles from their lexicographically smallest vertex on.
#pragma once

#include <string>
#include <vector>

#include "generators/registry.h"
#include "geometry/convex_hull.h"
#include "geometry/triangulation.h"
#include "geometry/weight.h"

namespace mwt::convex_testing {

struct NamedPolygon {
  std::string name;
  std::vector<Point> vertices;
};

inline std::vector<Point> hull_cycle(const std::vector<Point>& points) {
  std::vector<Point> cycle;
  for (const Index v : convex_hull(points)) cycle.push_back(points[v]);
  return cycle;
}

/// A square with `n` vertices, evenly along its sides.
inline std::vector<Point> square_with_points_on_sides(Index n) {
  const int side = static_cast<int>(n / 4);
  std::vector<Point> points;
  for (int i = 0; i < side; ++i) {
    const double t = i, s = side;
    for (const Point& p : {Point{t, 0}, Point{s, t}, Point{s - t, s}, Point{0, s - t}}) points.push_back(p);
  }
  return points;
}

inline std::vector<NamedPolygon> polygons(Index n) {
  std::vector<NamedPolygon> result;
  const auto add = [&](const std::string& name, const std::vector<Point>& points) {
    result.push_back({name + ' ' + std::to_string(n), hull_cycle(points)});
  };
  for (const char* family : {"circle", "convex_position", "parabola", "integer_circle", "fan"}) {
    add(family, generate(family, n, 1));
  }
  add("flat ellipse", generate("ellipse", n, 1, {{"aspect", "0.001"}}));
  add("square", square_with_points_on_sides(n));
  std::vector<Point> far = generate("circle", n, 1);
  for (Point& p : far) p = {p.x * 0x1p-20 + 1e3, p.y * 0x1p-20 - 1e3};
  add("far circle", far);
  std::vector<Point> huge = generate("circle", n, 1);
  for (Point& p : huge) p = {p.x * 1e300, p.y * 1e300};
  add("huge circle", huge);
  std::vector<Point> tiny = generate("circle", n, 1);
  for (Point& p : tiny) p = {p.x * 1e-290, p.y * 1e-290};
  add("tiny circle", tiny);
  return result;
}

inline std::vector<Index> cycle_of(const std::vector<Point>& vertices) {
  std::vector<Index> cycle(vertices.size());
  for (Index i = 0; i < cycle.size(); ++i) cycle[i] = i;
  return cycle;
}

inline Interval weight_of(const std::vector<Point>& vertices, const std::vector<Triangle>& triangles) {
  return weight(vertices, {static_cast<Index>(vertices.size()), triangles});
}

}  // namespace mwt::convex_testing
