// The parameter `max_points` of solvers that many points would keep busy for ever.
#pragma once

#include <optional>
#include <string>

#include "algorithms/algorithm.h"

namespace mwt {

/// Throws NotApplicable if there are more points than the parameter max_points says. With `most`, throws InputError if
/// the parameter is not between 3 and that. Precondition: `solver` declares the parameter.
void require_max_points(const std::string& solver, Points points, const Context& context,
                        std::optional<Index> most = {});

}  // namespace mwt
