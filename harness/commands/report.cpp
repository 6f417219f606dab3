#include "harness/report/report.h"

#include <iostream>
#include <memory>

#include "harness/commands/commands.h"

namespace mwt {

Command report_command() {
  const auto folder = std::make_shared<std::string>();
  const auto declare = [folder](CommandOptions& declared) {
    declared.argument("folder", *folder, "results folder of a study (mwt run)");
  };
  const auto report = [folder] {
    const ReportData data = read_report_data(*folder);
    for (const ReportPart& part : report_parts()) part(data, std::cout);
    return static_cast<int>(kExitOk);
  };
  return {"report", "Tables of time, alpha and growth from the records of a study; also as CSV", declare, report};
}

}  // namespace mwt
