#include "harness/statistics/holm.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace mwt {

std::vector<double> holm_adjusted(std::span<const double> p_values) {
  const bool all_are_p_values = std::ranges::all_of(p_values, [](double p) { return p >= 0 && p <= 1; });
  if (!all_are_p_values) throw std::invalid_argument("a p-value lies between 0 and 1");
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p_values[i]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, p_values[order[i]] * static_cast<double>(order.size() - i));
    adjusted[order[i]] = std::min(largest, 1.0);
  }
  return adjusted;
}

}  // namespace mwt
