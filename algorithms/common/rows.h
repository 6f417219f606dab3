// Values filed in rows, one row behind the other in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace mwt {

/// Row r holds values[first[r]] .. values[first[r + 1]]. There is one more `first` than there are rows.
template <class Value>
struct Rows {
  std::vector<std::uint32_t> first{0};
  std::vector<Value> values;

  [[nodiscard]] std::span<const Value> operator[](std::size_t row) const {
    return std::span(values).subspan(first[row], first[row + 1] - first[row]);
  }
  [[nodiscard]] std::span<Value> operator[](std::size_t row) {
    return std::span(values).subspan(first[row], first[row + 1] - first[row]);
  }
};

/// Files values by counting: `visit(file)` must call file(row, value) for every value, and make the same calls both
/// times that it is called, once to count and once to file. Within a row, values keep the order of these calls.
/// Precondition: rows below `count`; fewer than 2^32 values. O(count + values).
template <class Value, class Visit>
[[nodiscard]] Rows<Value> file_in_rows(std::size_t count, const Visit& visit) {
  Rows<Value> rows;
  rows.first.assign(count + 1, 0);
  visit([&](std::size_t row, const Value&) { ++rows.first[row + 1]; });
  std::partial_sum(rows.first.begin(), rows.first.end(), rows.first.begin());
  rows.values.resize(rows.first.back());
  std::vector<std::uint32_t> next(rows.first.begin(), rows.first.end() - 1);
  visit([&](std::size_t row, const Value& value) { rows.values[next[row]++] = value; });
  return rows;
}

}  // namespace mwt
