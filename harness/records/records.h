// The records of a study: what a row of runs.csv, instances.csv and environments.csv holds.
//
// The column lists here are the only ones in the code; results/README.md explains every column, and a test holds the
// two together. Columns never move or change meaning within a schema version.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "harness/io/columns.h"
#include "harness/rating/proof_check.h"
#include "harness/rating/rated_run.h"

namespace mwt {

inline constexpr int kSchemaVersion = 3;

/// The columns that every runs.csv, instances.csv and environments.csv of this version begins with; those after them
/// were added later.
inline constexpr std::size_t kFirstRunColumns = 43;
inline constexpr std::size_t kFirstInstanceColumns = 18;
inline constexpr std::size_t kFirstEnvironmentColumns = 20;

/// One repetition of one algorithm on one instance: what was run, and what came of it.
struct RunRecord : RatedRun {
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
};

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
  std::optional<ProofVerdict> verified;  ///< what the verifier says of the proof
  std::string proof_note;
  std::optional<double> verify_time_s;
  std::optional<std::uint64_t> proof_bytes;
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

[[nodiscard]] const std::vector<Column<RunRecord>>& run_columns();
[[nodiscard]] const std::vector<Column<InstanceRecord>>& instance_columns();
[[nodiscard]] const std::vector<Column<EnvironmentRecord>>& environment_columns();

/// Throws std::invalid_argument if fields contradict each other: the ends of an interval, or a finished run without
/// what such a run has.
void require_consistent(const RunRecord& record);
void require_consistent(const InstanceRecord& record);
void require_consistent(const EnvironmentRecord& record);

/// The record of a row. Throws std::invalid_argument as read_row(), and if the record is not consistent.
template <class Record>
[[nodiscard]] Record record_of(const std::vector<Column<Record>>& columns, const CsvRow& row) {
  Record record = read_row(columns, row);
  require_consistent(record);
  return record;
}

/// "uniform n=100 seed=1", with the generator's parameters: the instance of a row, for messages.
template <class Record>
[[nodiscard]] std::string label_of_instance(const Record& record) {
  return name_with_parameters(record.generator, record.generator_params) + " n=" + std::to_string(record.n) +
         " seed=" + std::to_string(record.seed);
}

}  // namespace mwt
