// Times of different machines cannot be compared: the times of a report are those of one machine.
#pragma once

#include <string>
#include <vector>

#include "harness/records/results_folder.h"

namespace mwt {

/// Empties the times (wall, CPU, Delaunay time) of all runs but those of the machine that has most successful ones (of
/// equal numbers the first by name). Runs side by side count as another machine: they disturb each other. Everything
/// else about the runs stays.
///
/// Returns warnings for the reader, one line each; none if one machine and one build ran all of them. Runs of several
/// builds are a warning, too, but their times stay, since the user chose to resume the study with another build. So is
/// a machine that was busy with other programs: wall times are longer then, those of long runs most.
[[nodiscard]] std::vector<std::string> keep_times_of_one_machine(StudyRecords& records);

}  // namespace mwt
