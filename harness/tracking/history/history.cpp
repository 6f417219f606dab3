#include "harness/tracking/history/history.h"

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "harness/tracking/old_names.h"

namespace mwt {

namespace {

constexpr int kHistoryVersion = 2;
constexpr int kPatienceMs = 30000;

constexpr const char* kTables = R"(
CREATE TABLE IF NOT EXISTS night (
  id INTEGER PRIMARY KEY,
  git_commit TEXT NOT NULL, environment TEXT NOT NULL, study TEXT NOT NULL, configuration TEXT NOT NULL,
  machine TEXT NOT NULL, recorded_at TEXT NOT NULL,
  UNIQUE (git_commit, environment, study, configuration));
CREATE TABLE IF NOT EXISTS cell (
  id INTEGER PRIMARY KEY,
  algorithm TEXT NOT NULL, params TEXT NOT NULL, generator TEXT NOT NULL, generator_params TEXT NOT NULL,
  n INTEGER NOT NULL, seed INTEGER NOT NULL, threads INTEGER NOT NULL,
  UNIQUE (algorithm, params, generator, generator_params, n, seed, threads));
CREATE TABLE IF NOT EXISTS value (
  night INTEGER NOT NULL REFERENCES night (id), cell INTEGER NOT NULL REFERENCES cell (id), measure TEXT NOT NULL,
  value REAL NOT NULL, runs INTEGER NOT NULL,
  PRIMARY KEY (night, cell, measure)) WITHOUT ROWID;
)";

// SQLite cannot change what is unique in a table; version 1 had no configuration.
constexpr const char* kFromVersion1 = R"(
CREATE TABLE new_night (
  id INTEGER PRIMARY KEY,
  git_commit TEXT NOT NULL, environment TEXT NOT NULL, study TEXT NOT NULL, configuration TEXT NOT NULL,
  machine TEXT NOT NULL, recorded_at TEXT NOT NULL,
  UNIQUE (git_commit, environment, study, configuration));
INSERT INTO new_night SELECT id, git_commit, environment, study, '', machine, recorded_at FROM night;
DROP TABLE night;
ALTER TABLE new_night RENAME TO night;
PRAGMA user_version = 2;
)";

[[noreturn]] void fail(const std::string& path, sqlite3* database) {
  const int code = database == nullptr ? SQLITE_NOMEM : sqlite3_errcode(database);
  const std::string what = database == nullptr ? "out of memory" : sqlite3_errmsg(database);
  const bool locked = code == SQLITE_BUSY || code == SQLITE_LOCKED;
  throw InputError(path + ": " + what +
                   (locked ? "; another program keeps it locked: try again when it has ended" : ""));
}

/// A prepared statement; parameters are bound in order, columns read in order.
class Statement {
 public:
  Statement(const std::string& path, sqlite3* database, const char* sql) : path_(path), database_(database) {
    if (sqlite3_prepare_v2(database, sql, -1, &statement_, nullptr) != SQLITE_OK) fail(path_, database_);
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  template <class... Values>
  Statement& bind(const Values&... values) {
    sqlite3_reset(statement_);
    int place = 0;
    (bind_at(++place, values), ...);
    return *this;
  }

  /// True while there is a row.
  bool step() {
    const int code = sqlite3_step(statement_);
    if (code != SQLITE_ROW && code != SQLITE_DONE) fail(path_, database_);
    return code == SQLITE_ROW;
  }

  [[nodiscard]] std::int64_t integer(int column) const { return sqlite3_column_int64(statement_, column); }
  [[nodiscard]] double number(int column) const { return sqlite3_column_double(statement_, column); }
  [[nodiscard]] std::string text(int column) const {
    const unsigned char* text = sqlite3_column_text(statement_, column);
    return text == nullptr ? "" : std::string(text, text + sqlite3_column_bytes(statement_, column));
  }

 private:
  void bind_at(int place, const std::string& value) {
    check(sqlite3_bind_text(statement_, place, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT));
  }
  void bind_at(int place, double value) { check(sqlite3_bind_double(statement_, place, value)); }
  void bind_at(int place, std::int64_t value) { check(sqlite3_bind_int64(statement_, place, value)); }
  void check(int code) {
    if (code != SQLITE_OK) fail(path_, database_);
  }

  const std::string& path_;
  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
};

void execute(const std::string& path, sqlite3* database, const char* sql) {
  if (sqlite3_exec(database, sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail(path, database);
}

/// Rolled back unless committed. One that writes takes the write lock at once, so that what it reads stays true.
class Transaction {
 public:
  Transaction(const std::string& path, sqlite3* database, const char* begin) : path_(path), database_(database) {
    execute(path_, database_, begin);
  }
  ~Transaction() {
    if (!committed_) sqlite3_exec(database_, "ROLLBACK", nullptr, nullptr, nullptr);
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit() {
    execute(path_, database_, "COMMIT");
    committed_ = true;
  }

 private:
  const std::string& path_;
  sqlite3* database_;
  bool committed_ = false;
};

std::int64_t signed_seed(std::uint64_t seed) { return static_cast<std::int64_t>(seed); }

std::vector<NightlyValue> sorted(std::vector<NightlyValue> values) {
  const auto key = [](const NightlyValue& v) {
    return std::tie(v.cell.algorithm, v.cell.params, v.cell.generator, v.cell.generator_params, v.cell.n, v.cell.seed,
                    v.cell.threads, v.measure);
  };
  std::sort(values.begin(), values.end(),
            [&](const NightlyValue& a, const NightlyValue& b) { return key(a) < key(b); });
  return values;
}

constexpr const char* kValuesOfNight =
    "SELECT algorithm, params, generator, generator_params, n, seed, threads, measure, value, runs "
    "FROM value JOIN cell ON cell.id = value.cell WHERE night = ?";

std::vector<NightlyValue> values_of_nightly_run(const std::string& path, sqlite3* database, std::int64_t nightly_run) {
  Statement rows(path, database, kValuesOfNight);
  rows.bind(nightly_run);
  std::vector<NightlyValue> values;
  while (rows.step()) {
    const std::string algorithm = present_name(rows.text(0));
    const TrackedCell cell{algorithm,
                           present_params(algorithm, rows.text(1)),
                           rows.text(2),
                           rows.text(3),
                           static_cast<Index>(rows.integer(4)),
                           static_cast<std::uint64_t>(rows.integer(5)),
                           static_cast<int>(rows.integer(6))};
    values.push_back({cell, rows.text(7), rows.number(8), static_cast<std::size_t>(rows.integer(9))});
  }
  return sorted(std::move(values));
}

bool same_values(const std::vector<NightlyValue>& a, const std::vector<NightlyValue>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const NightlyValue& x, const NightlyValue& y) {
    return x.cell == y.cell && x.measure == y.measure && x.value == y.value && x.runs == y.runs;
  });
}

class NightlyRunWriter {
 public:
  NightlyRunWriter(const std::string& path, sqlite3* database)
      : add_cell_(path, database, "INSERT OR IGNORE INTO cell VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)"),
        find_cell_(path, database,
                   "SELECT id FROM cell WHERE algorithm = ? AND params = ? AND generator = ? AND generator_params = ? "
                   "AND n = ? AND seed = ? AND threads = ?"),
        add_value_(path, database, "INSERT INTO value VALUES (?, ?, ?, ?, ?)") {}

  void write(std::int64_t nightly_run, const NightlyValue& value) {
    add_value_.bind(nightly_run, id_of(value.cell), value.measure, value.value, static_cast<std::int64_t>(value.runs))
        .step();
  }

 private:
  std::int64_t id_of(const TrackedCell& cell) {
    const auto bind = [&](Statement& statement) -> Statement& {
      return statement.bind(cell.algorithm, cell.params, cell.generator, cell.generator_params, std::int64_t{cell.n},
                            signed_seed(cell.seed), std::int64_t{cell.threads});
    };
    bind(add_cell_).step();
    bind(find_cell_).step();
    return find_cell_.integer(0);
  }

  Statement add_cell_;
  Statement find_cell_;
  Statement add_value_;
};

}  // namespace

History::History(std::string path, Mode mode) : path_(std::move(path)) {
  if (mode == Mode::read && !std::filesystem::exists(path_))
    throw InputError(path_ + ": there is no history here; mwt track FOLDER begins one");
  // Even a reader may have to roll back what a killed writer left.
  const int flags = SQLITE_OPEN_READWRITE | (mode == Mode::write ? SQLITE_OPEN_CREATE : 0);
  const int code = sqlite3_open_v2(path_.c_str(), &database_, flags, nullptr);
  try {
    if (code != SQLITE_OK) fail(path_, database_);
    sqlite3_busy_timeout(database_, kPatienceMs);
    execute(path_, database_, "PRAGMA synchronous = FULL");
    if (mode == Mode::write) make_tables();
    if (version() == 1) renew();
    execute(path_, database_, "PRAGMA foreign_keys = ON");  // not before: tables are replaced
    if (version() != kHistoryVersion)
      throw InputError(path_ + ": is no history of this program's version; choose another file with --history");
  } catch (...) {
    sqlite3_close(database_);
    throw;
  }
}

History::~History() { sqlite3_close(database_); }

void History::make_tables() {
  Transaction transaction(path_, database_, "BEGIN IMMEDIATE");
  Statement anything(path_, database_, "SELECT count(*) FROM sqlite_schema");
  anything.step();
  if (anything.integer(0) == 0) {
    execute(path_, database_, kTables);
    execute(path_, database_, ("PRAGMA user_version = " + std::to_string(kHistoryVersion)).c_str());
  }
  transaction.commit();
}

int History::version() const {
  Statement version(path_, database_, "PRAGMA user_version");
  version.step();
  return static_cast<int>(version.integer(0));
}

// Another process may have done it meanwhile.
void History::renew() {
  Transaction transaction(path_, database_, "BEGIN IMMEDIATE");
  if (version() == 1) execute(path_, database_, kFromVersion1);
  transaction.commit();
}

// With its values a nightly run that was tracked before there were configurations gets its own.
bool History::adopt_old_nightly_run(const NightlyRun& nightly_run, const std::vector<NightlyValue>& values) {
  Statement find(path_, database_,
                 "SELECT id FROM night WHERE git_commit = ? AND environment = ? AND study = ? AND configuration = ''");
  if (nightly_run.configuration.empty() ||
      !find.bind(nightly_run.git_commit, nightly_run.environment, nightly_run.study).step())
    return false;
  if (!same_values(values_of_nightly_run(path_, database_, find.integer(0)), values)) return false;
  Statement(path_, database_, "UPDATE night SET configuration = ? WHERE id = ?")
      .bind(nightly_run.configuration, find.integer(0))
      .step();
  return true;
}

bool History::has_other_configuration(const NightlyRun& nightly_run) const {
  Statement find(path_, database_,
                 "SELECT id FROM night WHERE git_commit = ? AND environment = ? AND study = ? AND configuration <> ?");
  return find.bind(nightly_run.git_commit, nightly_run.environment, nightly_run.study, nightly_run.configuration)
      .step();
}

void History::write_values(std::int64_t id, const std::vector<NightlyValue>& values) {
  Statement(path_, database_, "DELETE FROM value WHERE night = ?").bind(id).step();
  NightlyRunWriter writer(path_, database_);
  for (const NightlyValue& value : values) writer.write(id, value);
}

History::Added History::add(const NightlyRun& nightly_run) {
  Transaction transaction(path_, database_, "BEGIN IMMEDIATE");
  const std::vector<NightlyValue> values = sorted(nightly_run.values);
  Statement find(path_, database_,
                 "SELECT id, recorded_at FROM night "
                 "WHERE git_commit = ? AND environment = ? AND study = ? AND configuration = ?");
  Added added = Added::replaced;
  if (find.bind(nightly_run.git_commit, nightly_run.environment, nightly_run.study, nightly_run.configuration).step()) {
    const std::int64_t earlier = find.integer(0);
    if (same_values(values_of_nightly_run(path_, database_, earlier), values)) return Added::unchanged;
    if (nightly_run.recorded_at < find.text(1)) return Added::outdated;
    Statement(path_, database_, "UPDATE night SET recorded_at = ? WHERE id = ?")
        .bind(nightly_run.recorded_at, earlier)
        .step();
    write_values(earlier, values);
  } else if (adopt_old_nightly_run(nightly_run, values)) {
    added = Added::unchanged;
  } else {
    added = has_other_configuration(nightly_run) ? Added::as_another : Added::as_new;
    Statement(path_, database_, "INSERT INTO night VALUES (NULL, ?, ?, ?, ?, ?, ?)")
        .bind(nightly_run.git_commit, nightly_run.environment, nightly_run.study, nightly_run.configuration,
              nightly_run.machine, nightly_run.recorded_at)
        .step();
    write_values(sqlite3_last_insert_rowid(database_), values);
  }
  transaction.commit();
  return added;
}

std::vector<NightlyRun> History::nightly_runs() const {
  const Transaction snapshot(path_, database_, "BEGIN");
  Statement rows(path_, database_,
                 "SELECT id, git_commit, environment, machine, study, configuration, recorded_at FROM night "
                 "ORDER BY recorded_at, git_commit, configuration");
  std::vector<NightlyRun> nightly_runs;
  while (rows.step()) {
    nightly_runs.push_back({rows.text(1), rows.text(2), rows.text(3), rows.text(4), rows.text(5), rows.text(6),
                            values_of_nightly_run(path_, database_, rows.integer(0))});
  }
  return nightly_runs;
}

}  // namespace mwt
