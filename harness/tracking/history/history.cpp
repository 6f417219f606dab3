#include "harness/tracking/history/history.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/core.h>
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
// Takes the write lock at once, so that what the transaction reads stays true.
constexpr SQLite::TransactionBehavior kWriting = SQLite::TransactionBehavior::IMMEDIATE;

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

// Histories of earlier builds get this table when they are written to; readers do without.
constexpr const char* kFunctionTable = R"(
CREATE TABLE IF NOT EXISTS function (
  night INTEGER NOT NULL REFERENCES night (id), cell INTEGER NOT NULL REFERENCES cell (id), name TEXT NOT NULL,
  instructions INTEGER NOT NULL,
  PRIMARY KEY (night, cell, name)) WITHOUT ROWID;
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

[[noreturn]] void fail(const std::string& path, const SQLite::Exception& error) {
  const bool locked = error.getErrorCode() == SQLITE_BUSY || error.getErrorCode() == SQLITE_LOCKED;
  throw InputError(path + ": " + error.what() +
                   (locked ? "; another program keeps it locked: try again when it has ended" : ""));
}

// Returns what `step` returns; what SQLite reports becomes an InputError that names the file.
template <class Step>
auto naming_the_file(const std::string& path, const Step& step) {
  try {
    return step();
  } catch (const SQLite::Exception& error) {
    fail(path, error);
  }
}

// Binds the parameters in order and executes the statement; true if there is a row.
template <class... Values>
bool start(SQLite::Statement& statement, const Values&... values) {
  statement.reset();
  SQLite::bind(statement, values...);
  return statement.executeStep();
}

// The same for a statement of one use that changes rows.
template <class... Values>
void execute(SQLite::Database& database, const char* sql, const Values&... values) {
  SQLite::Statement statement(database, sql);
  start(statement, values...);
}

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

/// Of the columns algorithm to threads, which come first.
TrackedCell cell_in(SQLite::Statement& rows) {
  const std::string algorithm = present_name(rows.getColumn(0));
  return {algorithm,         present_params(algorithm, rows.getColumn(1)),
          rows.getColumn(2), rows.getColumn(3),
          rows.getColumn(4), static_cast<std::uint64_t>(rows.getColumn(5).getInt64()),
          rows.getColumn(6)};
}

constexpr const char* kValuesOfNight =
    "SELECT algorithm, params, generator, generator_params, n, seed, threads, measure, value, runs "
    "FROM value JOIN cell ON cell.id = value.cell WHERE night = ?";

std::vector<NightlyValue> values_of_nightly_run(SQLite::Database& database, std::int64_t nightly_run) {
  SQLite::Statement rows(database, kValuesOfNight);
  rows.bind(1, nightly_run);
  std::vector<NightlyValue> values;
  while (rows.executeStep()) {
    values.push_back(
        {cell_in(rows), rows.getColumn(7), rows.getColumn(8), static_cast<std::size_t>(rows.getColumn(9).getInt64())});
  }
  return sorted(std::move(values));
}

constexpr const char* kFunctionsOfNight =
    "SELECT algorithm, params, generator, generator_params, n, seed, threads, name, instructions "
    "FROM function JOIN cell ON cell.id = function.cell WHERE night = ? ORDER BY function.cell, name";

std::vector<NightlyFunction> functions_of_nightly_run(SQLite::Database& database, std::int64_t nightly_run) {
  std::vector<NightlyFunction> functions;
  if (!database.tableExists("function")) return functions;
  SQLite::Statement rows(database, kFunctionsOfNight);
  rows.bind(1, nightly_run);
  while (rows.executeStep())
    functions.push_back({cell_in(rows), rows.getColumn(7), static_cast<std::uint64_t>(rows.getColumn(8).getInt64())});
  return functions;
}

bool same_values(const std::vector<NightlyValue>& a, const std::vector<NightlyValue>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const NightlyValue& x, const NightlyValue& y) {
    return x.cell == y.cell && x.measure == y.measure && x.value == y.value && x.runs == y.runs;
  });
}

class NightlyRunWriter {
 public:
  explicit NightlyRunWriter(SQLite::Database& database)
      : add_cell_(database, "INSERT OR IGNORE INTO cell VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)"),
        find_cell_(database,
                   "SELECT id FROM cell WHERE algorithm = ? AND params = ? AND generator = ? AND generator_params = ? "
                   "AND n = ? AND seed = ? AND threads = ?"),
        add_value_(database, "INSERT INTO value VALUES (?, ?, ?, ?, ?)"),
        add_function_(database, "INSERT INTO function VALUES (?, ?, ?, ?)") {}

  void write(std::int64_t nightly_run, const NightlyValue& value) {
    start(add_value_, nightly_run, id_of(value.cell), value.measure, value.value,
          static_cast<std::int64_t>(value.runs));
  }

  void write(std::int64_t nightly_run, const NightlyFunction& function) {
    start(add_function_, nightly_run, id_of(function.cell), function.name,
          static_cast<std::int64_t>(function.instructions));
  }

 private:
  std::int64_t id_of(const TrackedCell& cell) {
    for (SQLite::Statement* statement : {&add_cell_, &find_cell_}) {
      start(*statement, cell.algorithm, cell.params, cell.generator, cell.generator_params, cell.n,
            signed_seed(cell.seed), cell.threads);
    }
    return find_cell_.getColumn(0);
  }

  SQLite::Statement add_cell_;
  SQLite::Statement find_cell_;
  SQLite::Statement add_value_;
  SQLite::Statement add_function_;
};

}  // namespace

History::History(std::string path, Mode mode) : path_(std::move(path)) {
  if (mode == Mode::read && !std::filesystem::exists(path_))
    throw InputError(path_ + ": there is no history here; mwt track FOLDER begins one");
  naming_the_file(path_, [&] { open(mode); });
}

History::~History() = default;

void History::open(Mode mode) {
  // Even a reader may have to roll back what a killed writer left.
  const int flags = SQLite::OPEN_READWRITE | (mode == Mode::write ? SQLite::OPEN_CREATE : 0);
  database_ = std::make_unique<SQLite::Database>(path_, flags, kPatienceMs);
  database_->exec("PRAGMA synchronous = FULL");
  if (mode == Mode::write) make_tables();
  if (version() == 1) renew();
  database_->exec("PRAGMA foreign_keys = ON");  // not before: tables are replaced
  if (version() != kHistoryVersion)
    throw InputError(path_ + ": is no history of this program's version; choose another file with --history");
}

void History::make_tables() {
  SQLite::Transaction transaction(*database_, kWriting);
  if (database_->execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0) {
    database_->exec(kTables);
    database_->exec(fmt::format("PRAGMA user_version = {}", kHistoryVersion));
  }
  if (version() == kHistoryVersion) database_->exec(kFunctionTable);
  transaction.commit();
}

int History::version() const { return database_->execAndGet("PRAGMA user_version"); }

// Another process may have done it meanwhile.
void History::renew() {
  SQLite::Transaction transaction(*database_, kWriting);
  if (version() == 1) database_->exec(kFromVersion1);
  transaction.commit();
}

// With its values a nightly run that was tracked before there were configurations gets its own.
bool History::adopt_old_nightly_run(const NightlyRun& nightly_run, const std::vector<NightlyValue>& values) {
  SQLite::Statement find(
      *database_, "SELECT id FROM night WHERE git_commit = ? AND environment = ? AND study = ? AND configuration = ''");
  if (nightly_run.configuration.empty() ||
      !start(find, nightly_run.git_commit, nightly_run.environment, nightly_run.study))
    return false;
  const std::int64_t id = find.getColumn(0);
  if (!same_values(values_of_nightly_run(*database_, id), values)) return false;
  execute(*database_, "UPDATE night SET configuration = ? WHERE id = ?", nightly_run.configuration, id);
  return true;
}

bool History::has_other_configuration(const NightlyRun& nightly_run) const {
  SQLite::Statement find(
      *database_, "SELECT id FROM night WHERE git_commit = ? AND environment = ? AND study = ? AND configuration <> ?");
  return start(find, nightly_run.git_commit, nightly_run.environment, nightly_run.study, nightly_run.configuration);
}

void History::write_values(std::int64_t id, const std::vector<NightlyValue>& values,
                           const std::vector<NightlyFunction>& functions) {
  execute(*database_, "DELETE FROM value WHERE night = ?", id);
  execute(*database_, "DELETE FROM function WHERE night = ?", id);
  NightlyRunWriter writer(*database_);
  for (const NightlyValue& value : values) writer.write(id, value);
  for (const NightlyFunction& function : functions) writer.write(id, function);
}

History::Added History::add(const NightlyRun& nightly_run) {
  return naming_the_file(path_, [&] {
    SQLite::Transaction transaction(*database_, kWriting);
    const Added added = add_in_transaction(nightly_run);
    transaction.commit();
    return added;
  });
}

History::Added History::add_in_transaction(const NightlyRun& nightly_run) {
  const std::vector<NightlyValue> values = sorted(nightly_run.values);
  SQLite::Statement find(*database_,
                         "SELECT id, recorded_at FROM night "
                         "WHERE git_commit = ? AND environment = ? AND study = ? AND configuration = ?");
  if (start(find, nightly_run.git_commit, nightly_run.environment, nightly_run.study, nightly_run.configuration)) {
    const std::int64_t earlier = find.getColumn(0);
    if (same_values(values_of_nightly_run(*database_, earlier), values)) return Added::unchanged;
    if (nightly_run.recorded_at < find.getColumn(1).getString()) return Added::outdated;
    execute(*database_, "UPDATE night SET recorded_at = ? WHERE id = ?", nightly_run.recorded_at, earlier);
    write_values(earlier, values, nightly_run.functions);
    return Added::replaced;
  }
  if (adopt_old_nightly_run(nightly_run, values)) return Added::unchanged;
  const Added added = has_other_configuration(nightly_run) ? Added::as_another : Added::as_new;
  execute(*database_, "INSERT INTO night VALUES (NULL, ?, ?, ?, ?, ?, ?)", nightly_run.git_commit,
          nightly_run.environment, nightly_run.study, nightly_run.configuration, nightly_run.machine,
          nightly_run.recorded_at);
  write_values(database_->getLastInsertRowid(), values, nightly_run.functions);
  return added;
}

std::vector<NightlyRun> History::nightly_runs() const {
  return naming_the_file(path_, [&] {
    const SQLite::Transaction snapshot(*database_);
    SQLite::Statement rows(*database_,
                           "SELECT id, git_commit, environment, machine, study, configuration, recorded_at FROM night "
                           "ORDER BY recorded_at, git_commit, configuration");
    std::vector<NightlyRun> nightly_runs;
    while (rows.executeStep()) {
      nightly_runs.push_back({rows.getColumn(1), rows.getColumn(2), rows.getColumn(3), rows.getColumn(4),
                              rows.getColumn(5), rows.getColumn(6),
                              values_of_nightly_run(*database_, rows.getColumn(0)),
                              functions_of_nightly_run(*database_, rows.getColumn(0))});
    }
    return nightly_runs;
  });
}

}  // namespace mwt
