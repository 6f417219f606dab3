#include "generators/delaunay_flip_stuck/delaunay_flip_stuck.h"

#include <cmath>

namespace mwt {

namespace {

GrowthLaw linear_growth(const std::string& algorithm) {
  return {.algorithm = algorithm,
          .algorithm_parameters = {},
          .parameters = {},
          .lowest = .95,
          .highest = 1.05,
          .min_n = 256,
          .max_n = 4096};
}

Point circumcentre(const Point& a, const Point& b, const Point& c) {
  const Point ab = {b.x - a.x, b.y - a.y}, ac = {c.x - a.x, c.y - a.y};
  const double ab_squared = ab.x * ab.x + ab.y * ab.y, ac_squared = ac.x * ac.x + ac.y * ac.y;
  const double twice_area = ab.x * ac.y - ab.y * ac.x;
  return {a.x + (ac.y * ab_squared - ab.y * ac_squared) / (2 * twice_area),
          a.y + (ab.x * ac_squared - ac.x * ab_squared) / (2 * twice_area)};
}

// p turned clockwise about the centre, so far that it moves by about `distance`.
Point moved_on_circle(const Point& p, const Point& centre, double distance) {
  const Point arm = {p.x - centre.x, p.y - centre.y};
  const double radius = std::sqrt(arm.x * arm.x + arm.y * arm.y);
  const double half_tangent = distance / (2 * radius);
  const double scale = 1 + half_tangent * half_tangent;
  const double cosine = (1 - half_tangent * half_tangent) / scale, sine = -2 * half_tangent / scale;
  return {centre.x + (arm.x * cosine - arm.y * sine), centre.y + (arm.x * sine + arm.y * cosine)};
}

}  // namespace

GeneratorInfo delaunay_flip_stuck_entry() {
  return {.name = "delaunay_flip_stuck",
          .summary = "Delaunay is a factor of order n above the optimum, and flips from there find nothing better",
          .source = "made for this project, after Kirkpatrick, IPL 10 (1980)",
          .stresses = "delaunay, and flip from its default start; greedy solves it",
          .law = "alpha of delaunay and of flip grows like n (3.89 at n = 16, 267 at 1024)",
          .min_n = 6,
          .max_n = kMaxDelaunayFlipStuck,
          .seeded = false,
          .parameters = {},
          .growth_laws = {linear_growth("delaunay"), linear_growth("flip")},
          .function = [](Index n, std::uint64_t, const Parameters&) { return delaunay_flip_stuck_points(n); }};
}

std::vector<Point> delaunay_flip_stuck_points(Index n) {
  constexpr double kBend = .01, kWidth = .125;
  const Index k = n - 4;
  const double far = 2.0 * k;
  std::vector<Point> points;
  points.reserve(n);
  for (Index i = 0; i < k; ++i) {
    const double s = kWidth * (k - 1 - i) / (k - 1);
    points.push_back({0 - s, 0 - kBend / far * (s * s) / (2 * kWidth)});
  }
  const Point v = {1, -.1 / far}, w_0 = {1.6, .1 / far};
  const Point w_2 = {far * (std::sqrt(3.0) / 2), far / 2};
  const Point centre = circumcentre(v, {1.6, .2 / far}, w_2);
  points.insert(points.end(), {v, w_0, moved_on_circle(w_2, centre, .9), w_2});
  return points;
}

}  // namespace mwt
