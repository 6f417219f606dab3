#include "harness/catalogue.h"

#include "algorithms/registry.h"
#include "generators/arguments.h"
#include "generators/registry.h"
#include "geometry/error.h"

namespace mwt {

namespace {

template <class Info>
const Info& find(std::span<const Info> entries, const std::string& kind, const std::string& name) {
  std::string known;
  for (const Info& entry : entries) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw InputError("unknown " + kind + " '" + name + "'; known: " + known);
}

}  // namespace

Catalogue Catalogue::built_in() { return {mwt::algorithms(), mwt::generators()}; }

const AlgorithmInfo& Catalogue::algorithm(const std::string& name) const {
  return find(algorithms_, "algorithm", name);
}

const GeneratorInfo& Catalogue::generator(const std::string& name) const {
  return find(generators_, "generator", name);
}

std::vector<Point> generate_points(const GeneratorInfo& family, Index n, std::uint64_t seed,
                                   const Parameters& parameters) {
  const Index largest = family.largest_n == 0 ? kMostPoints : family.largest_n;
  require_size(family.name, n, family.smallest_n, largest);
  return family.function(n, seed, parameters);
}

}  // namespace mwt
