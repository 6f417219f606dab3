#include "harness/report/failures.h"

#include <map>

#include "harness/aligned_table.h"

namespace mwt {

namespace {

struct Failures {
  std::size_t count = 0;
  const RunRecord* first = nullptr;
};

std::string instance_of(const RunRecord& run) {
  const std::string parameters = run.generator_params.empty() ? "" : " " + run.generator_params;
  return run.generator + parameters + " n=" + std::to_string(run.n) + " seed=" + std::to_string(run.seed);
}

}  // namespace

std::string failure_table(const std::vector<RunRecord>& runs) {
  std::map<std::pair<std::string, RunStatus>, Failures> kinds;
  for (const RunRecord& run : runs) {
    if (!is_failure(run.status)) continue;
    Failures& kind = kinds[{run.algorithm, run.status}];
    if (kind.count++ == 0) kind.first = &run;
  }
  AlignedTable table({"failed", "how", "runs", "first on", "message"}, {1, 3, 4});
  for (const auto& [key, kind] : kinds) {
    table.add_row({key.first, std::string(name_of(key.second)), std::to_string(kind.count), instance_of(*kind.first),
                   kind.first->message});
  }
  return table.is_empty() ? "" : table.text();
}

}  // namespace mwt
