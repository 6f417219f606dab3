// What `mwt run STUDY --dry-run` prints.
#pragma once

#include <ostream>

#include "harness/study/run_study.h"

namespace mwt {

/// Prints instances, runs, limits, and an estimate of the time with how sure it is: from what studies recorded on this
/// machine, in options.folder, beside it or in ./results, and from a calibration of some seconds. Writes nothing.
/// Throws InputError for everything that is wrong with the study.
void dry_run(const Study& study, const Catalogue& catalogue, const RunOptions& options, std::ostream& out);

}  // namespace mwt
