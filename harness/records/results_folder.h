// The folder that a study's records go to.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "harness/records/records.h"

namespace mwt {

/// Who may write to a folder.
enum class FolderUse {
  locked,  ///< whoever holds its lock
  owned,   ///< one process that alone was given this folder; no lock is sought, for network file systems have none to
           ///< rely on
};

/// While this object lives, no other process can lock the same folder.
class FolderLock {
 public:
  /// Makes the folder if it is missing. Throws InputError: it cannot be made, or another process holds its lock.
  explicit FolderLock(const std::string& folder, FolderUse use = FolderUse::locked);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Brings the names of new files in the folder to the disk.
  void sync() const;

 private:
  int descriptor_ = -1;
};

/// Holds runs.csv, instances.csv, environments.csv and study.toml (a copy of the study file), and a lock: a second
/// `mwt run` on the same folder is refused while this object lives.
///
/// Files are append-only but for one case: rows that a disproved claim made wrong are replaced (settle()).
///
/// Throws InputError: the folder holds something and `resume` is false; it is another study's, or no study.toml names
/// its study; it is in use; it cannot be written. Nothing that was there is changed then.
class ResultsFolder {
 public:
  /// `study_file`: the content of the study file.
  ResultsFolder(const std::string& path, const std::string& study, const std::string& study_file, bool resume,
                FolderUse use = FolderUse::locked);
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  void append(const RunRecord& record);
  void append(const InstanceRecord& record);
  void append(const EnvironmentRecord& record);

  /// Puts the record in the place of that instance's row.
  void replace(const InstanceRecord& record);

  /// Replaces the instance's rows so that no claim stands in them that its triangulations disprove, and all its runs
  /// are rated by what does (records/known_optima.h).
  void settle(const std::string& instance_id);

  /// All records, those of earlier invocations first.
  [[nodiscard]] const std::vector<RunRecord>& runs() const { return runs_; }
  [[nodiscard]] const std::vector<InstanceRecord>& instances() const { return instances_; }
  [[nodiscard]] std::set<std::string> run_ids() const;

  /// About what was found in the folder, for the user.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  std::string path_;
  FolderLock lock_;
  std::unique_ptr<CsvFile> run_file_;
  std::unique_ptr<CsvFile> instance_file_;
  std::unique_ptr<CsvFile> environment_file_;
  std::vector<RunRecord> runs_;
  std::vector<InstanceRecord> instances_;
};

/// The runs recorded in a results folder. Throws InputError: no runs.csv or no regular file, another schema version, a
/// malformed row.
[[nodiscard]] std::vector<RunRecord> read_runs(const std::string& folder);

/// All that a results folder holds.
struct StudyRecords {
  std::string study_file;  ///< content of study.toml
  std::vector<RunRecord> runs;
  std::vector<InstanceRecord> instances;
  std::vector<EnvironmentRecord> environments;
  std::vector<std::string> warnings{};  ///< about the files, for the user
};

/// Complete rows only, so that a study may be running there meanwhile. Folders of earlier builds of this schema version
/// are read, too; columns that they lack are empty. Throws InputError as read_runs().
[[nodiscard]] StudyRecords read_records(const std::string& folder);

/// Makes a results folder; runs.csv last, so that none is half there. Throws InputError: it holds something already, or
/// cannot be written.
void write_records(const std::string& folder, const StudyRecords& records, FolderUse use = FolderUse::locked);

}  // namespace mwt
