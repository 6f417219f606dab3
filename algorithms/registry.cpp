#include "algorithms/registry.h"

#include "algorithms/annealing/annealing.h"
#include "algorithms/flip/flip.h"
#include "algorithms/greedy/greedy.h"
#include "algorithms/patch/patch.h"
#include "geometry/error.h"

namespace mwt {

// Each algorithm's folder has a header that declares its entry: `AlgorithmInfo x_entry();`.
std::span<const AlgorithmInfo> algorithms() {
  static const std::vector<AlgorithmInfo> entries = {
      greedy_entry(),
      flip_entry(),
      patch_entry(),
      annealing_entry(),
  };
  return entries;
}

const AlgorithmInfo& find_algorithm(const std::string& name) {
  std::string known;
  for (const AlgorithmInfo& entry : algorithms()) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw InputError("unknown algorithm '" + name + "'; known: " + known);
}

}  // namespace mwt
