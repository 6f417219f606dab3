// The exception by which a stage of the exact solver stops.
#pragma once

#include <stdexcept>
#include <string>

#include "algorithms/stop_reason.h"

namespace mwt {

/// The deadline has passed, or a part of the problem is too large.
class SearchStopped : public std::runtime_error {
 public:
  SearchStopped(StopReason why, const std::string& message, double optimum_at_least = 0)
      : runtime_error(message), reason(why), lower_bound(optimum_at_least) {}

  StopReason reason;
  double lower_bound;  ///< certified: no triangulation of the points is lighter
};

}  // namespace mwt
