#include "harness/records/results_folder.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/records/known_optima.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRuns = "runs.csv";
constexpr const char* kInstances = "instances.csv";
constexpr const char* kEnvironments = "environments.csv";
constexpr const char* kStudyFile = "study.toml";

std::string in_folder(const std::string& folder, const char* name) { return (fs::path(folder) / name).string(); }

template <class Record>
std::vector<Record> records_of(const std::vector<CsvRow>& rows, const std::vector<Column<Record>>& columns,
                               const std::string& file) {
  std::vector<Record> records;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string line = fmt::format("{}:{}", file, i + 2);
    try {
      records.push_back(record_of(columns, rows[i]));
    } catch (const std::invalid_argument& mistake) {
      throw InputError(line + ": malformed row: " + mistake.what() +
                       "; mend it, or delete the line and let mwt run --resume run it again");
    }
    if (records.back().schema_version != kSchemaVersion) {
      throw InputError(
          fmt::format("{}: a row of schema version {}, not {}; use the mwt that wrote it, or delete the line", line,
                      records.back().schema_version, kSchemaVersion));
    }
  }
  return records;
}

// Two files that were put together by hand, say.
void require_each_once(const std::vector<RunRecord>& runs, const std::string& file) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].run_id.empty() || ids.insert(runs[i].run_id).second) continue;
    throw InputError(
        fmt::format("{}:{}: the run {} is there twice; delete one of its lines", file, i + 2, runs[i].run_id));
  }
}

template <class Record>
std::vector<CsvRow> rows_of(const std::vector<Record>& records, const std::vector<Column<Record>>& columns) {
  std::vector<CsvRow> rows;
  for (const Record& record : records) rows.push_back(to_row(columns, record));
  return rows;
}

// A fifo would be waited for.
std::string read_regular_file(const std::string& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_directory(status) && !fs::is_regular_file(status)) {
    throw InputError(file + ": is no regular file; move it away");
  }
  return read_file(file);
}

void make_folder(const fs::path& folder) {
  if (folder.empty()) throw InputError("the results folder has an empty name; give it one with --out");
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && fs::is_directory(folder, error)) return;
  throw InputError(folder.string() + ": cannot make this folder: " +
                   (error ? error.message() : "a file is in its place") + "; choose another with --out");
}

bool is_empty(const std::string& folder) {
  std::error_code error;
  const bool empty = fs::is_empty(folder, error);
  if (error) throw InputError(folder + ": cannot be read: " + error.message() + "; choose another folder with --out");
  return empty;
}

void require_empty(const std::string& folder, const std::string& remedy) {
  if (!is_empty(folder)) throw InputError(folder + ": has something in it already; " + remedy);
}

// What `mwt run` makes before it writes study.toml: record files without content, and the temporary file of that write.
bool is_trace_of_a_start(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  const bool is_record_file = name == kRuns || name == kInstances || name == kEnvironments;
  return is_temporary_name(name) || (is_record_file && entry.is_regular_file() && entry.file_size() == 0);
}

// A `mwt run` that was killed at its start leaves no more than this.
bool holds_only_traces_of_a_start(const std::string& folder) {
  const fs::directory_iterator entries(folder);
  return std::all_of(begin(entries), end(entries), is_trace_of_a_start);
}

// Whether the folder has its study.toml already.
bool require_this_study(const std::string& folder, const std::string& study_file) {
  const std::string copy = in_folder(folder, kStudyFile);
  if (!fs::exists(copy)) {
    if (holds_only_traces_of_a_start(folder)) return false;
    throw InputError(folder +
                     ": is not empty, but has no study.toml that names its study; choose another folder with --out");
  }
  if (read_regular_file(copy) == study_file) return true;
  throw InputError(folder + ": its study.toml differs from this study; choose another folder with --out");
}

void require_same_name(const std::vector<RunRecord>& runs, const std::string& study, const std::string& folder) {
  for (const RunRecord& run : runs) {
    if (run.study == study) continue;
    throw InputError(folder + ": holds runs of the study '" + run.study + "'; choose another folder with --out");
  }
}

// A killed study's last worker holds the lock a little longer than the study itself, until the system ends it too.
// Returns 0, or why there is no lock.
int lock_within_patience(int descriptor) {
  constexpr int kAttempts = 50;
  constexpr useconds_t kPause = 20000;  // us
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return 0;
    if (errno != EWOULDBLOCK && errno != EINTR) return errno;
    usleep(kPause);
  }
  return EWOULDBLOCK;
}

}  // namespace

// The lock is on the folder itself: it leaves no file and ends with the process, however that ends.
FolderLock::FolderLock(const std::string& folder, FolderUse use) {
  make_folder(folder);
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) {
    throw InputError(folder + ": cannot be read: " + std::strerror(errno) + "; choose another folder with --out");
  }
  const int reason = use == FolderUse::owned ? 0 : lock_within_patience(descriptor_);
  if (reason == 0) return;
  close(descriptor_);
  if (reason == EWOULDBLOCK) {
    throw InputError(folder + ": another mwt run is writing here; wait for it or choose another folder with --out");
  }
  throw InputError(folder + ": cannot be locked: " + std::strerror(reason) +
                   "; choose a folder on another file system with --out");
}

FolderLock::~FolderLock() { close(descriptor_); }

// Some file systems cannot; the rows are safe either way.
void FolderLock::sync() const { static_cast<void>(fsync(descriptor_)); }

// Everything is looked at before anything is written.
ResultsFolder::ResultsFolder(const std::string& path, const std::string& study, const std::string& study_file,
                             bool resume, FolderUse use)
    : path_(path), lock_(path, use) {
  if (!resume) require_empty(path, "continue its study with --resume or choose another folder with --out");
  const bool has_study_file = require_this_study(path, study_file);
  const auto open_file = [&](const char* name, const CsvRow& header) {
    return std::make_unique<CsvFile>(in_folder(path, name), header);
  };
  run_file_ = open_file(kRuns, header_of(run_columns()));
  instance_file_ = open_file(kInstances, header_of(instance_columns()));
  environment_file_ = open_file(kEnvironments, header_of(environment_columns()));
  runs_ = records_of(run_file_->existing_rows(), run_columns(), in_folder(path, kRuns));
  instances_ = records_of(instance_file_->existing_rows(), instance_columns(), in_folder(path, kInstances));
  require_each_once(runs_, in_folder(path, kRuns));
  require_same_name(runs_, study, path);
  if (!has_study_file) write_file_atomically(in_folder(path, kStudyFile), study_file);
  for (CsvFile* file : {run_file_.get(), instance_file_.get(), environment_file_.get()}) file->begin();
  lock_.sync();
}

std::set<std::string> ResultsFolder::run_ids() const {
  std::set<std::string> ids;
  for (const RunRecord& record : runs_) ids.insert(record.run_id);
  return ids;
}

void ResultsFolder::append(const RunRecord& record) {
  run_file_->append(to_row(run_columns(), record));
  runs_.push_back(record);
}

void ResultsFolder::append(const InstanceRecord& record) {
  instance_file_->append(to_row(instance_columns(), record));
  instances_.push_back(record);
}

void ResultsFolder::append(const EnvironmentRecord& record) {
  environment_file_->append(to_row(environment_columns(), record));
}

void ResultsFolder::replace(const InstanceRecord& record) {
  for (InstanceRecord& instance : instances_) {
    if (instance.instance_id == record.instance_id) instance = record;
  }
  instance_file_->replace_all(rows_of(instances_, instance_columns()));
}

// The runs first: if the program is killed in between, the next one finds the instance's claim still disproved.
void ResultsFolder::settle(const std::string& instance_id) {
  const auto is_of_it = [&](const auto& record) { return record.instance_id == instance_id; };
  std::vector<RunRecord> runs;
  std::vector<InstanceRecord> instances;
  std::copy_if(runs_.begin(), runs_.end(), std::back_inserter(runs), is_of_it);
  std::copy_if(instances_.begin(), instances_.end(), std::back_inserter(instances), is_of_it);
  static_cast<void>(reject_disproved(runs, instances));
  rate_all(runs, instances);
  auto run = runs.begin();
  for (RunRecord& record : runs_) {
    if (is_of_it(record)) record = *run++;
  }
  auto instance = instances.begin();
  for (InstanceRecord& record : instances_) {
    if (is_of_it(record)) record = *instance++;
  }
  run_file_->replace_all(rows_of(runs_, run_columns()));
  instance_file_->replace_all(rows_of(instances_, instance_columns()));
}

std::vector<std::string> ResultsFolder::warnings() const {
  std::vector<std::string> all;
  for (const CsvFile* file : {run_file_.get(), instance_file_.get(), environment_file_.get()}) {
    all.insert(all.end(), file->warnings().begin(), file->warnings().end());
  }
  return all;
}

namespace {

// Files of earlier builds lack the columns that were added since: their fields are empty.
template <class Record>
std::vector<Record> read_file_of_records(const std::string& folder, const char* name,
                                         const std::vector<Column<Record>>& columns, std::size_t first_columns,
                                         std::vector<std::string>& warnings) {
  const std::string file = in_folder(folder, name);
  const std::string content = read_regular_file(file);
  std::vector<CsvRow> rows = parse_csv(content);
  const CsvRow header = header_of(columns);
  const bool is_of_earlier_build = !rows.empty() && rows.front().size() >= first_columns &&
                                   rows.front().size() < header.size() &&
                                   std::equal(rows.front().begin(), rows.front().end(), header.begin());
  if (is_of_earlier_build) {
    const std::size_t known = rows.front().size();
    for (CsvRow& row : rows) {
      if (row.size() == known) row.resize(header.size());  // another size is a malformed row
    }
    rows.front() = header;
  }
  require_header(file, rows, header);
  const std::string warning = warning_about_last_line(file, content);
  if (!warning.empty()) warnings.push_back(warning);
  rows.erase(rows.begin());
  return records_of(rows, columns, file);
}

template <class Record>
void write_file_of_records(const std::string& folder, const char* name, const std::vector<Column<Record>>& columns,
                           const std::vector<Record>& records) {
  std::string content = csv_line(header_of(columns));
  for (const Record& record : records) content += csv_line(to_row(columns, record));
  write_file_atomically(in_folder(folder, name), content);
}

}  // namespace

std::vector<RunRecord> read_runs(const std::string& folder) {
  std::vector<std::string> ignored;
  std::vector<RunRecord> runs = read_file_of_records(folder, kRuns, run_columns(), kFirstRunColumns, ignored);
  require_each_once(runs, in_folder(folder, kRuns));
  return runs;
}

StudyRecords read_records(const std::string& folder) {
  StudyRecords records;
  records.study_file = read_regular_file(in_folder(folder, kStudyFile));
  records.runs = read_file_of_records(folder, kRuns, run_columns(), kFirstRunColumns, records.warnings);
  require_each_once(records.runs, in_folder(folder, kRuns));
  records.instances =
      read_file_of_records(folder, kInstances, instance_columns(), kFirstInstanceColumns, records.warnings);
  records.environments =
      read_file_of_records(folder, kEnvironments, environment_columns(), kFirstEnvironmentColumns, records.warnings);
  return records;
}

void write_records(const std::string& folder, const StudyRecords& records, FolderUse use) {
  const FolderLock lock(folder, use);
  require_empty(folder, "choose another folder");
  write_file_atomically(in_folder(folder, kStudyFile), records.study_file);
  write_file_of_records(folder, kEnvironments, environment_columns(), records.environments);
  write_file_of_records(folder, kInstances, instance_columns(), records.instances);
  write_file_of_records(folder, kRuns, run_columns(), records.runs);
}

}  // namespace mwt
