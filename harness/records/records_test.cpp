#include "harness/records/records.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>

namespace mwt {
namespace {

// The first column of the tables of results/README.md, by the file that the section's title names.
std::map<std::string, std::vector<std::string>> documented_columns() {
  std::map<std::string, std::vector<std::string>> columns;
  std::ifstream page(MWT_SOURCE_DIR "/results/README.md");
  std::string line;
  std::string section;
  while (std::getline(page, line)) {
    if (line.starts_with("## ")) section = line.substr(3);
    const std::size_t end = line.find('`', 3);
    if (line.starts_with("| `") && !section.empty()) columns[section].push_back(line.substr(3, end - 3));
  }
  return columns;
}

TEST(Records, TheSchemaPageListsExactlyTheColumnsInTheirOrder) {
  auto documented = documented_columns();
  EXPECT_EQ(documented["runs.csv"], header_of(run_columns()));
  EXPECT_EQ(documented["instances.csv"], header_of(instance_columns()));
  EXPECT_EQ(documented["environments.csv"], header_of(environment_columns()));
}

TEST(Records, ARunSurvivesTheRoundTrip) {
  RunRecord record;
  record.run_id = "id";
  record.params = "k=4 start=a,b";
  record.seed = 18446744073709551615u;
  record.status = RunStatus::out_of_memory;
  record.wall_time_s = 0.1;
  record.weight_lower = 5e-324;
  record.stopped_early = true;
  record.stop_reason = StopReason::size;
  record.message = "two\nlines";
  const std::optional<RunRecord> back = read_row(run_columns(), to_row(run_columns(), record));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->params, record.params);
  EXPECT_EQ(back->seed, record.seed);
  EXPECT_EQ(back->status, record.status);
  EXPECT_EQ(back->wall_time_s, record.wall_time_s);
  EXPECT_EQ(back->weight_lower, record.weight_lower);
  EXPECT_EQ(back->weight_upper, std::nullopt);
  EXPECT_EQ(back->stopped_early, true);
  EXPECT_EQ(back->stop_reason, StopReason::size);
  EXPECT_EQ(back->message, "two lines");
}

TEST(Records, MissingIsEmptyNotZero) {
  const CsvRow row = to_row(run_columns(), RunRecord{});
  const CsvRow header = header_of(run_columns());
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool is_measure = header[i] == "alpha_upper" || header[i] == "wall_time_s" || header[i] == "optimal";
    EXPECT_TRUE(row[i].empty() || !is_measure) << header[i];
  }
}

TEST(Records, MalformedRowsAreNone) {
  CsvRow row = to_row(run_columns(), RunRecord{});
  EXPECT_NO_THROW(static_cast<void>(read_row(run_columns(), row)));
  row.back() = "";
  row.push_back("one too many");
  EXPECT_THROW(static_cast<void>(read_row(run_columns(), row)), std::invalid_argument);
  row.pop_back();
  row[11] = "ten";  // n
  EXPECT_THROW(static_cast<void>(read_row(run_columns(), row)), std::invalid_argument);
}

// The message of the exception for a finished run with one field replaced.
std::string mistake(const std::string& column, const std::string& text) {
  RunRecord record;
  record.status = RunStatus::ok;
  record.n = 5;
  record.weight_lower = record.weight_upper = 2;
  record.alpha_lower = record.alpha_upper = 1;
  const CsvRow header = header_of(run_columns());
  CsvRow row = to_row(run_columns(), record);
  const auto place = std::find(header.begin(), header.end(), column) - header.begin();
  row.at(static_cast<std::size_t>(place)) = text;
  try {
    static_cast<void>(record_of(run_columns(), row));
  } catch (const std::invalid_argument& what) {
    return what.what();
  }
  return "";
}

TEST(Records, TimesAreFiniteAndNotNegative) {
  for (const char* column : {"wall_time_s", "cpu_time_s", "delaunay_time_s", "time_limit_s"}) {
    EXPECT_EQ(mistake(column, "0.25"), "");
    for (const char* text : {"nan", "-nan", "inf", "-1", "1e999", "1.5s", " 1"})
      EXPECT_EQ(mistake(column, text), "'" + std::string(text) + "' is no " + column);
  }
}

TEST(Records, MeasuresAreNumbers) {
  for (const char* column : {"weight_lower", "alpha_upper", "perimeter_sum"}) {
    for (const char* text : {"nan", "x", "0x10", "1,5"})
      EXPECT_EQ(mistake(column, text), "'" + std::string(text) + "' is no " + column);
  }
  for (const char* text : {"-1", "1.5", "18446744073709551616", ""})
    EXPECT_EQ(mistake("seed", text), "'" + std::string(text) + "' is no seed");
}

// Such rows were internal failures of report and run.
TEST(Records, FieldsThatContradictEachOtherAreNamed) {
  EXPECT_EQ(mistake("weight_upper", ""), "only one of weight_lower and weight_upper is there");
  EXPECT_EQ(mistake("weight_lower", "3"), "weight_lower is above weight_upper");
  EXPECT_EQ(mistake("alpha_lower", ""), "only one of alpha_lower and alpha_upper is there");
  EXPECT_EQ(mistake("n", "0"), "a run on no points cannot be ok");
}

TEST(Records, AReasonThatIsNoneIsMalformed) {
  CsvRow row = to_row(run_columns(), RunRecord{});
  const CsvRow header = header_of(run_columns());
  std::string& reason = row[static_cast<std::size_t>(std::ranges::find(header, "stop_reason") - header.begin())];
  reason = "boredom";
  EXPECT_THROW(static_cast<void>(read_row(run_columns(), row)), std::invalid_argument);
  reason = "deadline";
  EXPECT_NO_THROW(static_cast<void>(read_row(run_columns(), row)));
}

TEST(Status, EveryNameComesBack) {
  for (const char* name : {"ok", "timeout", "out_of_memory", "crashed", "invalid_output", "not_applicable", "error"}) {
    ASSERT_TRUE(status_of(name)) << name;
    EXPECT_EQ(name_of(*status_of(name)), name);
  }
  EXPECT_FALSE(status_of("fine"));
}

}  // namespace
}  // namespace mwt
