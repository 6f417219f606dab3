#include "algorithms/registry.h"

#include "algorithms/annealing/annealing.h"
#include "algorithms/boolean_model/boolean_model.h"
#include "algorithms/brute_force/brute_force.h"
#include "algorithms/delaunay/delaunay.h"
#include "algorithms/exact/exact.h"
#include "algorithms/flip/flip.h"
#include "algorithms/flip_naive/flip_naive.h"
#include "algorithms/greedy/greedy.h"
#include "algorithms/greedy_naive/greedy_naive.h"
#include "algorithms/hull_insertion/hull_insertion.h"
#include "algorithms/patch/patch.h"
#include "algorithms/polygon_dp/polygon_dp.h"
#include "algorithms/quadtree/quadtree.h"
#include "algorithms/subset_dp/subset_dp.h"
#include "algorithms/sweep/sweep.h"
#include "algorithms/triangle_lp/triangle_lp.h"
#include "algorithms/two_chains/two_chains.h"
#include "base/error.h"

namespace mwt {

// Each algorithm's folder has a header that declares its entry: `AlgorithmInfo x_entry();`.
std::span<const AlgorithmInfo> algorithms() {
  // One line each, so that additions do not move others.
  // clang-format off
  static const std::vector<AlgorithmInfo> entries = {
      delaunay_entry(),    sweep_entry(),       greedy_naive_entry(), greedy_entry(),      hull_insertion_entry(),
      flip_naive_entry(), flip_entry(),        patch_entry(),         annealing_entry(),   quadtree_entry(),
      polygon_dp_entry(),  brute_force_entry(), subset_dp_entry(),     triangle_lp_entry(), exact_entry(),
      two_chains_entry(),  boolean_model_entry(),
  };
  // clang-format on
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
