// Overwrites the state of the processor's branch prediction, so that repeated work does not become faster than work
// that is executed once.
#pragma once

#include <random>
#include <vector>

namespace mwt {

/// Processors record how branches went and predict the next execution by it. Work that is repeated on the same input
/// is predicted nearly without error after some 20 executions if it has few enough branches: CGAL's Delaunay
/// triangulation of the same 1,000 points then takes 0.2 us per point instead of 0.46, of 10,000 points always 0.56
/// (measured: results/README.md, Times). Times of repeated small and single large runs would not be comparable.
class BranchHistory {
 public:
  /// Sorts new random numbers: about 50,000 branches that nothing predicts take the place of what was recorded. Takes
  /// about half a millisecond.
  void overwrite();

 private:
  std::mt19937 random_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace mwt
