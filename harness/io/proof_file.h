// Writes what a solver noted on its way as a proof file: verifier/FORMAT.md.
#pragma once

#include <string>

#include "algorithms/proof_trace.h"
#include "geometry/numbers/interval.h"
#include "geometry/triangulation.h"

namespace mwt {

/// Preconditions: the trace is complete (ProofTrace::is_complete), the triangulation valid, `claimed` the solver's
/// bounds on the optimum. The file claims those, but a lower end no better than what the trace proves.
/// The file appears complete or not at all (output_file.h). Throws InputError: cannot be written.
/// Returns the interval that the file claims. O(n) and the compression: about 1 s per million points.
Interval write_proof(const std::string& path, Points points, const ProofTrace& trace,
                     const Triangulation& triangulation, const Interval& claimed);

}  // namespace mwt
