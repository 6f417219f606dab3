// What it costs to start the commands of a study: a part of every time that is measured of them.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "harness/study/plan.h"

namespace mwt {

/// Wall times in seconds by the commands' names: of a run on three points, the shortest of three, each in a process of
/// its own, with the limits of the study. Commands of which all runs are recorded are left out; one that does not solve
/// that instance has no time. `announce` gets a line for each. Folders of commands that were killed are removed before.
[[nodiscard]] std::map<std::string, double> measure_command_starts(
    const Study& study, const Plan& plan, const std::set<std::string>& recorded,
    const std::function<void(const std::string& line)>& announce);

}  // namespace mwt
