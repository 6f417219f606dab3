// Looks for the certified optimum of an instance among the exact algorithms.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/rating/isolated_run.h"
#include "harness/rating/optimum_cache.h"
#include "harness/rating/optimum_claims.h"
#include "harness/rating/proof_check.h"
#include "harness/run/catalogue.h"
#include "harness/run/execution.h"
#include "harness/run/process_pool.h"

namespace mwt {

/// An exact algorithm that may compute the optimum of an instance.
struct OptimumSource {
  std::string algorithm;
  std::optional<Index> max_n;  ///< at most the registry's
  std::string place;           ///< "FILE:LINE" for messages
};

/// The note on an optimum that came from the optimum cache.
inline constexpr const char* kCachedNote = "cached";

struct FoundOptimum {
  std::optional<Interval> interval;
  std::string source;      ///< the algorithms whose bounds these are, joined by '+'
  double time_s = 0;       ///< of the search
  bool is_cached = false;  ///< from the optimum cache
  std::string note;        ///< without a proved optimum, the outcome of each source that ran; kCachedNote if cached
  std::vector<std::string> contradictions{};  ///< claims of sources that a triangulation disproves; in the note, too
  std::vector<std::string> warnings{};        ///< about entries of the cache that are ignored
  std::optional<ProofCheck> proof{};          ///< of the proof, if one was asked for and is there
};

/// The algorithms to run for the optimum of n points, in order: those of `sources` whose limits admit n, or, if that
/// list is empty, every exact algorithm that does, the one that reaches furthest first. Algorithms for convex position
/// come before all others there and are left out elsewhere. Throws InputError, naming the study file's line: unknown or
/// not exact.
[[nodiscard]] std::vector<const AlgorithmInfo*> optimum_sources_for(const Catalogue& catalogue,
                                                                    const std::vector<OptimumSource>& sources, Index n,
                                                                    bool in_convex_position = false);

/// What the optimum of an instance is cached under.
[[nodiscard]] OptimumKey optimum_key(const std::string& instance_id, const AlgorithmInfo& solver,
                                     const Parameters& parameters);

/// What to do for the optimum of an instance.
struct OptimumRequest {
  std::shared_ptr<const Instance> instance;
  std::vector<const AlgorithmInfo*> sources;
  RunLimits limits;                    ///< of each source, and of the verifier
  OptimumCache* cache = nullptr;       ///< null: no cache
  std::optional<KnownWeight> known{};  ///< a checked triangulation
  std::string proof_file{};            ///< where the proof goes; empty: none is asked for
};

/// Runs one source after the other, each in a process of its own, until one proves the optimum; bounds from those that
/// do not are kept and combined. What the cache has for any of the sources comes first, what one of them proves goes
/// into it. Claims that a triangulation disproves, the known one or that of another source, do not
/// count; if one of them is in the cache, nothing there counts, the optimum is sought anew, and what is disproved in
/// the end is removed from it.
///
/// If a proof is asked for, the source that certifies most writes one, and the verifier checks it in the end; one that
/// it accepts goes into the cache. A cached optimum without a proof, or with one that the verifier does not accept, is
/// sought anew by the first source that has proofs. An earlier proof_file is replaced or removed. Precondition: the
/// pool is not full.
void seek_optimum(ProcessPool& pool, OptimumRequest request, std::function<void(FoundOptimum)> when_done);

/// The same in this process, without limits but the deadline of each source, and without a cache.
[[nodiscard]] FoundOptimum seek_optimum_here(const Instance& instance, const std::vector<const AlgorithmInfo*>& sources,
                                             double time_limit_s);

}  // namespace mwt
