// What a generator is: a pure function from (n, seed, parameters) to points, and how it introduces itself.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/parameters.h"
#include "geometry/point.h"

namespace mwt {

/// Exactly n points, distinct unless the family says otherwise; the same on every platform for the same arguments.
/// Throws InputError naming the nearest legal n if the family has no instance of n points.
using GeneratorFunction = std::vector<Point> (*)(Index n, std::uint64_t seed, const Parameters& parameters);

/// A registry entry: one family of instances.
struct GeneratorInfo {
  std::string name;
  std::string summary;   ///< one line
  std::string source;    ///< where the idea comes from
  std::string stresses;  ///< which claim or algorithm it is aimed at
  std::string law;       ///< known optimum or growth law of alpha, or "none known"
  Index smallest_n = 3;
  Index largest_n = 0;  ///< largest n that double precision carries
  Index fixed_n = 0;    ///< for a named instance its only n (then also smallest_n and largest_n), else 0
  bool seeded = true;   ///< whether the seed changes the points
  std::vector<ParameterInfo> parameters;
  GeneratorFunction function = nullptr;
};

}  // namespace mwt
