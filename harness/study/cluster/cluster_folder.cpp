#include "harness/study/cluster/cluster_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "harness/io/columns.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/records/profile_folder.h"
#include "harness/records/proof_folder.h"
#include "harness/records/results_folder.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSettingsFile = "cluster.csv";
constexpr const char* kShardFile = "shards.csv";
constexpr const char* kJobFile = "jobs.csv";
constexpr const char* kAttemptPrefix = "attempt-";
constexpr const char* kBeginFile = "begun";
constexpr const char* kEndFile = "ended";

const std::vector<Column<ClusterSettings>>& settings_columns() {
  using S = ClusterSettings;
  static const std::vector<Column<S>> columns = {
      column<S>("study", &S::study),
      column<S>("study_path", &S::study_path),
      column<S>("instance_folder", &S::instance_folder),
      column<S>("cache_folder", &S::cache_folder),
      column<S>("shards", &S::shards),
      column<S>("seeks_optimum", &S::seeks_optimum),
  };
  return columns;
}

const std::vector<Column<ShardRow>>& shard_columns() {
  using R = ShardRow;
  static const std::vector<Column<R>> columns = {
      column<R>("shard", &R::shard),
      column<R>("generator", &R::generator),
      column<R>("generator_params", &R::generator_params),
      column<R>("n", &R::n),
      column<R>("seed", &R::seed),
      column<R>("runs", &R::runs),
      time_column<R>("search_s", &R::search_s),
      time_column<R>("runs_s", &R::runs_s),
  };
  return columns;
}

const std::vector<Column<JobRow>>& job_columns() {
  using R = JobRow;
  static const std::vector<Column<R>> columns = {
      column<R>("kind", &R::kind),
      column<R>("job_id", &R::job_id),
      column<R>("shards", &R::shards),
      column<R>("submitted_at", &R::submitted_at),
  };
  return columns;
}

template <class Record>
std::vector<Record> read_table(const std::string& file, const std::vector<Column<Record>>& columns) {
  std::vector<CsvRow> rows = parse_csv(read_file(file));
  require_header(file, rows, header_of(columns));
  std::vector<Record> records;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    try {
      records.push_back(read_row(columns, rows[i]));
    } catch (const std::invalid_argument& mistake) {
      throw InputError(fmt::format("{}:{}: malformed row: {}; mend it, or submit the study to another folder", file,
                                   i + 1, mistake.what()));
    }
  }
  return records;
}

template <class Record>
void write_table(const std::string& file, const std::vector<Column<Record>>& columns,
                 const std::vector<Record>& records) {
  std::string text = csv_line(header_of(columns));
  for (const Record& record : records) text += csv_line(to_row(columns, record));
  write_file_atomically(file, text);
}

// Returns whether this call made it; on network file systems, too, of several callers one alone does.
bool make_new_folder(const fs::path& folder) {
  std::error_code error;
  const bool is_new = fs::create_directory(folder, error);
  if (error) throw InputError(folder.string() + ": cannot make this folder: " + error.message());
  return is_new;
}

}  // namespace

std::string to_text(JobKind kind) {
  switch (kind) {
    case JobKind::optima: return "optima";
    case JobKind::runs: return "runs";
    case JobKind::merge: return "merge";
  }
  return "";
}

void read_text(const std::string& text, JobKind& kind) {
  for (const JobKind known : {JobKind::optima, JobKind::runs, JobKind::merge}) {
    if (to_text(known) != text) continue;
    kind = known;
    return;
  }
  throw std::invalid_argument(text);
}

bool JobRow::has_task(std::size_t shard) const {
  const std::vector<std::string> tasks = split(shards, ',');
  return std::ranges::find(tasks, std::to_string(shard)) != tasks.end();
}

ClusterFolder::ClusterFolder(const std::string& path) : path_(fs::absolute(path).lexically_normal().string()) {
  if (!fs::exists(file(kSettingsFile))) {
    throw InputError(
        path +
        ": has no cluster.csv, so that mwt cluster submit did not write it; give the folder of a submitted study");
  }
  const std::vector<ClusterSettings> settings = read_table(file(kSettingsFile), settings_columns());
  if (settings.size() != 1)
    throw InputError(file(kSettingsFile) + ": must have one row; submit the study to another folder");
  settings_ = settings.front();
  rows_ = read_table(file(kShardFile), shard_columns());
}

void ClusterFolder::make(const std::string& path, const ClusterSettings& settings, const std::vector<ShardRow>& rows,
                         const std::string& study_file) {
  std::error_code error;
  for (const fs::path& folder : {fs::path(path), fs::path(path) / "logs", fs::path(path) / "shards"}) {
    fs::create_directories(folder, error);
    if (error)
      throw InputError(folder.string() + ": cannot make this folder: " + error.message() +
                       "; choose another with --out");
  }
  const auto in_folder = [&](const char* name) { return (fs::path(path) / name).string(); };
  write_file_atomically(in_folder("study.toml"), study_file);
  write_table(in_folder(kShardFile), shard_columns(), rows);
  write_table(in_folder(kJobFile), job_columns(), {});
  write_table(in_folder(kSettingsFile), settings_columns(), {settings});
}

std::string ClusterFolder::file(const std::string& name) const { return (fs::path(path_) / name).string(); }

std::set<std::string> ClusterFolder::labels_of(std::size_t shard) const {
  std::set<std::string> labels;
  for (const ShardRow& row : rows_) {
    if (row.shard == shard) labels.insert(label_of_instance(row));
  }
  return labels;
}

std::vector<JobRow> ClusterFolder::jobs() const { return read_table(file(kJobFile), job_columns()); }

void ClusterFolder::append(const JobRow& job) const {
  CsvFile jobs(file(kJobFile), header_of(job_columns()));
  jobs.append(to_row(job_columns(), job));
}

std::string ClusterFolder::shard_folder(std::size_t shard) const {
  return (fs::path(path_) / "shards" / std::to_string(shard)).string();
}

// Their numbers, the last one first.
std::vector<std::size_t> ClusterFolder::attempts(std::size_t shard) const {
  std::vector<std::size_t> numbers;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(shard_folder(shard), missing)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kAttemptPrefix)) continue;
    if (const auto number = parse_whole_number<std::size_t>(name.substr(std::string(kAttemptPrefix).size()))) {
      numbers.push_back(*number);
    }
  }
  std::ranges::sort(numbers, std::greater());
  return numbers;
}

// Without that file, the attempt was killed at its start.
std::optional<std::string> ClusterFolder::last_attempt(std::size_t shard) const {
  for (const std::size_t number : attempts(shard)) {
    const fs::path attempt = fs::path(shard_folder(shard)) / (kAttemptPrefix + std::to_string(number));
    if (fs::exists(attempt / kBeginFile)) return attempt.string();
  }
  return std::nullopt;
}

std::string ClusterFolder::begin_attempt(std::size_t shard) const {
  const std::optional<std::string> last = last_attempt(shard);
  StudyRecords records;
  if (last) records = read_records(*last);
  records.study_file = read_file(file("study.toml"));
  static_cast<void>(make_new_folder(shard_folder(shard)));
  const std::vector<std::size_t> numbers = attempts(shard);
  std::size_t number = numbers.empty() ? 1 : numbers.front() + 1;
  const auto attempt = [&] { return fs::path(shard_folder(shard)) / (kAttemptPrefix + std::to_string(number)); };
  while (!make_new_folder(attempt())) ++number;
  write_records(attempt().string(), records, FolderUse::owned);
  if (last) {
    copy_proofs({*last}, attempt().string(), records.instances);
    copy_profiles({*last}, attempt().string(), records.runs);
  }
  write_file_atomically((attempt() / kBeginFile).string(), utc_now() + '\n');
  return attempt().string();
}

void write_end_of_attempt(const std::string& attempt, const std::string& text) {
  write_file_atomically((fs::path(attempt) / kEndFile).string(), one_line(text) + '\n');
}

std::optional<std::string> end_of_attempt(const std::string& attempt) {
  const std::string file = (fs::path(attempt) / kEndFile).string();
  if (!fs::exists(file)) return std::nullopt;
  std::string text = read_file(file);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace mwt
