#include "harness/tracking/history/history_text.h"

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "harness/io/text/csv.h"

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

CsvRow row_of(std::size_t position, const Night& night, const NightValue& value) {
  const TrackedCell& cell = value.cell;
  return {std::to_string(position),
          night.recorded_at,
          night.git_commit,
          night.environment,
          night.machine,
          night.study,
          cell.algorithm,
          cell.params,
          std::to_string(cell.threads),
          cell.generator,
          cell.generator_params,
          std::to_string(cell.n),
          std::to_string(cell.seed),
          value.measure,
          number_text(value.value),
          std::to_string(value.runs),
          night.configuration};
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
          {"night", step.night},
          {"before", step.before},
          {"after", step.after}};
}

Json json_of(const Night& night) {
  return {{"recorded_at", night.recorded_at},
          {"commit", night.git_commit},
          {"environment", night.environment},
          {"machine", night.machine},
          {"study", night.study}};
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
          {"nights", series.nights},
          {"values", series.values}};
}

Json array_of(const std::vector<Change>& changes, const std::vector<Night>& nights) {
  Json array = Json::array();
  for (const Change& change : changes) {
    const Night& night = nights[change.night];
    Json object = {{"study", change.study},
                   {"environment", change.environment},
                   {"algorithm", change.algorithm},
                   {"aspect", name_of(change.aspect)},
                   {"regression", change.is_regression},
                   {"night", change.night},
                   {"recorded_at", night.recorded_at},
                   {"commit", night.git_commit},
                   {"previous_commit", nights[change.previous_night].git_commit},
                   {"factor", change.factor},
                   {"text", describe(change, nights)},
                   {"steps", Json::array()}};
    for (const SeriesStep& step : change.steps) object["steps"].push_back(json_of(step));
    array.push_back(std::move(object));
  }
  return array;
}

}  // namespace

std::string history_csv(const std::vector<Night>& nights) {
  std::string text =
      csv_line({"night", "recorded_at", "git_commit", "environment", "machine", "study", "algorithm", "params",
                "threads", "generator", "generator_params", "n", "seed", "measure", "value", "runs", "configuration"});
  for (std::size_t night = 0; night < nights.size(); ++night) {
    for (const NightValue& value : nights[night].values) text += csv_line(row_of(night, nights[night], value));
  }
  return text;
}

std::string changes_json(const std::vector<Change>& changes, const std::vector<Night>& nights) {
  return array_of(changes, nights).dump(1) + '\n';
}

std::string series_json(const std::vector<Change>& changes, const std::vector<Night>& nights) {
  Json night_array = Json::array();
  for (const Night& night : nights) night_array.push_back(json_of(night));
  Json series_array = Json::array();
  for (const Series& series : series_of(nights)) series_array.push_back(json_of(series));
  const Json object = {{"nights", night_array}, {"series", series_array}, {"changes", array_of(changes, nights)}};
  return object.dump() + '\n';
}

}  // namespace mwt
