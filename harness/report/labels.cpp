#include "harness/report/labels.h"

#include "base/parameters.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

std::string label(const std::map<std::string, std::set<std::string>>& known, const std::string& name,
                  const std::string& parameters) {
  return known.at(name).size() == 1 || parameters.empty() ? name : name + ' ' + parameters;
}

}  // namespace

Labels::Labels(const std::vector<Cell>& cells) {
  for (const Cell& cell : cells) {
    family_parameters_[cell.key.generator].insert(cell.key.generator_params);
    algorithm_parameters_[cell.key.algorithm].insert(cell.key.params);
  }
}

// A file's parameter is its name, which says more than "file".
std::string Labels::family(const CellKey& key) const {
  if (key.generator == kFileGenerator) {
    const std::map<std::string, std::string> parameters = parse_canonical(key.generator_params);
    const auto file = parameters.find("file");
    if (file != parameters.end()) return file->second;
  }
  return label(family_parameters_, key.generator, key.generator_params);
}

std::string Labels::algorithm(const CellKey& key) const {
  return label(algorithm_parameters_, key.algorithm, key.params);
}

}  // namespace mwt
