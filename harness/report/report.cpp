#include "harness/report/report.h"

#include <filesystem>

#include "base/error.h"
#include "harness/claims/claims.h"
#include "harness/io/output_file.h"
#include "harness/records/known_optima.h"
#include "harness/report/failures.h"
#include "harness/report/growth_laws.h"
#include "harness/report/machines.h"
#include "harness/report/observations.h"
#include "harness/report/optima.h"
#include "harness/report/summary_files.h"
#include "harness/report/tables.h"
#include "harness/study/study.h"

namespace mwt {

namespace {

void write(const ReportData& data, const char* name, const std::string& content, std::ostream& out) {
  const std::string path = (std::filesystem::path(data.folder) / name).string();
  write_file_atomically(path, content);
  out << "written: " << path << '\n';
}

void print_warnings(const ReportData& data, std::ostream& out) {
  for (const std::string& warning : data.warnings) out << "warning: " << warning << "\n\n";
}

void print_cells(const ReportData& data, std::ostream& out) { out << cell_tables(data.summaries, data.labels) << '\n'; }

void print_growth(const ReportData& data, std::ostream& out) {
  const std::string table = growth_tables(data.growth, data.labels);
  if (!table.empty()) out << table << '\n';
}

void print_growth_laws(const ReportData& data, std::ostream& out) {
  const std::string table = growth_law_table(test_growth_laws(data.records.runs, Catalogue::built_in()));
  if (!table.empty()) out << "growth laws stated by families\n" << table << '\n';
}

void print_algorithms(const ReportData& data, std::ostream& out) {
  out << algorithm_table(data.cells, data.labels) << '\n';
}

void write_summary(const ReportData& data, std::ostream& out) {
  write(data, "summary.csv", summary_csv(data.records.runs.front().study, data.summaries, data.labels), out);
}

void write_observations(const ReportData& data, std::ostream& out) {
  const std::vector<Observation> observations = observations_of(data.records.runs);
  write(data, "observations.csv", observations_csv(data.records.runs.front().study, observations, data.labels), out);
}

void write_exponents(const ReportData& data, std::ostream& out) {
  write(data, "exponents.csv", exponents_csv(data.records.runs.front().study, data.growth, data.labels), out);
}

void write_optima(const ReportData& data, std::ostream& out) {
  write(data, "optima.csv", optima_csv(data.records.runs.front().study, data.optima, data.labels), out);
}

void write_ratings(const ReportData& data, std::ostream& out) {
  write(data, "ratings.csv", ratings_csv(data.records.runs.front().study, data.records.runs), out);
}

void print_optima(const ReportData& data, std::ostream& out) {
  const std::string table = optimum_table(data.optima);
  if (!table.empty()) out << table << '\n';
}

void print_optimum_summary(const ReportData& data, std::ostream& out) { out << optimum_summary(data.optima) << '\n'; }

void print_failures(const ReportData& data, std::ostream& out) {
  for (const std::string& table : {failure_table(data.records.runs), rejected_proof_table(data.records.instances),
                                   stopped_early_table(data.records.runs)}) {
    if (!table.empty()) out << table << '\n';
  }
}

// Another study would leave most claims undecided, and judge the others by fewer runs than their rules are made for.
void judge_source_report(const ReportData& data, std::ostream& out) {
  if (!judges_claims(data.records.study_file)) return remove_claims(data.folder);
  const std::vector<JudgedClaim> judged = judge_claims(data.records);
  write_claims(data.folder, judged);
  out << "written: " << data.folder << "/claims.csv, claim_rows.csv, claim_details/\n\n" << claims_text(judged);
}

}  // namespace

ReportData read_report_data(const std::string& folder) {
  StudyRecords records = read_records(folder);
  if (records.runs.empty()) throw InputError(folder + ": no runs are recorded here yet");
  records.runs = rated_by_all_bounds(records.runs, records.instances);
  std::vector<std::string> warnings = keep_times_of_one_machine(records);
  std::vector<Cell> cells = cells_of(records.runs);
  std::vector<CellSummary> summaries = summarise(cells);
  std::vector<SeriesGrowth> growth = growth_of(cells);
  std::vector<OptimumCell> optima = optima_of(records);
  Labels labels(cells);
  return {folder,
          std::move(records),
          std::move(warnings),
          std::move(cells),
          std::move(summaries),
          std::move(growth),
          std::move(optima),
          std::move(labels)};
}

std::vector<ReportPart> report_tables() {
  return {print_warnings, print_cells, print_growth, print_growth_laws, print_algorithms, print_optima, print_failures};
}

std::vector<ReportPart> report_results() {
  return {print_warnings,  print_optimum_summary, write_summary, write_observations,
          write_exponents, write_optima,          write_ratings, judge_source_report};
}

}  // namespace mwt
