// The proof file of one search for an optimum.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/algorithm.h"
#include "harness/rating/optimum_cache.h"
#include "harness/rating/proof_check.h"
#include "harness/rating/rated_run.h"

namespace mwt {

/// Brings one proof to `path`: from the cache, or of the source that certified most. An empty path: none is asked for,
/// and nothing happens. `cache` may be null. Nothing here fails: a proof that cannot be written or moved is none.
class SoughtProof {
 public:
  SoughtProof(std::string path, OptimumCache* cache) : path_(std::move(path)), cache_(cache) {}

  /// Removes what an earlier search left, and takes the first proof of these entries that the cache has.
  void begin(const std::vector<OptimumKey>& cached);

  /// Whether a source with proofs should run even if the optimum is known already.
  [[nodiscard]] bool is_missing() const { return !path_.empty() && !is_tried_; }

  /// Where the source is to write its proof; empty if it has none.
  [[nodiscard]] std::string candidate_of(const AlgorithmInfo& source);

  /// After the source has run: keeps its proof unless an earlier one proves as much.
  void keep_if_better(const OptimumKey& key, const RatedRun& run);

  [[nodiscard]] bool exists() const { return key_.has_value(); }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Whether the proof must be made anew, because it is the cache's and not accepted; then it is gone from there.
  [[nodiscard]] bool must_be_made_anew(const ProofCheck& check);

  /// Puts a new and accepted proof of an optimum into the cache. Precondition: exists().
  void cache_if_new(const ProofCheck& check) const;

 private:
  [[nodiscard]] std::string candidate() const { return path_ + ".new"; }

  std::string path_;
  OptimumCache* cache_;
  std::optional<OptimumKey> key_;  // of the source whose proof is in the file
  double lower_ = -1;              // what that source certified
  bool is_from_cache_ = false;
  bool is_tried_ = false;
};

}  // namespace mwt
