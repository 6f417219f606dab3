// Proved optima that outlive studies: each instance is solved once, for whichever study or command.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/numbers/interval.h"

namespace mwt {

/// What was solved by what. Results are deterministic, so that seed, threads and limits are no part of it: a proved
/// optimum is proved whatever they were.
struct OptimumKey {
  std::string instance_id;
  std::string solver;
  int version = 1;         ///< AlgorithmInfo::version
  std::string parameters;  ///< Parameters::canonical()

  friend bool operator==(const OptimumKey&, const OptimumKey&) = default;
};

struct CachedOptimum {
  Interval interval;
  double solve_time_s = 0;  ///< of the algorithm alone, when it was solved
};

/// The default place of the cache: $MWT_CACHE_DIR, else $XDG_CACHE_HOME/mwt/optima, else
/// $HOME/.cache/mwt/optima; variables that are empty, and XDG_CACHE_HOME if it is not absolute, count as unset. Empty
/// if none is set.
[[nodiscard]] std::string optimum_cache_folder();

/// A folder with one small text file per key, named by the key, and perhaps a proof beside it; the folder is made when
/// the first file is stored.
///
/// Safe without a lock under concurrent writers, on several machines that share the folder too, and under kill -9: a
/// file appears complete, by renaming, or not at all, and it ends in a hash of its content. Of two writers of one key
/// the last one counts; what both wrote is true. A killed writer leaves at most a temporary file, which nobody reads
/// and which the first store() of a later process removes once it is an hour old.
///
/// Only proved optima are kept (Optimality::proved): they hold whatever the limits, bounds would not. A file that is
/// torn, altered, of another key or not proved counts as absent and is replaced by the next store; so does whatever is
/// no regular file (a fifo, a device, a link to nowhere): it is neither read nor written.
///
/// The hash protects from accidents, not from intent: an entry with plausible numbers and a new hash counts like a
/// solver's result, until a triangulation disproves it (discard_disproved()). A proof is as good as what the verifier
/// says of it: whoever takes one out has it verified.
///
/// Nothing here fails: a folder that cannot be written means no caching. `warn` is called with one line for the first
/// trouble of each kind. Time per access: one small file. Not thread-safe: one object per thread.
class OptimumCache {
 public:
  OptimumCache(std::string folder, std::function<void(const std::string&)> warn);

  [[nodiscard]] std::optional<CachedOptimum> find(const OptimumKey& key);

  /// Does nothing unless the interval is proved.
  void store(const OptimumKey& key, const CachedOptimum& optimum);

  /// Copies the proof of an optimum that is in the cache to `file`. Returns whether there is one.
  [[nodiscard]] bool fetch_proof(const OptimumKey& key, const std::string& file);

  /// Copies the proof in `file` beside the optimum of that key. Does nothing if there is no such optimum.
  void store_proof(const OptimumKey& key, const std::string& file);

  void discard_proof(const OptimumKey& key);

  /// Removes every entry of the instance, of whatever solver, version and parameters, that claims more than `weight`,
  /// the upper end of the weight of a checked triangulation, with its proof; what cannot be removed this object finds
  /// no more. Returns the entries' paths. Time: the folder is read once.
  std::vector<std::string> discard_disproved(const std::string& instance_id, double weight);

  /// The file that holds the entry, for messages.
  [[nodiscard]] std::string path_of(const OptimumKey& key) const;
  [[nodiscard]] std::string proof_path_of(const OptimumKey& key) const;

  [[nodiscard]] const std::string& folder() const { return folder_; }

 private:
  void put(const std::string& path, const std::string& content);

  std::string folder_;
  std::function<void(const std::string&)> warn_;
  std::set<std::string> distrusted_;  // disproved, but they cannot be removed
  bool can_store_ = true;
  bool warned_of_content_ = false;
  bool is_swept_ = false;
};

}  // namespace mwt
