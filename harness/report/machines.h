// Times of different machines say nothing together: a report's times are those of one.
#pragma once

#include <string>
#include <vector>

#include "harness/records/results_folder.h"

namespace mwt {

/// Empties the times (wall, CPU, Delaunay time) of all runs but those of the machine that has most successful ones (of
/// equal numbers the first by name). Runs side by side count as another machine: they disturb each other. Everything
/// else about the runs stays.
///
/// Returns what the reader must be told, one line each; nothing if one machine and one build ran all of them. Runs of
/// several builds are told, too; their times stay, for whoever resumed a study with another build wanted that. So is a
/// machine that was busy with other programs: wall times are longer then, those of long runs most.
[[nodiscard]] std::vector<std::string> keep_times_of_one_machine(StudyRecords& records);

}  // namespace mwt
