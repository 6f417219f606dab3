#include "harness/run/catalogue.h"

#include <fmt/core.h>

#include <new>

#include "algorithms/registry.h"
#include "base/error.h"
#include "generators/generation.h"
#include "generators/registry.h"
#include "harness/run/machine/proc_file.h"

namespace mwt {

namespace {

// The points, copies of them while they are made, checked and compared, and their hull.
constexpr std::uint64_t kBytesPerPoint = 100;

template <class Info>
const Info& find(std::span<const Info> entries, const std::string& kind, const std::string& name) {
  std::string known;
  for (const Info& entry : entries) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw InputError(fmt::format("unknown {} '{}'; known: {}", kind, name, known));
}

}  // namespace

Catalogue Catalogue::built_in() { return {mwt::algorithms(), mwt::generators()}; }

const AlgorithmInfo& Catalogue::algorithm(const std::string& name) const {
  return find(algorithms_, "algorithm", name);
}

const GeneratorInfo& Catalogue::generator(const std::string& name) const {
  return find(generators_, "generator", name);
}

std::vector<Point> generate_points(const GeneratorInfo& family, Index n, std::uint64_t seed,
                                   const Parameters& parameters) {
  const std::uint64_t needed = kBytesPerPoint * n;
  const std::uint64_t available = kilobytes_in("/proc/meminfo", "MemAvailable:").value_or(needed / 1024) * 1024;
  const std::string what = fmt::format("{} n={}", family.name, n);
  if (needed > available) {
    throw NotEnoughMemory(fmt::format("{}: needs about {} GB of memory, but {} GB are free; choose a smaller n", what,
                                      needed >> 30, available >> 30));
  }
  try {
    return generate_verified(family, n, seed, parameters);
  } catch (const std::bad_alloc&) {
    throw NotEnoughMemory(what + ": not enough memory for the points; choose a smaller n");
  }
}

Index max_n_for(const AlgorithmInfo& algorithm, const std::optional<Index>& other) {
  const Index own = algorithm.max_n == 0 ? kNoIndex : algorithm.max_n;
  return std::min(own, other.value_or(kNoIndex));
}

}  // namespace mwt
