// The history for other programs: plots, spreadsheets, the dashboard.
#pragma once

#include <string>
#include <vector>

#include "harness/tracking/history/changes.h"
#include "harness/tracking/history/night.h"

namespace mwt {

/// One row per night, cell and measure, with a header: night (counted from 0), recorded_at, git_commit, environment,
/// machine, study, algorithm, params, threads, generator, generator_params, n, seed, measure, value, runs,
/// configuration (nights of the same commit, environment and study differ in it).
[[nodiscard]] std::string history_csv(const std::vector<Night>& nights);

/// An array with one object per change: study, environment, algorithm, aspect, regression, night, recorded_at, commit,
/// previous_commit, factor, text, and steps: [{instance, params, threads, generator, generator_params, n, measure,
/// night, before, after}].
[[nodiscard]] std::string changes_json(const std::vector<Change>& changes, const std::vector<Night>& nights);

/// All that a dashboard shows, one object: nights [{recorded_at, commit, environment, machine, study}], series [{study,
/// environment, algorithm (with its parameters), instance (family with its parameters), n, measure, aspect, unit,
/// nights, values}] as series_of() makes them, and changes as changes_json() writes them.
[[nodiscard]] std::string series_json(const std::vector<Change>& changes, const std::vector<Night>& nights);

}  // namespace mwt
