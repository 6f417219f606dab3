#include "algorithms/common/max_points.h"

#include <fmt/core.h>

#include "base/error.h"

namespace mwt {

void require_max_points(const std::string& solver, Points points, const Context& context, std::optional<Index> most) {
  const std::int64_t limit = context.parameters.integer("max_points");
  if (most && (limit < 3 || limit > std::int64_t{*most})) {
    throw InputError(fmt::format("{}: parameter max_points={} is not between 3 and {}", solver, limit, *most));
  }
  if (std::ssize(points) <= limit) return;
  throw NotApplicable(fmt::format("{}: {} points; it takes at most {} (parameter max_points{})", solver, points.size(),
                                  limit, most ? fmt::format(", up to {}", *most) : ""));
}

}  // namespace mwt
