// What an algorithm did, step by step, for the page to play.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algorithms/algorithm.h"
#include "geometry/point_set.h"

namespace mwt {

struct ProofTrace;  // algorithms/proof_trace.h
struct StepTrace;   // algorithms/step_trace.h

/// One step. Which of the points a, b, c, d and of the value it has depends on its kind.
struct PlayedStep {
  enum class Kind : std::uint32_t {
    add,      ///< edge ab joins the picture
    remove,   ///< edge ab leaves it; it crosses edge cd, if that is none from kNoIndex
    flip,     ///< edge cd replaces edge ab; value: how much shorter it is
    certain,  ///< edge ab is in every minimum weight triangulation
    open,     ///< edge ab is a candidate that linear programming weighs; value: its price, from 0 to 1
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

/// From the edges at the start to those of the solution. Points are positions in the input.
struct PlayedSteps {
  std::vector<Edge> start;
  std::vector<PlayedStage> stages;
  std::vector<PlayedStep> steps;
};

/// The flips of a solution, in order, from the triangulation that they began with.
[[nodiscard]] PlayedSteps played_flips(const Solution& solution, const PointSet& set);

/// The stages of an exact solver by the proof of its solution: the edges that pass the diamond test; those that leave,
/// in the order of the conclusions; those that are certain; those that remain open, with their dual values; the
/// solution.
[[nodiscard]] PlayedSteps played_proof(const ProofTrace& proof, const Solution& solution, const PointSet& set);

/// What an algorithm noted: the edges that greedy takes, or points inserted one by one.
[[nodiscard]] PlayedSteps played_trace(const StepTrace& trace, const PointSet& set);

/// As bytes: the values of the steps (doubles), kind, a, b, c, d of each, and the edges at the start.
[[nodiscard]] std::string bytes_of(const PlayedSteps& played);

}  // namespace mwt
