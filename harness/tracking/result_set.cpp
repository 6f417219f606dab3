#include "harness/tracking/result_set.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/text/csv.h"
#include "harness/tracking/old_names.h"

namespace mwt {

namespace {

/// For every known column its place in the file's header, or none.
template <class Record>
std::vector<std::optional<std::size_t>> places_of(const std::vector<Column<Record>>& columns, const CsvRow& header) {
  std::vector<std::optional<std::size_t>> places;
  for (const Column<Record>& column : columns) {
    const auto found = std::find_if(header.begin(), header.end(),
                                    [&](const std::string& name) { return present_name(name) == column.name; });
    places.push_back(found == header.end() ? std::nullopt : std::optional(found - header.begin()));
  }
  return places;
}

[[noreturn]] void refuse(const std::string& place, const std::string& what) { throw InputError(place + ": " + what); }

/// The columns of the present version are where they belong; more of them may follow, from builds that add some.
void require_columns(const std::string& file, const CsvRow& header, const std::vector<std::string>& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (i < header.size() && header[i] == expected[i]) continue;
    const std::string found = i < header.size() ? "'" + header[i] + "'" : "nothing";
    refuse(file,
           fmt::format("column {} is {} where schema version {} has '{}'; the file was altered: run the study anew",
                       i + 1, found, kSchemaVersion, expected[i]));
  }
}

void require_names(const std::string& file, const CsvRow& header, const std::vector<std::string>& needed) {
  for (const std::string& name : needed) {
    if (std::find(header.begin(), header.end(), name) == header.end())
      refuse(file, "has no column '" + name + "'; is this a study's results?");
  }
}

template <class Record>
Record record_of(const std::vector<Column<Record>>& columns, const std::vector<std::optional<std::size_t>>& places,
                 const CsvRow& row, const std::string& line) {
  Record record;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    try {
      if (places[i]) columns[i].read(record, row[*places[i]]);
    } catch (const std::invalid_argument& text) {
      refuse(line, std::string("'") + text.what() + "' is no " + columns[i].name);
    }
  }
  return record;
}

/// A file's records, all of one schema version.
template <class Record>
struct Table {
  std::vector<Record> records;
  int schema_version = kSchemaVersion;
};

template <class Record>
Table<Record> read_table(const std::string& file, const std::vector<Column<Record>>& columns, std::size_t first_columns,
                         std::vector<std::string> needed) {
  const std::vector<CsvRow> rows = parse_csv(read_file(file));
  const CsvRow header = rows.empty() ? CsvRow{} : rows.front();
  needed.emplace_back("schema_version");
  require_names(file, header, needed);
  const auto places = places_of(columns, header);
  Table<Record> table;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const std::string line = fmt::format("{}:{}", file, row + 1);
    if (rows[row].size() != header.size()) refuse(line, "malformed row");
    const Record& record = table.records.emplace_back(record_of(columns, places, rows[row], line));
    if (row == 1) table.schema_version = record.schema_version;
    const std::string version = fmt::format("schema version {}", record.schema_version);
    if (record.schema_version < 1 || record.schema_version > kSchemaVersion)
      refuse(line, version + " is unknown here; use the mwt that wrote it");
    if (record.schema_version != table.schema_version)
      refuse(line, fmt::format("{} after rows of version {}", version, table.schema_version));
  }
  const CsvRow expected = header_of(columns);
  const auto end = expected.begin() + static_cast<std::ptrdiff_t>(first_columns);
  if (table.schema_version == kSchemaVersion) require_columns(file, header, {expected.begin(), end});
  return table;
}

/// Whether a run of one thread used no CPU time, or more than there was: its clock ticked, by 1 to 10 ms.
bool shows_ticks(const RunRecord& run) {
  constexpr double kMaxOverhead = 1.5;
  if (run.status != RunStatus::ok || run.threads != 1 || !run.cpu_time_s || !run.wall_time_s) return false;
  return *run.cpu_time_s == 0 || *run.cpu_time_s > kMaxOverhead * *run.wall_time_s;
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
  Table<RunRecord> runs = read_table((path / "runs.csv").string(), run_columns(), kFirstRunColumns,
                                     {"algorithm", "params", "generator", "n", "seed", "status", "git_commit"});
  results.runs = std::move(runs.records);
  for (RunRecord& run : results.runs) {
    run.algorithm = present_name(run.algorithm);
    run.params = present_params(run.algorithm, run.params);
  }
  results.schema_version = runs.schema_version;
  results.has_ticking_clock = std::any_of(results.runs.begin(), results.runs.end(), shows_ticks);
  const std::string study_file = (path / "study.toml").string();
  if (std::filesystem::exists(study_file)) results.study_file = read_file(study_file);
  const std::string environments = (path / "environments.csv").string();
  if (std::filesystem::exists(environments)) {
    results.environments =
        read_table(environments, environment_columns(), kFirstEnvironmentColumns, {"env_id"}).records;
  }
  return results.has_ticking_clock ? without_short_cpu_times(std::move(results)) : results;
}

ResultSet without_short_cpu_times(ResultSet results) {
  constexpr double kHundredTicks = 0.4;  // s, of 4 ms each
  for (RunRecord& run : results.runs) {
    const double measured = run.cpu_time_s.value_or(0) * static_cast<double>(run.iterations.value_or(1));
    if (measured < kHundredTicks) run.cpu_time_s.reset();
  }
  return results;
}

}  // namespace mwt
