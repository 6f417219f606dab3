// Checks the arguments of a family; messages name the family and the nearest legal value.
#pragma once

#include <cstdint>
#include <string>

#include "base/parameters.h"
#include "geometry/point.h"

namespace mwt {

/// Double precision carries every n in most families; then 32-bit indices, which must number 2n triangles, are the
/// limit.
inline constexpr Index kMaxPoints = (Index{1} << 31) - 1;

/// Throws InputError naming the nearest legal n unless smallest <= n <= largest.
void require_size(const std::string& family, Index n, std::uint64_t smallest, std::uint64_t largest);

/// The parameter's value. Throws InputError unless lowest <= value <= highest.
[[nodiscard]] double real_within(const std::string& family, const Parameters& parameters, const std::string& name,
                                 double lowest, double highest);
[[nodiscard]] std::int64_t integer_within(const std::string& family, const Parameters& parameters,
                                          const std::string& name, std::int64_t lowest, std::int64_t highest);

}  // namespace mwt
