// Looks for the certified optimum of an instance among the exact algorithms.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/catalogue.h"
#include "harness/execution.h"
#include "harness/optimum_cache.h"
#include "harness/study/process_pool.h"
#include "harness/study/study.h"

namespace mwt {

struct FoundOptimum {
  std::optional<Interval> interval;
  std::string source;          ///< the algorithm whose bounds these are; several joined by '+'
  double time_s = 0;           ///< of the search
  bool is_cached = false;      ///< at least partly from the optimum cache
  std::string note;            ///< why there is no proved optimum; "cached" if the cache had it
  bool contradiction = false;  ///< two sources certified intervals that do not overlap: one of them is wrong
};

/// The algorithms to ask for the optimum of n points, in order: those of `sources` whose limits admit n, or, if that
/// list is empty, every exact algorithm that does, the one that reaches furthest first. Algorithms for convex position
/// come before all others there and are left out elsewhere. Throws InputError, naming the study file's line: unknown or
/// not exact.
[[nodiscard]] std::vector<const AlgorithmInfo*> optimum_sources_for(const Catalogue& catalogue,
                                                                    const std::vector<OptimumSource>& sources, Index n,
                                                                    bool in_convex_position = false);

/// What the optimum of an instance is cached under.
[[nodiscard]] OptimumKey optimum_key(const std::string& instance_id, const AlgorithmInfo& solver,
                                     const Parameters& parameters);

/// Asks one source after the other, each in a process of its own, until one proves the optimum; bounds from those that
/// do not are kept and combined. What the cache has for any of the sources comes first, what one of them proves goes
/// into it; null: no cache. Precondition: the pool is not full.
void seek_optimum(ProcessPool& pool, std::shared_ptr<const Instance> instance,
                  std::vector<const AlgorithmInfo*> sources, const RunLimits& limits, OptimumCache* cache,
                  std::function<void(FoundOptimum)> when_done);

}  // namespace mwt
