#include "harness/tracking/history/history_text.h"

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "harness/io/text/csv.h"

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

CsvRow row_of(std::size_t position, const NightlyRun& nightly_run, const NightlyValue& value) {
  const TrackedCell& cell = value.cell;
  return {std::to_string(position),     nightly_run.recorded_at, nightly_run.git_commit,   nightly_run.environment,
          nightly_run.machine,          nightly_run.study,       cell.algorithm,           cell.params,
          std::to_string(cell.threads), cell.generator,          cell.generator_params,    std::to_string(cell.n),
          std::to_string(cell.seed),    value.measure,           number_text(value.value), std::to_string(value.runs),
          nightly_run.configuration};
}

Json json_of(const SeriesStep& step) {
  const TrackedCell& cell = step.key.cell;
  return {{"instance", family_label(cell)},
          {"params", cell.params},
          {"threads", cell.threads},
          {"generator", cell.generator},
          {"generator_params", cell.generator_params},
          {"n", cell.n},
          {"measure", step.key.measure},
          {"nightly_run", step.nightly_run},
          {"before", step.before},
          {"after", step.after}};
}

Json json_of(const NightlyRun& nightly_run) {
  return {{"recorded_at", nightly_run.recorded_at},
          {"commit", nightly_run.git_commit},
          {"environment", nightly_run.environment},
          {"machine", nightly_run.machine},
          {"study", nightly_run.study}};
}

Json json_of(const Series& series) {
  const TrackedCell& cell = series.key.cell;
  const Measure& measure = measure_named(series.key.measure);
  return {{"study", series.key.study},
          {"environment", series.key.environment},
          {"algorithm", algorithm_label(cell)},
          {"instance", family_label(cell)},
          {"n", cell.n},
          {"measure", measure.name},
          {"aspect", name_of(measure.aspect)},
          {"unit", measure.unit},
          {"nightly_runs", series.nightly_runs},
          {"values", series.values}};
}

Json array_of(const std::vector<Change>& changes, const std::vector<NightlyRun>& nightly_runs) {
  Json array = Json::array();
  for (const Change& change : changes) {
    const NightlyRun& nightly_run = nightly_runs[change.nightly_run];
    Json object = {{"study", change.study},
                   {"environment", change.environment},
                   {"algorithm", change.algorithm},
                   {"aspect", name_of(change.aspect)},
                   {"regression", change.is_regression},
                   {"nightly_run", change.nightly_run},
                   {"recorded_at", nightly_run.recorded_at},
                   {"commit", nightly_run.git_commit},
                   {"previous_commit", nightly_runs[change.previous_nightly_run].git_commit},
                   {"factor", change.factor},
                   {"factor_lower", change.lower},
                   {"factor_upper", change.upper},
                   {"function", change.function},
                   {"text", describe(change, nightly_runs)},
                   {"steps", Json::array()}};
    for (const SeriesStep& step : change.steps) object["steps"].push_back(json_of(step));
    array.push_back(std::move(object));
  }
  return array;
}

}  // namespace

std::string history_csv(const std::vector<NightlyRun>& nightly_runs) {
  std::string text =
      csv_line({"nightly_run", "recorded_at", "git_commit", "environment", "machine", "study", "algorithm", "params",
                "threads", "generator", "generator_params", "n", "seed", "measure", "value", "runs", "configuration"});
  for (std::size_t nightly_run = 0; nightly_run < nightly_runs.size(); ++nightly_run) {
    for (const NightlyValue& value : nightly_runs[nightly_run].values)
      text += csv_line(row_of(nightly_run, nightly_runs[nightly_run], value));
  }
  return text;
}

std::string changes_json(const std::vector<Change>& changes, const std::vector<NightlyRun>& nightly_runs) {
  return array_of(changes, nightly_runs).dump(1) + '\n';
}

std::string series_json(const std::vector<Change>& changes, const std::vector<NightlyRun>& nightly_runs) {
  Json nightly_run_array = Json::array();
  for (const NightlyRun& nightly_run : nightly_runs) nightly_run_array.push_back(json_of(nightly_run));
  Json series_array = Json::array();
  for (const Series& series : series_of(nightly_runs)) series_array.push_back(json_of(series));
  const Json object = {
      {"nightly_runs", nightly_run_array}, {"series", series_array}, {"changes", array_of(changes, nightly_runs)}};
  return object.dump() + '\n';
}

}  // namespace mwt
