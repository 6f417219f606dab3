// The history for other programs: plots, spreadsheets, the dashboard.
#pragma once

#include <string>
#include <vector>

#include "harness/tracking/history/changes.h"
#include "harness/tracking/history/nightly_run.h"

namespace mwt {

/// One row per nightly run, cell and measure, with a header: nightly run (counted from 0), recorded_at, git_commit,
/// environment, machine, study, algorithm, params, threads, generator, generator_params, n, seed, measure, value, runs,
/// configuration (nightly runs of the same commit, environment and study differ in it).
[[nodiscard]] std::string history_csv(const std::vector<NightlyRun>& nightly_runs);

/// An array with one object per change: study, environment, algorithm, aspect, regression, nightly run, recorded_at,
/// commit, previous_commit, factor, text, and steps: [{instance, params, threads, generator, generator_params, n,
/// measure, nightly run, before, after}].
[[nodiscard]] std::string changes_json(const std::vector<Change>& changes, const std::vector<NightlyRun>& nightly_runs);

/// All that a dashboard shows, one object: nightly runs [{recorded_at, commit, environment, machine, study}], series
/// [{study, environment, algorithm (with its parameters), instance (family with its parameters), n, measure, aspect,
/// unit, nightly runs, values}] as series_of() makes them, and changes as changes_json() writes them.
[[nodiscard]] std::string series_json(const std::vector<Change>& changes, const std::vector<NightlyRun>& nightly_runs);

}  // namespace mwt
