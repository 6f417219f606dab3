#include "algorithms/registry.h"

#include "algorithms/brute_force/brute_force.h"
#include "algorithms/subset_dp/subset_dp.h"
#include "algorithms/triangle_lp/triangle_lp.h"
#include "geometry/error.h"

namespace mwt {

// Each algorithm's folder has a header that declares its entry: `AlgorithmInfo x_entry();`.
std::span<const AlgorithmInfo> algorithms() {
  static const std::vector<AlgorithmInfo> entries = {
      brute_force_entry(),
      subset_dp_entry(),
      triangle_lp_entry(),
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
