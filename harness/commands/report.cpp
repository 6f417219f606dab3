#include "harness/report/report.h"

#include <iostream>
#include <memory>
#include <sstream>

#include "geometry/output_file.h"
#include "harness/commands/commands.h"

namespace mwt {

namespace {

struct Options {
  std::string folder;
  std::optional<std::string> tables;
};

int report(const Options& options) {
  const ReportData data = read_report_data(options.folder);
  for (const std::string& warning : data.records.warnings) std::cerr << "mwt: warning: " << warning << '\n';
  std::ostringstream tables;
  for (const ReportPart& part : report_tables()) part(data, tables);
  write_file_atomically(options.tables.value_or("-"), tables.str());
  if (options.tables) std::cout << "written: " << *options.tables << '\n';
  for (const ReportPart& part : report_results()) part(data, std::cout);
  return kExitOk;
}

}  // namespace

Command report_command() {
  const auto options = std::make_shared<Options>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("folder", options->folder, "results folder of a study (mwt run)");
    declared.option("--tables", options->tables,
                    "file for the tables, instead of printing them (often 1000s of lines)");
  };
  return {"report", "Tables of time, alpha and growth from the records of a study; also as CSV", declare,
          [options] { return report(*options); }};
}

}  // namespace mwt
