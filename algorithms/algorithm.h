// What an algorithm is: a pure function from points and a context to a solution, and how it introduces itself.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/stop_reason.h"
#include "base/parameters.h"
#include "geometry/numbers/interval.h"
#include "geometry/point.h"
#include "geometry/triangulation.h"

namespace mwt {

struct ProofTrace;  // algorithms/proof_trace.h
struct StepTrace;   // algorithms/step_trace.h

/// The algorithm does not take this instance (too many points, not in convex position, ...). Not a failure: the
/// message states what it takes.
class NotApplicable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One flip: `removed` was replaced by `added`; gain > 0 is how much shorter the new edge is (for display; the decision
/// itself was exact).
struct Flip {
  Edge removed;
  Edge added;
  double gain = 0;
};

/// What an execution cost another process than the one that measures.
struct OutsideCost {
  double wall_time_s = 0;
  double cpu_time_s = 0;
  std::uint64_t peak_rss_bytes = 0;
};

/// What the caller gives an algorithm besides the points, and where it reports on its work.
class Context {
 public:
  using Clock = std::chrono::steady_clock;

  std::uint64_t seed = 1;
  int threads = 1;
  Parameters parameters;                      ///< complete: every declared parameter has a value
  Deadline deadline;                          ///< soft: return the best valid triangulation found by then
  std::optional<std::uint64_t> memory_bytes;  ///< soft: no larger tables than that; none: as much as it takes
  ProofTrace* proof = nullptr;                ///< optional: where a solver notes its conclusions for mwt_verify
  StepTrace* steps = nullptr;                 ///< optional: where an algorithm notes what it does, step by step
  std::optional<Triangulation> start;         ///< a given triangulation to start from, already checked
  std::function<void(const std::string& stage, double done)> progress;  ///< optional; done in [0, 1]
  std::vector<std::pair<std::string, double>> phases;                   ///< seconds per named phase, in order
  std::optional<OutsideCost>
      outside;  ///< set by an algorithm that runs in another process: counts in place of this one's

  /// Call it about once per millisecond of work; reading the clock takes some tens of nanoseconds.
  [[nodiscard]] bool deadline_passed() const { return has_passed(deadline); }

  /// Whether tables of so many bytes may be made. An algorithm for which they may not stops with StopReason::memory.
  [[nodiscard]] bool fits(std::uint64_t bytes) const { return !memory_bytes || bytes <= *memory_bytes; }
};

/// Adds the lifetime of this object to context.phases under `name`.
class ScopedPhase {
 public:
  ScopedPhase(Context& context, std::string name) : context_(context), name_(std::move(name)) {}
  ~ScopedPhase() {
    const std::chrono::duration<double> elapsed = Context::Clock::now() - start_;
    context_.phases.emplace_back(std::move(name_), elapsed.count());
  }
  ScopedPhase(const ScopedPhase&) = delete;
  ScopedPhase& operator=(const ScopedPhase&) = delete;

 private:
  Context& context_;
  std::string name_;
  Context::Clock::time_point start_ = Context::Clock::now();
};

struct Solution {
  Triangulation triangulation;
  std::optional<Interval> optimum;           ///< certified bounds on the weight of a minimum weight triangulation
  std::optional<std::string> count;          ///< exact number of triangulations, decimal
  std::vector<Flip> flips;                   ///< trace, for algorithms that flip
  std::map<std::string, double> counters{};  ///< what was done, by snake_case name
  std::optional<double> claimed_lower{};     ///< a lower bound that nobody certifies, of an algorithm that is a command
  std::optional<StopReason> stop_reason;     ///< why less was done than the entry promises; none: nothing stopped it

  [[nodiscard]] bool stopped_early() const { return stop_reason.has_value(); }
};

using AlgorithmFunction = std::function<Solution(Points points, Context& context)>;

enum class Exactness { heuristic, exact };

/// A registry entry.
struct AlgorithmInfo {
  std::string name;
  std::string summary;    ///< one line
  std::string source;     ///< citation, or the source report's section
  std::string guarantee;  ///< the proven bound on alpha, with its source, or "none known"
  std::string time;       ///< e.g. "O(n log n)"
  std::string space;
  Exactness exactness = Exactness::heuristic;
  Index max_n = 0;                    ///< largest sensible n: studies go no further; 0: no limit
  int version = 1;                    ///< raised whenever a change may alter results: keys cached optima
  bool convex_position_only = false;  ///< NotApplicable unless all points lie on the hull's boundary
  bool has_proofs = false;            ///< fills the proof that the context asks for
  bool has_steps = false;             ///< fills the steps that the context asks for
  bool runs_outside = false;          ///< in another process: fills context.outside
  std::vector<ParameterInfo> parameters;
  AlgorithmFunction function = nullptr;
};

}  // namespace mwt
