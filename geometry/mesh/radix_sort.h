// Sorting of 64-bit keys by their bytes: linear time, for the millions of edges that a comparison sort is slow on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "geometry/mesh/kept_memory.h"

namespace mwt {

/// Sorts `keys` by the bits [low_bit, high_bit) of each; stable. O(n (high_bit - low_bit)) time, n more words of space,
/// kept in `buffer` for reuse. Precondition: low_bit <= high_bit <= 64.
///
/// Measured against boost::sort::spreadsort::integer_sort on 1e5 to 3e6 random keys of 32 and 34 bits (best of 9, CPU
/// time): 2 to 4 times as fast; all of greedy on a circle or a spiral of a million points takes 2% to 5% less time.
inline void radix_sort(KeptVector<std::uint64_t>& keys, int low_bit, int high_bit, KeptVector<std::uint64_t>& buffer) {
  constexpr int kDigitBits = 11;
  constexpr std::uint64_t kDigitMask = (std::uint64_t{1} << kDigitBits) - 1;
  buffer.resize(keys.size());
  for (int bit = low_bit; bit < high_bit; bit += kDigitBits) {
    const std::uint64_t mask = high_bit - bit >= kDigitBits ? kDigitMask : (std::uint64_t{1} << (high_bit - bit)) - 1;
    std::array<std::size_t, kDigitMask + 1> place{};
    for (const std::uint64_t key : keys) ++place[(key >> bit) & mask];
    std::size_t sum = 0;
    for (std::size_t& start : place) {
      const std::size_t count = start;
      start = sum;
      sum += count;
    }
    for (const std::uint64_t key : keys) buffer[place[(key >> bit) & mask]++] = key;
    keys.swap(buffer);
  }
}

}  // namespace mwt
