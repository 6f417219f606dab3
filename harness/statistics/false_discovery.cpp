#include "harness/statistics/false_discovery.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace mwt {

std::vector<double> benjamini_hochberg(std::span<const double> p_values) {
  for (const double p : p_values) {
    if (!(p >= 0 && p <= 1)) throw std::invalid_argument("a p-value lies between 0 and 1");
  }
  std::vector<std::size_t> from_largest(p_values.size());
  std::iota(from_largest.begin(), from_largest.end(), std::size_t{0});
  std::sort(from_largest.begin(), from_largest.end(),
            [&](std::size_t a, std::size_t b) { return p_values[a] > p_values[b]; });

  const double tests = static_cast<double>(p_values.size());
  std::vector<double> adjusted(p_values.size());
  double smallest = 1;
  double rank = tests;
  for (const std::size_t i : from_largest) {
    smallest = std::min(smallest, p_values[i] * tests / rank);
    adjusted[i] = smallest;
    rank -= 1;
  }
  return adjusted;
}

}  // namespace mwt
