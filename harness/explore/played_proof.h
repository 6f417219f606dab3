// The stages of an exact solver, by the proof of its solution.
#pragma once

#include "algorithms/proof_trace.h"
#include "algorithms/step_trace.h"
#include "harness/explore/played_steps.h"

namespace mwt {

/// The edges that pass the diamond test; those that leave, in the order of the conclusions; those that are certain;
/// those that remain open, with their dual values; the cuts; the solution. Steps show points that are the reason.
[[nodiscard]] PlayedSteps played_proof(const ProofTrace& proof, const StepTrace& steps, const Solution& solution,
                                       const PointSet& set);

}  // namespace mwt
