// The history: an SQLite file with all nights that were tracked. The only door to SQLite.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "harness/tracking/history/night.h"

struct sqlite3;

namespace mwt {

/// Tables: night (git_commit, environment, study, configuration, machine, recorded_at), cell, value (of a night, a cell
/// and a measure). A history of version 1, without configurations, becomes one of this version when it is opened.
///
/// A night is added in one transaction: whatever kills the program leaves all of it or nothing (SQLite's rollback
/// journal, synchronous = FULL). Any number of processes may use one history; who finds it locked waits up to 30 s.
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

  /// There is one night per commit, environment, study and configuration: the same again changes nothing; other values
  /// for it replace those that were there (a night that was repeated or has gone on) unless they are older, so that the
  /// order in which folders are tracked does not matter. A changed study of the same name is another night
  /// (as_another), beside the one that was there.
  Added add(const Night& night);

  /// All nights in the order of time, ties in that of their commits; values ordered by cell and measure.
  [[nodiscard]] std::vector<Night> nights() const;

 private:
  void make_tables();
  void renew();
  [[nodiscard]] int version() const;
  [[nodiscard]] bool adopt_old_night(const Night& night, const std::vector<NightValue>& values);
  [[nodiscard]] bool has_other_configuration(const Night& night) const;
  void write_values(std::int64_t id, const std::vector<NightValue>& values);

  std::string path_;
  sqlite3* database_ = nullptr;
};

}  // namespace mwt
