// The records of a study: what a row of runs.csv, instances.csv and environments.csv holds.
//
// The column lists here are the only ones in the code; results/README.md explains every column, and a test holds the
// two together. Columns never move or change meaning within a schema version.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/stop_reason.h"
#include "geometry/numbers/interval.h"
#include "geometry/point.h"
#include "harness/io/text/csv.h"
#include "harness/io/text/text.h"
#include "harness/run/status.h"

namespace mwt {

inline constexpr int kSchemaVersion = 3;

/// The columns that every runs.csv and environments.csv of this version begins with; those after them were added later.
inline constexpr std::size_t kFirstRunColumns = 43;
inline constexpr std::size_t kFirstEnvironmentColumns = 20;

/// One repetition of one algorithm on one instance. Measures are empty unless the run came to have them.
struct RunRecord {
  int schema_version = kSchemaVersion;
  std::string run_id;
  std::string study;
  std::string env_id;
  std::string recorded_at;
  std::string git_commit;
  std::string binary_sha256;
  std::string algorithm;
  std::string params;
  std::string generator;
  std::string generator_params;
  Index n = 0;
  std::uint64_t seed = 0;
  std::string instance_id;
  int repetition = 0;
  int threads = 1;
  double time_limit_s = 0;
  std::uint64_t memory_limit_bytes = 0;
  RunStatus status = RunStatus::error;
  std::string checker;
  std::string message;
  std::optional<double> wall_time_s;
  std::optional<double> cpu_time_s;
  std::optional<std::uint64_t> iterations;
  std::optional<std::uint64_t> peak_rss_bytes;
  std::optional<double> weight_lower;
  std::optional<double> weight_upper;
  std::optional<double> certified_lower;
  std::optional<double> optimum_lower;
  std::optional<double> optimum_upper;
  std::string optimality;
  std::optional<double> alpha_lower;
  std::optional<double> alpha_upper;
  std::string optimal;
  std::optional<bool> stopped_early;
  std::optional<double> perimeter_sum;
  std::optional<std::uint64_t> triangles;
  std::optional<std::uint64_t> edges;
  std::string triangulation_count;
  std::string phases;
  std::string counters;
  std::optional<double> delaunay_time_s;
  std::optional<StopReason> stop_reason;
};

/// The optimum_note of an instance whose optimum came from the optimum cache.
inline constexpr const char* kCachedNote = "cached";

/// One instance, written when its optimum has been sought.
struct InstanceRecord {
  int schema_version = kSchemaVersion;
  std::string instance_id;
  std::string study;
  std::string env_id;
  std::string recorded_at;
  std::string generator;
  std::string generator_params;
  Index n = 0;
  std::uint64_t seed = 0;
  Index distinct = 0;
  Index duplicates = 0;
  Index hull_size = 0;
  std::optional<double> optimum_lower;
  std::optional<double> optimum_upper;
  std::string optimality;
  std::string optimum_source;
  std::optional<double> optimum_time_s;
  std::string optimum_note;
};

/// The machine, the program and the state of both when a `mwt run` began.
struct EnvironmentRecord {
  int schema_version = kSchemaVersion;
  std::string env_id;
  std::string study;
  std::string recorded_at;
  std::string git_commit;
  std::string binary_sha256;
  std::string cpu_model;
  std::optional<std::uint64_t> logical_cpus;
  std::optional<std::uint64_t> memory_bytes;
  std::string operating_system;
  std::string kernel;
  std::string compiler;
  std::string compiler_flags;
  std::string governor;
  std::string turbo;
  std::optional<double> load_1min;
  std::optional<std::uint64_t> swap_used_bytes;
  int jobs = 1;
  std::string shard;
  std::optional<std::uint64_t> throttle_events;
};

template <class Record>
struct Column {
  std::string name;
  std::function<std::string(const Record&)> text_of;
  std::function<void(Record&, const std::string&)> read;  ///< throws std::invalid_argument on malformed text, NaN
                                                          ///< and times that are none
};

[[nodiscard]] const std::vector<Column<RunRecord>>& run_columns();
[[nodiscard]] const std::vector<Column<InstanceRecord>>& instance_columns();
[[nodiscard]] const std::vector<Column<EnvironmentRecord>>& environment_columns();

template <class Record>
[[nodiscard]] CsvRow header_of(const std::vector<Column<Record>>& columns) {
  CsvRow row;
  for (const Column<Record>& column : columns) row.push_back(column.name);
  return row;
}

template <class Record>
[[nodiscard]] CsvRow to_row(const std::vector<Column<Record>>& columns, const Record& record) {
  CsvRow row;
  for (const Column<Record>& column : columns) row.push_back(column.text_of(record));
  return row;
}

/// Throws std::invalid_argument if fields contradict each other: the ends of an interval, or a finished run without
/// what such a run has.
void require_consistent(const RunRecord& record);
void require_consistent(const InstanceRecord& record);
void require_consistent(const EnvironmentRecord& record);

/// The record of a row. Throws std::invalid_argument "'nan' is no wall_time_s" if the row has a malformed field or
/// another number of fields than columns, or is not consistent.
template <class Record>
[[nodiscard]] Record record_of(const std::vector<Column<Record>>& columns, const CsvRow& row);

/// The record of a row that need not be consistent yet, or nothing.
template <class Record>
[[nodiscard]] std::optional<Record> from_row(const std::vector<Column<Record>>& columns, const CsvRow& row);

/// The optimum of a row as an interval, if it has one.
template <class Record>
[[nodiscard]] std::optional<Interval> optimum_of(const Record& record) {
  if (!record.optimum_lower || !record.optimum_upper) return std::nullopt;
  return Interval{*record.optimum_lower, *record.optimum_upper};
}

/// "uniform n=100 seed=1", with the generator's parameters: the instance of a row, for messages.
template <class Record>
[[nodiscard]] std::string label_of_instance(const Record& record) {
  return name_with_parameters(record.generator, record.generator_params) + " n=" + std::to_string(record.n) +
         " seed=" + std::to_string(record.seed);
}

/// "name=value name=value", values in their shortest form: phases and counters in one field. Blanks in names become
/// '_'.
template <class NamedNumbers>
[[nodiscard]] std::string named_numbers(const NamedNumbers& numbers);

}  // namespace mwt
