#include "harness/tracking/cell.h"

#include <fmt/core.h>

namespace mwt {

namespace {

std::string with_parameters(const std::string& name, const std::string& parameters) {
  return parameters.empty() ? name : name + ' ' + parameters;
}

}  // namespace

TrackedCell cell_of(const RunRecord& record) {
  return {record.algorithm, record.params, record.generator, record.generator_params,
          record.n,         record.seed,   record.threads};
}

std::string algorithm_label(const TrackedCell& cell) {
  return with_parameters(cell.algorithm, cell.params) +
         (cell.threads == 1 ? "" : fmt::format(" threads={}", cell.threads));
}

std::string family_label(const TrackedCell& cell) { return with_parameters(cell.generator, cell.generator_params); }

std::string instance_label(const TrackedCell& cell) {
  return fmt::format("{} n={} seed={}", family_label(cell), cell.n, cell.seed);
}

std::map<TrackedCell, std::vector<const RunRecord*>> by_cell(const std::vector<RunRecord>& runs) {
  std::map<TrackedCell, std::vector<const RunRecord*>> cells;
  for (const RunRecord& run : runs) cells[cell_of(run)].push_back(&run);
  return cells;
}

}  // namespace mwt
