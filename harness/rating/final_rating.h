// Rates every run by all that a study came to know, so that the same instances are rated for every algorithm.
#pragma once

#include "harness/records/results_folder.h"

namespace mwt {

/// The runs, with optimum, optimality, alpha and optimal as if all certified bounds in the records had been known from
/// the beginning: a row was written with what was known by then. What recorded triangulations disprove is no bound, and
/// the run that certified it an error. Rows of runs that are not ok stay as they are.
[[nodiscard]] std::vector<RunRecord> finally_rated(const StudyRecords& records);

}  // namespace mwt
