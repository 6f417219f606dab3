#include "harness/study/results_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "geometry/error.h"
#include "geometry/input_file.h"
#include "geometry/output_file.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

template <class Record>
std::vector<Record> records_of(const std::vector<CsvRow>& rows, const std::vector<Column<Record>>& columns,
                               const std::string& file) {
  std::vector<Record> records;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::optional<Record> record = from_row(columns, rows[i]);
    if (!record) throw InputError(file + ":" + std::to_string(i + 2) + ": malformed row");
    records.push_back(*std::move(record));
  }
  return records;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && fs::is_directory(folder, error)) return;
  throw InputError(folder.string() + ": cannot make this folder: " +
                   (error ? error.message() : "a file is in its place") + "; choose another with --out");
}

void require_empty(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_empty(folder, error)) {
    throw InputError(folder.string() +
                     ": has results already; continue them with --resume or choose another with --out");
  }
}

void keep_study_file(const fs::path& folder, const Study& study) {
  const std::string copy = (folder / "study.toml").string();
  if (!fs::exists(copy)) {
    write_file_atomically(copy, study.file_content);
  } else if (read_file(copy) != study.file_content) {
    throw InputError(folder.string() + ": its study.toml differs from this study; choose another folder with --out");
  }
}

}  // namespace

// The lock is on the folder itself: it leaves no file and ends with the process, however that ends.
FolderLock::FolderLock(const std::string& folder) {
  make_folder(folder);
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) throw InputError(folder + ": " + std::strerror(errno));
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    close(descriptor_);
    throw InputError(folder + ": another mwt run is writing here; wait for it or choose another folder with --out");
  }
}

FolderLock::~FolderLock() { close(descriptor_); }

ResultsFolder::ResultsFolder(const std::string& path, const Study& study, bool resume) : lock_(path) {
  const fs::path folder(path);
  if (!resume) require_empty(folder);
  keep_study_file(folder, study);
  const auto open_file = [&](const char* name, const CsvRow& header) {
    return std::make_unique<CsvFile>((folder / name).string(), header);
  };
  run_file_ = open_file("runs.csv", header_of(run_columns()));
  instance_file_ = open_file("instances.csv", header_of(instance_columns()));
  environment_file_ = open_file("environments.csv", header_of(environment_columns()));
  runs_ = records_of(run_file_->existing_rows(), run_columns(), (folder / "runs.csv").string());
  instances_ = records_of(instance_file_->existing_rows(), instance_columns(), (folder / "instances.csv").string());
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

namespace {

template <class Record>
std::vector<Record> read_file_of_records(const std::string& folder, const char* name,
                                         const std::vector<Column<Record>>& columns) {
  const std::string file = (fs::path(folder) / name).string();
  std::vector<CsvRow> rows = parse_csv(read_file(file));
  if (rows.empty() || rows.front() != header_of(columns)) {
    throw InputError(file + ": its columns are not those of schema version " + std::to_string(kSchemaVersion));
  }
  rows.erase(rows.begin());
  return records_of(rows, columns, file);
}

template <class Record>
void write_file_of_records(const std::string& folder, const char* name, const std::vector<Column<Record>>& columns,
                           const std::vector<Record>& records) {
  std::string content = csv_line(header_of(columns));
  for (const Record& record : records) content += csv_line(to_row(columns, record));
  write_file_atomically((fs::path(folder) / name).string(), content);
}

}  // namespace

std::vector<RunRecord> read_runs(const std::string& folder) {
  return read_file_of_records(folder, "runs.csv", run_columns());
}

StudyRecords read_records(const std::string& folder) {
  StudyRecords records;
  records.study_file = read_file((fs::path(folder) / "study.toml").string());  // before the lock would make the folder
  const FolderLock lock(folder);
  records.runs = read_runs(folder);
  records.instances = read_file_of_records(folder, "instances.csv", instance_columns());
  records.environments = read_file_of_records(folder, "environments.csv", environment_columns());
  return records;
}

void write_records(const std::string& folder, const StudyRecords& records) {
  const FolderLock lock(folder);
  require_empty(folder);
  write_file_atomically((fs::path(folder) / "study.toml").string(), records.study_file);
  write_file_of_records(folder, "environments.csv", environment_columns(), records.environments);
  write_file_of_records(folder, "instances.csv", instance_columns(), records.instances);
  write_file_of_records(folder, "runs.csv", run_columns(), records.runs);
}

}  // namespace mwt
