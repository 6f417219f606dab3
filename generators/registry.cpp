#include "generators/registry.h"

#include <algorithm>
#include <array>

#include "geometry/error.h"

namespace mwt {

std::span<const GeneratorInfo> generators() {
  static const std::vector<GeneratorInfo> entries = {};
  return entries;
}

const GeneratorInfo& find_generator(const std::string& name) {
  std::string known;
  for (const GeneratorInfo& entry : generators()) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw InputError("unknown generator '" + name + "'; known: " + known);
}

}  // namespace mwt
