#include "harness/records/records.h"

#include <fmt/core.h>

#include <stdexcept>

namespace mwt {

const std::vector<Column<RunRecord>>& run_columns() {
  using R = RunRecord;
  static const std::vector<Column<R>> columns = [] {
    std::vector<Column<R>> all = {
        column<R>("schema_version", &R::schema_version),
        column<R>("run_id", &R::run_id),
        column<R>("study", &R::study),
        column<R>("env_id", &R::env_id),
        column<R>("recorded_at", &R::recorded_at),
        column<R>("git_commit", &R::git_commit),
        column<R>("binary_sha256", &R::binary_sha256),
        column<R>("algorithm", &R::algorithm),
        column<R>("params", &R::params),
        column<R>("generator", &R::generator),
        column<R>("generator_params", &R::generator_params),
        column<R>("n", &R::n),
        column<R>("seed", &R::seed),
        column<R>("instance_id", &R::instance_id),
        column<R>("repetition", &R::repetition),
        column<R>("threads", &R::threads),
        time_column<R>("time_limit_s", &R::time_limit_s),
        column<R>("memory_limit_bytes", &R::memory_limit_bytes),
    };
    const std::vector<Column<R>> of_run = rated_run_columns<R>();
    all.insert(all.end(), of_run.begin(), of_run.end());
    return all;
  }();
  return columns;
}

const std::vector<Column<InstanceRecord>>& instance_columns() {
  using R = InstanceRecord;
  static const std::vector<Column<R>> columns = {
      column<R>("schema_version", &R::schema_version),
      column<R>("instance_id", &R::instance_id),
      column<R>("study", &R::study),
      column<R>("env_id", &R::env_id),
      column<R>("recorded_at", &R::recorded_at),
      column<R>("generator", &R::generator),
      column<R>("generator_params", &R::generator_params),
      column<R>("n", &R::n),
      column<R>("seed", &R::seed),
      column<R>("distinct", &R::distinct),
      column<R>("duplicates", &R::duplicates),
      column<R>("hull_size", &R::hull_size),
      column<R>("optimum_lower", &R::optimum_lower),
      column<R>("optimum_upper", &R::optimum_upper),
      column<R>("optimality", &R::optimality),
      column<R>("optimum_source", &R::optimum_source),
      time_column<R>("optimum_time_s", &R::optimum_time_s),
      column<R>("optimum_note", &R::optimum_note),
      column<R>("verified", &R::verified),
      column<R>("proof_note", &R::proof_note),
      time_column<R>("verify_time_s", &R::verify_time_s),
      column<R>("proof_bytes", &R::proof_bytes),
  };
  return columns;
}

const std::vector<Column<EnvironmentRecord>>& environment_columns() {
  using R = EnvironmentRecord;
  static const std::vector<Column<R>> columns = {
      column<R>("schema_version", &R::schema_version),
      column<R>("env_id", &R::env_id),
      column<R>("study", &R::study),
      column<R>("recorded_at", &R::recorded_at),
      column<R>("git_commit", &R::git_commit),
      column<R>("binary_sha256", &R::binary_sha256),
      column<R>("cpu_model", &R::cpu_model),
      column<R>("logical_cpus", &R::logical_cpus),
      column<R>("memory_bytes", &R::memory_bytes),
      column<R>("operating_system", &R::operating_system),
      column<R>("kernel", &R::kernel),
      column<R>("compiler", &R::compiler),
      column<R>("compiler_flags", &R::compiler_flags),
      column<R>("governor", &R::governor),
      column<R>("turbo", &R::turbo),
      column<R>("load_1min", &R::load_1min),
      column<R>("swap_used_bytes", &R::swap_used_bytes),
      column<R>("jobs", &R::jobs),
      column<R>("shard", &R::shard),
      column<R>("throttle_events", &R::throttle_events),
  };
  return columns;
}

namespace {

[[noreturn]] void refuse_row(const std::string& what) { throw std::invalid_argument(what); }

void require_interval(const std::optional<double>& lower, const std::optional<double>& upper, const std::string& name) {
  if (lower.has_value() != upper.has_value())
    refuse_row(fmt::format("only one of {}_lower and {}_upper is there", name, name));
  if (lower && *lower > *upper) refuse_row(name + "_lower is above " + name + "_upper");
}

}  // namespace

void require_consistent(const RunRecord& record) {
  require_interval(record.weight_lower, record.weight_upper, "weight");
  require_interval(record.optimum_lower, record.optimum_upper, "optimum");
  require_interval(record.alpha_lower, record.alpha_upper, "alpha");
  if (record.status != RunStatus::ok) return;
  if (record.n == 0) refuse_row("a run on no points cannot be ok");
  if (!record.weight_upper) refuse_row("status is ok, but there is no weight_upper");
}

void require_consistent(const InstanceRecord& record) {
  require_interval(record.optimum_lower, record.optimum_upper, "optimum");
}

void require_consistent(const EnvironmentRecord&) {}

}  // namespace mwt
