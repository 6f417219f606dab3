// Flips with what a search by flips reports: counts, a trace if requested, whether the deadline stopped it.
#pragma once

#include <utility>

#include "algorithms/flip/flip.h"
#include "algorithms/flip/improving_flip.h"

namespace mwt {

/// Does the flips of one search on one mesh; both must outlive it.
class CountedFlips {
 public:
  CountedFlips(PlanarMesh& mesh, const Context& context, bool with_trace)
      : mesh_(mesh), context_(context), with_trace_(with_trace) {}

  /// To be called before every look at an edge; reads the clock the first time, and then now and then. So a search
  /// whose start the deadline has cut short reports that it was stopped.
  [[nodiscard]] bool out_of_time() {
    if (result_.tests++ % 4096 == 0 && context_.deadline_passed()) result_.stopped_early = true;
    return result_.stopped_early;
  }

  void flip(MeshEdge e) {
    ++result_.flips;
    if (!with_trace_) return mesh_.flip(e);
    const Edge removed = mesh_.labelled_edge(e);
    const double gain = gain_of(mesh_, e) * mesh_.unit();
    mesh_.flip(e);
    result_.trace.push_back({removed, mesh_.labelled_edge(e), gain});
  }

  /// Turns the last flip of e back; the trace keeps it. Precondition: e's neighbours are as right after that flip.
  void take_back(MeshEdge e) {
    for (int quarter_turn = 0; quarter_turn < 3; ++quarter_turn) mesh_.flip(e);
    --result_.flips;
  }

  [[nodiscard]] bool stopped_early() const { return result_.stopped_early; }
  [[nodiscard]] FlipResult take_result() { return std::move(result_); }

 private:
  PlanarMesh& mesh_;
  const Context& context_;
  bool with_trace_;
  FlipResult result_;
};

}  // namespace mwt
