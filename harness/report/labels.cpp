#include "harness/report/labels.h"

#include <algorithm>
#include <set>

#include "base/parameters.h"
#include "harness/io/text/text.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

// "name=value" by name.
using Assignments = std::map<std::string, std::string>;

struct Variant {
  std::string parameters;
  std::size_t runs = 0;
  Assignments assignments;
};

Assignments assignments_of(const std::string& parameters) {
  Assignments assignments;
  for (const std::string& part : split(parameters, ' ')) {
    if (!part.empty()) assignments[part.substr(0, part.find('='))] = part;
  }
  return assignments;
}

const std::string& text_of(const Variant& variant, const std::string& name) {
  static const std::string none;
  const auto found = variant.assignments.find(name);
  return found == variant.assignments.end() ? none : found->second;
}

std::set<std::string> differing_parameters(const std::vector<Variant>& variants) {
  std::set<std::string> differing;
  for (const Variant& variant : variants) {
    for (const auto& [name, text] : variant.assignments) {
      const auto is_other = [&name = name, &text = text](const Variant& other) { return text_of(other, name) != text; };
      if (std::ranges::any_of(variants, is_other)) differing.insert(name);
    }
  }
  return differing;
}

// The variant with more runs than every other; null if there is none.
const Variant* usual_variant(const std::vector<Variant>& variants) {
  const auto most = std::ranges::max_element(variants, {}, &Variant::runs);
  return std::ranges::count(variants, most->runs, &Variant::runs) == 1 ? &*most : nullptr;
}

std::string label(const std::string& name, const Variant& variant, const std::set<std::string>& differing,
                  const Variant* usual) {
  std::string text = name;
  for (const auto& [parameter, assignment] : variant.assignments) {
    if (!differing.contains(parameter)) continue;
    if (usual != nullptr && text_of(*usual, parameter) == assignment) continue;
    text += ' ' + assignment;
  }
  return text;
}

// The labels of the configurations whose runs are counted, of families or of algorithms.
std::map<std::pair<std::string, std::string>, std::string> labels_of(
    const std::map<std::pair<std::string, std::string>, std::size_t>& run_counts) {
  std::map<std::string, std::vector<Variant>> variants_by_name;
  for (const auto& [configuration, runs] : run_counts) {
    const auto& [name, parameters] = configuration;
    variants_by_name[name].push_back({parameters, runs, assignments_of(parameters)});
  }
  std::map<std::pair<std::string, std::string>, std::string> labels;
  for (const auto& [name, variants] : variants_by_name) {
    const std::set<std::string> differing = differing_parameters(variants);
    const Variant* usual = usual_variant(variants);
    for (const Variant& variant : variants) labels[{name, variant.parameters}] = label(name, variant, differing, usual);
  }
  return labels;
}

}  // namespace

Labels::Labels(const std::vector<Cell>& cells) {
  std::map<Configuration, std::size_t> family_runs;
  std::map<Configuration, std::size_t> algorithm_runs;
  for (const Cell& cell : cells) {
    const std::size_t runs = cell.runs + cell.not_applicable;
    family_runs[{cell.key.generator, cell.key.generator_params}] += runs;
    algorithm_runs[{cell.key.algorithm, cell.key.params}] += runs;
  }
  families_ = labels_of(family_runs);
  algorithms_ = labels_of(algorithm_runs);
}

// A file's parameter is its name, which is more useful than "file".
std::string Labels::family(const CellKey& key) const {
  if (key.generator == kFileGenerator) {
    const std::map<std::string, std::string> parameters = parse_canonical(key.generator_params);
    const auto file = parameters.find("file");
    if (file != parameters.end()) return file->second;
  }
  return families_.at({key.generator, key.generator_params});
}

std::string Labels::algorithm(const CellKey& key) const { return algorithms_.at({key.algorithm, key.params}); }

}  // namespace mwt
