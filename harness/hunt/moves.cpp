#include "harness/hunt/moves.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mwt {

namespace {

struct Box {
  Point low;
  Point high;

  [[nodiscard]] double extent() const { return std::max(high.x - low.x, high.y - low.y); }
};

Box bounding_box(const std::vector<Point>& points) {
  Box box{points[0], points[0]};
  for (const Point& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

class Mutation {
 public:
  Mutation(std::vector<Point> points, RandomEngine& engine)
      : points_(std::move(points)), engine_(engine), box_(bounding_box(points_)) {}

  std::vector<Point> run() {
    move();
    while (uniform_below(engine_, 3) == 0) move();
    rescale();
    return std::move(points_);
  }

 private:
  void move() {
    Point& chosen = points_[uniform_below(engine_, points_.size())];
    switch (uniform_below(engine_, 8)) {
      case 0:
      case 1:
      case 2: chosen = shifted(chosen); break;
      case 3: shift_all(); break;
      case 4: chosen = anywhere(); break;
      case 5: chosen = shifted(any_point()); break;
      case 6: chosen = shifted(on_some_line()); break;
      default: stretch(); break;
    }
  }

  // Alpha does not depend on the scale, so steps that keep it would let the coordinates drift without end.
  void rescale() {
    const Box box = bounding_box(points_);
    const double extent = box.extent();
    if (!(extent > 0) || (extent > .25 && extent < 4)) return;
    for (Point& p : points_) p = {(p.x - box.low.x) / extent, (p.y - box.low.y) / extent};
  }

  [[nodiscard]] double random_distance() { return box_.extent() * std::exp2(-13.3 * uniform_unit(engine_)); }

  [[nodiscard]] Point shifted(const Point& p) { return shifted(p, random_distance()); }
  [[nodiscard]] Point shifted(const Point& p, double distance) {
    const Point direction = standard_normal_point(engine_);
    return {p.x + distance * direction.x, p.y + distance * direction.y};
  }

  void shift_all() {
    const double distance = random_distance() / static_cast<double>(points_.size());
    for (Point& p : points_) p = shifted(p, distance);
  }

  [[nodiscard]] Point any_point() { return points_[uniform_below(engine_, points_.size())]; }

  [[nodiscard]] Point anywhere() {
    const Point unit = uniform_in_square(engine_);
    return {box_.low.x + unit.x * (box_.high.x - box_.low.x), box_.low.y + unit.y * (box_.high.y - box_.low.y)};
  }

  [[nodiscard]] Point on_some_line() {
    const Point a = any_point(), b = any_point();
    const double place = 2 * uniform_unit(engine_) - .5;
    return {a.x + place * (b.x - a.x), a.y + place * (b.y - a.y)};
  }

  void stretch() {
    const double factor = std::exp2(2 * uniform_unit(engine_) - 1);
    for (Point& p : points_) p.y = box_.low.y + factor * (p.y - box_.low.y);
  }

  std::vector<Point> points_;
  RandomEngine& engine_;
  Box box_;
};

}  // namespace

std::vector<Point> random_start(Index n, RandomEngine& engine) {
  std::vector<Point> points;
  for (Index i = 0; i < n; ++i) points.push_back(uniform_in_square(engine));
  return points;
}

std::vector<Point> mutated(std::vector<Point> points, RandomEngine& engine) {
  return Mutation(std::move(points), engine).run();
}

}  // namespace mwt
