// The triangles of a region that was cut open whose sides cross cuts: what the polygon's program does not know.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/common/rows.h"
#include "algorithms/deadline.h"
#include "algorithms/exact/holes/cut_polygon.h"

namespace mwt {

/// Empty triangles of candidates with at least one side that crosses a cut ("loose"), by that side, and by the cuts'
/// ends whose first piece they contain. Triangles are numbered; numbers change in keep_alive().
class LooseTriangles {
 public:
  using Number = std::uint32_t;
  using Sides = std::array<std::uint32_t, 3>;  ///< halfedges, counter-clockwise

  /// `polygon` must stay alive.
  explicit LooseTriangles(const CutPolygon& polygon);

  /// Lists them. Nothing else may be called if this fails: there are more than `limit`, or the deadline passed. O(the
  /// stars of the crossing candidates' ends), and a search for each triangle.
  [[nodiscard]] bool find(std::size_t limit, const Deadline& deadline);

  [[nodiscard]] std::size_t size() const { return sides_.size(); }
  [[nodiscard]] const Sides& sides(Number triangle) const { return sides_[triangle]; }
  [[nodiscard]] std::span<const Number> left_of(std::uint32_t halfedge) const { return filed_[slot_[halfedge]]; }
  /// That contain the first piece of a cut at its end 0 (the smaller one) or 1.
  [[nodiscard]] std::span<const Number> straddling(std::size_t cut, std::size_t end) const { return ends_[cut][end]; }

  /// The candidates that cross cuts: the halfedge from the smaller end of each.
  [[nodiscard]] const std::vector<std::uint32_t>& crossing() const { return crossing_; }
  [[nodiscard]] std::size_t slots() const { return filed_.first.size() - 1; }
  /// Of a halfedge that crosses a cut; kNoIndex for others.
  [[nodiscard]] std::uint32_t slot(std::uint32_t halfedge) const { return slot_[halfedge]; }
  [[nodiscard]] Index origin(std::uint32_t halfedge) const { return origin_[halfedge]; }

  /// Drops the triangles and crossing candidates with a side that is not alive (by halfedge). Returns the old numbers
  /// of those that are left, ascending.
  std::vector<Number> keep_alive(const std::vector<bool>& is_alive);

 private:
  void list_crossing(const std::vector<bool>& is_alive);
  void add_triangles_of(std::uint32_t halfedge, std::vector<std::uint32_t>& at_first,
                        std::vector<std::uint32_t>& touched);
  [[nodiscard]] bool may_be_sides(const Sides& sides) const;
  void file_triangles();
  void list_straddling();

  const CutPolygon& polygon_;
  std::vector<Index> origin_;  // by halfedge
  std::vector<std::uint32_t> crossing_;
  std::vector<Sides> sides_;
  Rows<Number> filed_;                                    // by crossing halfedge (see slot_)
  std::vector<std::uint32_t> slot_;                       // by halfedge
  std::vector<std::array<std::vector<Number>, 2>> ends_;  // by cut
};

}  // namespace mwt
