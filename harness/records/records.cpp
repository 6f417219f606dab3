#include "harness/records/records.h"

#include <cmath>
#include <map>
#include <stdexcept>

#include "base/number_text.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

std::string to_text(const std::string& value) { return one_line(value); }
std::string to_text(double value) { return number_text(value); }
std::string to_text(bool value) { return value ? "1" : "0"; }
std::string to_text(int value) { return std::to_string(value); }
std::string to_text(Index value) { return std::to_string(value); }
std::string to_text(std::uint64_t value) { return std::to_string(value); }
std::string to_text(RunStatus value) { return std::string(name_of(value)); }
std::string to_text(StopReason value) { return std::string(name_of(value)); }
template <class Value>
std::string to_text(const std::optional<Value>& value) {
  return value ? to_text(*value) : "";
}

template <class Whole>
void read_text(const std::string& text, Whole& value) {
  const std::optional<Whole> number = parse_whole_number<Whole>(text);
  if (!number) throw std::invalid_argument(text);
  value = *number;
}
// No measure is infinite or not a number: a field that says so is damaged.
void read_text(const std::string& text, double& value) {
  const std::optional<double> number = parse_number(text);
  if (!number || !std::isfinite(*number)) throw std::invalid_argument(text);
  value = *number;
}
void read_text(const std::string& text, std::string& value) { value = text; }
void read_text(const std::string& text, bool& value) {
  if (text != "0" && text != "1") throw std::invalid_argument(text);
  value = text == "1";
}
void read_text(const std::string& text, RunStatus& value) {
  const std::optional<RunStatus> status = status_of(text);
  if (!status) throw std::invalid_argument(text);
  value = *status;
}
void read_text(const std::string& text, StopReason& value) {
  const std::optional<StopReason> reason = stop_reason_of(text);
  if (!reason) throw std::invalid_argument(text);
  value = *reason;
}
template <class Value>
void read_text(const std::string& text, std::optional<Value>& value) {
  value.reset();
  if (!text.empty()) read_text(text, value.emplace());
}

template <class Record, class Value>
Column<Record> column(std::string name, Value Record::*member) {
  return {std::move(name), [member](const Record& record) { return to_text(record.*member); },
          [member](Record& record, const std::string& text) { read_text(text, record.*member); }};
}

bool is_time(double seconds) { return seconds >= 0; }
bool is_time(const std::optional<double>& seconds) { return !seconds || is_time(*seconds); }

template <class Record, class Seconds>
Column<Record> time_column(std::string name, Seconds Record::*member) {
  Column<Record> result = column(std::move(name), member);
  result.read = [member, read = result.read](Record& record, const std::string& text) {
    read(record, text);
    if (!is_time(record.*member)) throw std::invalid_argument(text);
  };
  return result;
}

}  // namespace

const std::vector<Column<RunRecord>>& run_columns() {
  using R = RunRecord;
  static const std::vector<Column<R>> columns = {
      column("schema_version", &R::schema_version),
      column("run_id", &R::run_id),
      column("study", &R::study),
      column("env_id", &R::env_id),
      column("recorded_at", &R::recorded_at),
      column("git_commit", &R::git_commit),
      column("binary_sha256", &R::binary_sha256),
      column("algorithm", &R::algorithm),
      column("params", &R::params),
      column("generator", &R::generator),
      column("generator_params", &R::generator_params),
      column("n", &R::n),
      column("seed", &R::seed),
      column("instance_id", &R::instance_id),
      column("repetition", &R::repetition),
      column("threads", &R::threads),
      time_column("time_limit_s", &R::time_limit_s),
      column("memory_limit_bytes", &R::memory_limit_bytes),
      column("status", &R::status),
      column("checker", &R::checker),
      column("message", &R::message),
      time_column("wall_time_s", &R::wall_time_s),
      time_column("cpu_time_s", &R::cpu_time_s),
      column("iterations", &R::iterations),
      column("peak_rss_bytes", &R::peak_rss_bytes),
      column("weight_lower", &R::weight_lower),
      column("weight_upper", &R::weight_upper),
      column("certified_lower", &R::certified_lower),
      column("optimum_lower", &R::optimum_lower),
      column("optimum_upper", &R::optimum_upper),
      column("optimality", &R::optimality),
      column("alpha_lower", &R::alpha_lower),
      column("alpha_upper", &R::alpha_upper),
      column("optimal", &R::optimal),
      column("stopped_early", &R::stopped_early),
      column("perimeter_sum", &R::perimeter_sum),
      column("triangles", &R::triangles),
      column("edges", &R::edges),
      column("triangulation_count", &R::triangulation_count),
      column("phases", &R::phases),
      column("counters", &R::counters),
      time_column("delaunay_time_s", &R::delaunay_time_s),
      column("stop_reason", &R::stop_reason),
  };
  return columns;
}

const std::vector<Column<InstanceRecord>>& instance_columns() {
  using R = InstanceRecord;
  static const std::vector<Column<R>> columns = {
      column("schema_version", &R::schema_version),
      column("instance_id", &R::instance_id),
      column("study", &R::study),
      column("env_id", &R::env_id),
      column("recorded_at", &R::recorded_at),
      column("generator", &R::generator),
      column("generator_params", &R::generator_params),
      column("n", &R::n),
      column("seed", &R::seed),
      column("distinct", &R::distinct),
      column("duplicates", &R::duplicates),
      column("hull_size", &R::hull_size),
      column("optimum_lower", &R::optimum_lower),
      column("optimum_upper", &R::optimum_upper),
      column("optimality", &R::optimality),
      column("optimum_source", &R::optimum_source),
      time_column("optimum_time_s", &R::optimum_time_s),
      column("optimum_note", &R::optimum_note),
  };
  return columns;
}

const std::vector<Column<EnvironmentRecord>>& environment_columns() {
  using R = EnvironmentRecord;
  static const std::vector<Column<R>> columns = {
      column("schema_version", &R::schema_version),
      column("env_id", &R::env_id),
      column("study", &R::study),
      column("recorded_at", &R::recorded_at),
      column("git_commit", &R::git_commit),
      column("binary_sha256", &R::binary_sha256),
      column("cpu_model", &R::cpu_model),
      column("logical_cpus", &R::logical_cpus),
      column("memory_bytes", &R::memory_bytes),
      column("operating_system", &R::operating_system),
      column("kernel", &R::kernel),
      column("compiler", &R::compiler),
      column("compiler_flags", &R::compiler_flags),
      column("governor", &R::governor),
      column("turbo", &R::turbo),
      column("load_1min", &R::load_1min),
      column("swap_used_bytes", &R::swap_used_bytes),
      column("jobs", &R::jobs),
      column("shard", &R::shard),
      column("throttle_events", &R::throttle_events),
  };
  return columns;
}

namespace {

[[noreturn]] void refuse_row(const std::string& what) { throw std::invalid_argument(what); }

void require_interval(const std::optional<double>& lower, const std::optional<double>& upper, const std::string& name) {
  if (lower.has_value() != upper.has_value())
    refuse_row("only one of " + name + "_lower and " + name + "_upper is there");
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

namespace {

template <class Record>
Record read_fields(const std::vector<Column<Record>>& columns, const CsvRow& row) {
  if (row.size() != columns.size()) {
    refuse_row(std::to_string(row.size()) + " fields where there should be " + std::to_string(columns.size()));
  }
  Record record;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    try {
      columns[i].read(record, row[i]);
    } catch (const std::invalid_argument&) {
      refuse_row(shown(row[i]) + " is no " + columns[i].name);
    }
  }
  return record;
}

}  // namespace

template <class Record>
Record record_of(const std::vector<Column<Record>>& columns, const CsvRow& row) {
  const Record record = read_fields(columns, row);
  require_consistent(record);
  return record;
}

template RunRecord record_of(const std::vector<Column<RunRecord>>&, const CsvRow&);
template InstanceRecord record_of(const std::vector<Column<InstanceRecord>>&, const CsvRow&);
template EnvironmentRecord record_of(const std::vector<Column<EnvironmentRecord>>&, const CsvRow&);

template <class Record>
std::optional<Record> from_row(const std::vector<Column<Record>>& columns, const CsvRow& row) {
  try {
    return read_fields(columns, row);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

template std::optional<RunRecord> from_row(const std::vector<Column<RunRecord>>&, const CsvRow&);
template std::optional<InstanceRecord> from_row(const std::vector<Column<InstanceRecord>>&, const CsvRow&);
template std::optional<EnvironmentRecord> from_row(const std::vector<Column<EnvironmentRecord>>&, const CsvRow&);

template <class NamedNumbers>
std::string named_numbers(const NamedNumbers& numbers) {
  std::string text;
  for (const auto& [name, value] : numbers) {
    if (!text.empty()) text += ' ';
    for (const char c : name) text += c == ' ' || c == '=' ? '_' : c;
    text += '=' + number_text(value);
  }
  return text;
}

template std::string named_numbers(const std::map<std::string, double>&);
template std::string named_numbers(const std::vector<std::pair<std::string, double>>&);

}  // namespace mwt
