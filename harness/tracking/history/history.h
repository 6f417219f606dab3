// The history: an SQLite file with all nightly runs that were tracked.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "harness/tracking/history/nightly_run.h"

namespace SQLite {
class Database;
}

namespace mwt {

/// Tables: nightly run (git_commit, environment, study, configuration, machine, recorded_at), cell, value (of a nightly
/// run, a cell and a measure), function (of a nightly run and a cell that was counted). A history of version 1, without
/// configurations, becomes one of this version when it is opened.
///
/// A nightly run is added in one transaction: whatever kills the program leaves all of it or nothing (SQLite's rollback
/// journal, synchronous = FULL). Any number of processes may use one history; one that finds it locked waits up to 30
/// s.
///
/// Throws InputError "FILE: what": it cannot be opened or written, is no history, is of a newer schema version, or
/// stays locked.
class History {
 public:
  enum class Mode { read, write };  ///< write: made if it is missing

  History(std::string path, Mode mode);
  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  enum class Added { as_new, as_another, unchanged, replaced, outdated };

  /// There is one nightly run per commit, environment, study and configuration: the same again changes nothing; other
  /// values for it replace those that were there (a nightly run that was repeated or has gone on) unless they are
  /// older, so that the order in which folders are tracked does not matter. A changed study of the same name is another
  /// nightly run (as_another), beside the one that was there.
  Added add(const NightlyRun& nightly_run);

  /// All nightly runs in the order of time, ties in that of their commits; values ordered by cell and measure.
  [[nodiscard]] std::vector<NightlyRun> nightly_runs() const;

 private:
  void open(Mode mode);
  void make_tables();
  void renew();
  [[nodiscard]] int version() const;
  Added add_in_transaction(const NightlyRun& nightly_run);
  [[nodiscard]] bool adopt_old_nightly_run(const NightlyRun& nightly_run, const std::vector<NightlyValue>& values);
  [[nodiscard]] bool has_other_configuration(const NightlyRun& nightly_run) const;
  void write_values(std::int64_t id, const std::vector<NightlyValue>& values,
                    const std::vector<NightlyFunction>& functions);

  std::string path_;
  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace mwt
