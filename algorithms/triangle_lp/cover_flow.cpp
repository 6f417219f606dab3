#include "algorithms/triangle_lp/cover_flow.h"

#include <algorithm>
#include <cmath>

namespace mwt {

namespace {

double cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }
Point difference(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }

// The cover's triangles as columns of the model, and which of them lies left of each side.
class CoverTriangles {
 public:
  CoverTriangles(const CoverModel& model, std::span<const Triangle> cover)
      : left_of_(model.side_cost.size(), kNoIndex) {
    std::vector<Triangle> wanted(cover.begin(), cover.end());
    std::sort(wanted.begin(), wanted.end());
    for (const CoverModel::Column& column : model.columns) {
      if (!std::binary_search(wanted.begin(), wanted.end(), column.triangle)) continue;
      for (const Side side : column.sides) left_of_[side] = static_cast<Index>(columns_.size());
      columns_.push_back(&column);
    }
  }

  [[nodiscard]] std::size_t size() const { return columns_.size(); }
  [[nodiscard]] const CoverModel::Column& operator[](std::size_t i) const { return *columns_[i]; }
  [[nodiscard]] Index left_of(Side side) const { return left_of_[side]; }

 private:
  std::vector<const CoverModel::Column*> columns_;
  std::vector<Index> left_of_;
};

// The side by which each triangle is left on a shortest way to the boundary, and the triangles by increasing distance.
struct WaysOut {
  std::vector<Side> exit;
  std::vector<Index> order;
};

WaysOut ways_out(const CoverModel& model, const CoverTriangles& cover) {
  WaysOut ways;
  ways.exit.resize(cover.size());
  std::vector<bool> reached(cover.size(), false);
  const auto reach = [&](Index triangle, Side exit) {
    if (triangle == kNoIndex || reached[triangle]) return;
    reached[triangle] = true;
    ways.exit[triangle] = exit;
    ways.order.push_back(triangle);
  };
  for (Side side = 0; side < model.on_boundary.size(); ++side) {
    if (model.on_boundary[side]) reach(cover.left_of(side), side);
  }
  for (std::size_t i = 0; i < ways.order.size(); ++i) {
    for (const Side side : cover[ways.order[i]].sides) reach(cover.left_of(reversed(side)), reversed(side));
  }
  return ways;
}

// What flows out of each triangle of the cover through its sides.
std::vector<double> flow_through_sides(const CoverModel& model, const CoverTriangles& cover) {
  const WaysOut ways = ways_out(model, cover);
  std::vector<double> flow(model.side_cost.size(), 0);
  for (std::size_t i = ways.order.size(); i-- > 0;) {
    const CoverModel::Column& column = cover[ways.order[i]];
    const Side exit = ways.exit[ways.order[i]];
    double out = model.cost(column);
    for (const Side side : column.sides) out -= side == exit ? 0 : flow[side];
    flow[exit] = out;
    if (!model.on_boundary[exit]) flow[reversed(exit)] = -out;
  }
  return flow;
}

// The linear vector field in one triangle of the cover.
class TriangleFlow {
 public:
  // `corners` counter-clockwise; out[i] flows out through the side from corner i to the next.
  TriangleFlow(const std::array<Point, 3>& corners, const std::array<double, 3>& out)
      : corners_(corners),
        out_(out),
        area_twice_(cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]))) {}

  /// What flows from left to right through the part of segment pq in the triangle.
  [[nodiscard]] double through(const Point& p, const Point& q) const {
    double first = 0, last = 1;  // the part, as parameters along pq
    const Point along = difference(q, p);
    for (std::size_t i = 0; i < 3; ++i) {
      const Point side = difference(corners_[(i + 1) % 3], corners_[i]);
      const double height = cross(side, difference(p, corners_[i])), slope = cross(side, along);
      if (slope > 0) first = std::max(first, -height / slope);
      if (slope < 0) last = std::min(last, -height / slope);
      if (slope == 0 && height < 0) return 0;
    }
    if (first >= last || area_twice_ <= 0) return 0;
    const double middle = 0.5 * (first + last);
    const Point at = {p.x + middle * along.x, p.y + middle * along.y};
    return (last - first) * cross(field(at), along);
  }

 private:
  [[nodiscard]] Point field(const Point& at) const {
    Point result;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point from_opposite = difference(at, corners_[(i + 2) % 3]);
      result.x += out_[i] / area_twice_ * from_opposite.x;
      result.y += out_[i] / area_twice_ * from_opposite.y;
    }
    return result;
  }

  std::array<Point, 3> corners_;
  std::array<double, 3> out_;
  double area_twice_;
};

std::vector<TriangleFlow> flows_in_triangles(const CoverTriangles& cover, const std::vector<double>& flow,
                                             const std::vector<Point>& points) {
  std::vector<TriangleFlow> result;
  for (std::size_t i = 0; i < cover.size(); ++i) {
    const auto& [a, b, c] = cover[i].triangle;
    const auto& [ab, bc, ca] = cover[i].sides;
    result.emplace_back(std::array{points[a], points[b], points[c]}, std::array{flow[ab], flow[bc], flow[ca]});
  }
  return result;
}

// The points that occur, relative to one of them and in the model's unit.
std::vector<Point> local_points(const CoverModel& model, Points points) {
  std::vector<Point> result(points.size());
  const Point& origin = points[model.edges.front().a];
  for (const Edge& edge : model.edges) {
    for (const Index v : {edge.a, edge.b}) {
      const Point relative = difference(points[v], origin);
      result[v] = {std::ldexp(relative.x, -model.exponent), std::ldexp(relative.y, -model.exponent)};
    }
  }
  return result;
}

}  // namespace

CoverDuals duals_of_cover(const CoverModel& model, Points points, std::span<const Triangle> cover) {
  CoverDuals duals{std::vector<double>(model.side_cost.size(), 0),
                   std::vector<EdgeDecision>(model.edges.size(), EdgeDecision::open)};
  const CoverTriangles triangles(model, cover);
  if (triangles.size() == 0) return duals;
  const std::vector<Point> local = local_points(model, points);
  const std::vector<double> flow = flow_through_sides(model, triangles);
  const std::vector<TriangleFlow> fields = flows_in_triangles(triangles, flow, local);
  for (std::uint32_t edge = 0; edge < model.edges.size(); ++edge) {
    const Side forward = forward_side(edge), backward = backward_side(edge);
    const bool in_cover = triangles.left_of(forward) != kNoIndex || triangles.left_of(backward) != kNoIndex;
    if (in_cover) {
      duals.of_side[forward] = flow[forward];
      duals.of_side[backward] = flow[backward];
      continue;
    }
    double through = 0;
    for (const TriangleFlow& field : fields)
      through += field.through(local[model.edges[edge].a], local[model.edges[edge].b]);
    // In slivers the field may be huge, by right or by rounding; such a guess would drown all other costs.
    if (!(std::abs(through) <= model.max_cover_cost)) continue;
    duals.of_side[forward] = through;
    duals.of_side[backward] = -through;
  }
  return duals;
}

}  // namespace mwt
