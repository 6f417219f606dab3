// What a generator is: a pure function from (n, seed, parameters) to points, and how it introduces itself.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/parameters.h"
#include "geometry/point.h"

namespace mwt {

/// Exactly n points, distinct unless the entry sets `repeats_points`; the same on every platform for the same
/// arguments. Throws InputError naming the nearest legal n if the family has no instance of n points.
using GeneratorFunction = std::vector<Point> (*)(Index n, std::uint64_t seed, const Parameters& parameters);

/// What a family's entry states about alpha of one algorithm on it, as data that a study can confirm or refute.
struct GrowthLaw {
  enum class Kind {
    power,  ///< alpha grows like n^e: lowest <= e <= highest, the slope of log alpha over log n
    range   ///< lowest <= alpha <= highest
  };

  std::string algorithm;                                    ///< by its name in the registry of algorithms
  std::map<std::string, std::string> algorithm_parameters;  ///< those that are not the algorithm's defaults
  std::map<std::string, std::string> parameters;            ///< of the family: those that are not its defaults
  Kind kind = Kind::power;
  double lowest = 0;
  double highest = 0;
  Index min_n = 3;  ///< the law holds for min_n <= n <= max_n
  Index max_n = 0;
};

/// A registry entry: one family of instances.
struct GeneratorInfo {
  std::string name;
  std::string summary;   ///< one line
  std::string source;    ///< where the idea comes from
  std::string stresses;  ///< which claim or algorithm it is made for
  std::string law;       ///< known optimum or growth law of alpha, or "none known"; for people
  Index min_n = 3;
  Index max_n = 0;              ///< largest n that double precision carries
  Index fixed_n = 0;            ///< for a named instance its only n (then also min_n and max_n), else 0
  bool seeded = true;           ///< whether the seed changes the points
  bool repeats_points = false;  ///< whether some of the points may be equal
  std::vector<ParameterInfo> parameters;
  std::vector<GrowthLaw> growth_laws{};  ///< the measurable part of `law`
  GeneratorFunction function = nullptr;
};

}  // namespace mwt
