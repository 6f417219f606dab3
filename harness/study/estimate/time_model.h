// How long a run will take, from how long others took.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "harness/rating/rated_run.h"

namespace mwt {

/// What a run is, as far as its time goes: names with their parameters, "patch k=14", and the number of points.
struct TimedCell {
  std::string algorithm;
  std::string family;
  Index n = 0;

  friend auto operator<=>(const TimedCell&, const TimedCell&) = default;
};

/// What a prediction rests on, the best first.
enum class TimeBasis {
  recorded,        ///< earlier runs of the cell
  measured,        ///< a run of the cell, made for this purpose
  other_sizes,     ///< runs of the algorithm on the family at other sizes
  other_families,  ///< runs of the algorithm on other families
  other_variants,  ///< runs of the algorithm with other parameters
  nothing,
};

struct TimePrediction {
  double seconds = 0;
  double low = 0;  ///< it will probably take low .. high
  double high = 0;
  TimeBasis basis = TimeBasis::nothing;
};

struct TimeObservation {
  double seconds = 0;     ///< as on an idle machine: undisturbed_time_s()
  bool at_limit = false;  ///< the run was stopped, or stopped itself, at its time limit: it may take longer
  bool is_record = true;  ///< of a study; otherwise made to predict times
};

/// What a run would have taken on an idle machine: CPU time, if it had one thread and ran for long enough to share the
/// CPU with other programs and for the ticks of CPU clocks not to matter. Nothing if it has no time.
[[nodiscard]] std::optional<double> undisturbed_time_s(const RatedRun& run, int threads);

/// Observed times, and what follows from them. Between two sizes and beyond the largest, time grows like a power of n
/// (beyond: at least linearly); a family without observations is like the median of the others.
class TimeModel {
 public:
  void add(const TimedCell& cell, const TimeObservation& observation);

  /// No run takes longer than `limit_s`; without any observation, that is the prediction.
  [[nodiscard]] TimePrediction predict(const TimedCell& cell, double limit_s) const;

 private:
  using Sizes = std::map<Index, std::vector<TimeObservation>>;
  using Families = std::map<std::string, Sizes>;

  [[nodiscard]] static std::optional<TimePrediction> within_family(const Sizes& sizes, Index n, double limit_s);
  [[nodiscard]] static std::optional<TimePrediction> within_algorithm(const Families& families,
                                                                      const std::string& family, Index n,
                                                                      double limit_s);

  std::map<std::string, Families> algorithms_;
};

}  // namespace mwt
