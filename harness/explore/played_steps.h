// What an algorithm did, step by step, for the page to play.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "algorithms/algorithm.h"
#include "geometry/point_set.h"

namespace mwt {

struct StepTrace;  // algorithms/step_trace.h

/// One step. Which of the numbers a, b, c, d and of the value it has depends on its kind.
struct PlayedStep {
  enum class Kind : std::uint32_t {
    add,      ///< edge ab joins the picture
    remove,   ///< edge ab leaves it; it crosses edge cd, if that is none from kNoIndex
    flip,     ///< edge cd replaces edge ab; value: how much shorter it is
    certain,  ///< edge ab is in every minimum weight triangulation
    open,     ///< edge ab is a candidate that linear programming weighs; value: its price, from 0 to 1
    group,    ///< the next a steps are one: point b is inserted, or if b is kNoIndex edges are replaced that are longer
              ///< by the value
    cell,     ///< box a of a quadtree, a leaf with c points if that is not kNoIndex; the next b steps are one with it
    cut,      ///< edge ab cuts a face open
    pass,     ///< edge ab joins: of the triangles left and right of it that its diamond consists of, the left one holds
              ///< c and the right one d, and one of them no point (kNoIndex)
    refute,   ///< edge ab leaves: c and d are corners left and right of it of empty triangles of candidates, and edge
              ///< cd would be shorter; kNoIndex: there is no such triangle on that side
  };
  Kind kind = Kind::add;
  Index a = kNoIndex;
  Index b = kNoIndex;
  Index c = kNoIndex;
  Index d = kNoIndex;
  double value = 0;
};

/// A part of the steps, and why its edges come or go.
struct PlayedStage {
  std::string name;
  std::string reason;
  std::size_t begin = 0;  ///< its first step
};

struct PlayedBox {
  double left = 0;
  double bottom = 0;
  double right = 0;
  double top = 0;
};

/// From the edges at the start to those of the solution. Points are positions in the input.
struct PlayedSteps {
  std::vector<Edge> start;
  std::vector<PlayedStage> stages;
  std::vector<PlayedStep> steps;
  std::vector<PlayedBox> boxes;

  void begin_stage(std::string name, std::string reason);
  void add(PlayedStep::Kind kind, const Edge& edge, const Edge& other = {kNoIndex, kNoIndex}, double value = 0);

  /// A last stage in which the edges of `shown` that are not of the solution leave, and the others join: none if they
  /// are the same.
  void arrive_at(const Solution& solution, const PointSet& set, const std::set<Edge>& shown, const std::string& name,
                 const std::string& reason);
};

/// The flips of a solution, in order, from the triangulation that they began with.
[[nodiscard]] PlayedSteps played_flips(const Solution& solution, const PointSet& set);

/// What an algorithm noted: greedy's edges, points inserted, patches, flips of annealing, or a quadtree.
[[nodiscard]] PlayedSteps played_trace(const StepTrace& trace, const Solution& solution, const PointSet& set);

/// Of a solution by positions in the input.
[[nodiscard]] std::vector<Edge> edges_in_input(const Solution& solution, const PointSet& set);

/// As bytes: the values of the steps (doubles), the boxes, kind, a, b, c, d of each step, and the edges at the start.
[[nodiscard]] std::string bytes_of(const PlayedSteps& played);

}  // namespace mwt
