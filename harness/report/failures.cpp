#include "harness/report/failures.h"

#include <map>

#include "harness/aligned_table.h"

namespace mwt {

namespace {

// Runs of one kind.
struct Kind {
  std::size_t count = 0;
  const RunRecord* first = nullptr;

  void add(const RunRecord& run) {
    if (count++ == 0) first = &run;
  }
};

std::string instance_of(const RunRecord& run) {
  const std::string parameters = run.generator_params.empty() ? "" : " " + run.generator_params;
  return run.generator + parameters + " n=" + std::to_string(run.n) + " seed=" + std::to_string(run.seed);
}

}  // namespace

std::string failure_table(const std::vector<RunRecord>& runs) {
  std::map<std::pair<std::string, RunStatus>, Kind> kinds;
  for (const RunRecord& run : runs) {
    if (is_failure(run.status)) kinds[{run.algorithm, run.status}].add(run);
  }
  AlignedTable table({"failed", "how", "runs", "first on", "message"}, {1, 3, 4});
  for (const auto& [key, kind] : kinds) {
    table.add_row({key.first, std::string(name_of(key.second)), std::to_string(kind.count), instance_of(*kind.first),
                   kind.first->message});
  }
  return table.is_empty() ? "" : table.text();
}

std::string stopped_early_table(const std::vector<RunRecord>& runs) {
  std::map<std::pair<std::string, StopReason>, Kind> kinds;
  for (const RunRecord& run : runs) {
    if (run.stop_reason) kinds[{run.algorithm, *run.stop_reason}].add(run);
  }
  AlignedTable table({"stopped early", "why", "runs", "first on"}, {1, 3});
  for (const auto& [key, kind] : kinds) {
    table.add_row(
        {key.first, std::string(phrase_of(key.second)), std::to_string(kind.count), instance_of(*kind.first)});
  }
  return table.is_empty() ? "" : table.text();
}

}  // namespace mwt
