// Calling a family's function: what it returns is verified before anybody uses it.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "generators/generator.h"

namespace mwt {

/// A family's function is wrong: it returned something else than n distinct finite points, or failed in a way that is
/// not the user's mistake. The message begins with "generator NAME:".
class GeneratorFailure : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// The points of a family: exactly n, finite, and distinct unless the entry sets `repeats_points`. Throws InputError
/// naming the nearest legal n outside the family's range, and as the family's function; GeneratorFailure otherwise;
/// std::bad_alloc. O(n log n) beyond the function.
[[nodiscard]] std::vector<Point> generate_verified(const GeneratorInfo& family, Index n, std::uint64_t seed,
                                                   const Parameters& parameters);

}  // namespace mwt
