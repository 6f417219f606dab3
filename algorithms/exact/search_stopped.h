// How a stage of the exact solver says that it cannot go on.
#pragma once

#include <stdexcept>

namespace mwt {

/// Too many edges pass the diamond test for the memory that a solver may reasonably take, or the deadline has passed.
class SearchStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  SearchStopped(const char* reason, double optimum_at_least) : runtime_error(reason), lower_bound(optimum_at_least) {}

  double lower_bound = 0;  ///< certified: no triangulation of the points is lighter
};

}  // namespace mwt
