#include "harness/tracking/result_set.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "geometry/error.h"
#include "geometry/input_file.h"
#include "harness/csv.h"

namespace mwt {

namespace {

/// For every known column its place in the file's header, or none.
template <class Record>
std::vector<std::optional<std::size_t>> places_of(const std::vector<Column<Record>>& columns, const CsvRow& header) {
  std::vector<std::optional<std::size_t>> places;
  for (const Column<Record>& column : columns) {
    const auto found = std::find(header.begin(), header.end(), column.name);
    places.push_back(found == header.end() ? std::nullopt : std::optional(found - header.begin()));
  }
  return places;
}

template <class Record>
std::vector<Record> read_table(const std::string& file, const std::vector<Column<Record>>& columns,
                               const std::vector<std::string>& needed) {
  const std::vector<CsvRow> rows = parse_csv(read_file(file));
  const CsvRow header = rows.empty() ? CsvRow{} : rows.front();
  for (const std::string& name : needed) {
    if (std::find(header.begin(), header.end(), name) == header.end())
      throw InputError(file + ": has no column '" + name + "'; is this a study's results?");
  }
  const auto places = places_of(columns, header);
  std::vector<Record> records;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const std::string line = file + ':' + std::to_string(row + 1);
    if (rows[row].size() != header.size()) throw InputError(line + ": malformed row");
    Record& record = records.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      try {
        if (places[i]) columns[i].read(record, rows[row][*places[i]]);
      } catch (const std::invalid_argument& text) {
        throw InputError(line + ": '" + text.what() + "' is no " + columns[i].name);
      }
    }
  }
  return records;
}

}  // namespace

EnvironmentRecord ResultSet::environment_of(const RunRecord& run) const {
  const auto found = std::find_if(environments.begin(), environments.end(), [&](const EnvironmentRecord& environment) {
    return environment.env_id == run.env_id;
  });
  return found == environments.end() ? EnvironmentRecord{} : *found;
}

ResultSet read_results(const std::string& folder) {
  const std::filesystem::path path(folder);
  ResultSet results;
  results.folder = folder;
  results.runs = read_table((path / "runs.csv").string(), run_columns(),
                            {"algorithm", "params", "generator", "n", "seed", "status", "git_commit"});
  const std::string environments = (path / "environments.csv").string();
  if (std::filesystem::exists(environments))
    results.environments = read_table(environments, environment_columns(), {"env_id"});
  return results;
}

std::string machine_of(const EnvironmentRecord& environment) {
  std::vector<std::string> parts;
  if (!environment.cpu_model.empty()) parts.push_back(environment.cpu_model);
  if (environment.logical_cpus) parts.push_back(std::to_string(*environment.logical_cpus) + " CPUs");
  if (environment.memory_bytes) {
    parts.push_back(std::to_string(std::lround(static_cast<double>(*environment.memory_bytes) / (1U << 30))) + " GiB");
  }
  std::string machine;
  for (const std::string& part : parts) machine += (machine.empty() ? "" : ", ") + part;
  return machine;
}

}  // namespace mwt
