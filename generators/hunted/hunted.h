// Small sets that a search found to be bad for one algorithm.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo hunted_entry();

/// A find of `mwt hunt --algorithm ALGORITHM --n N --seed SEED`.
struct HuntedInstance {
  std::string algorithm;  ///< with its default parameters
  std::uint64_t seed = 0;
  double alpha = 0;  ///< certified lower bound when it was found
  std::vector<Point> points;
};

/// All finds, by algorithm, then by size.
[[nodiscard]] const std::vector<HuntedInstance>& hunted_instances();

}  // namespace mwt
