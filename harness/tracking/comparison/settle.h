// Settles by running two builds in turn what their two folders of results leave open.
#pragma once

#include <optional>
#include <set>

#include "harness/tracking/comparison/comparison.h"
#include "harness/tracking/comparison/interleaved_builds.h"

namespace mwt {

/// So often the two builds are run and looked at, at most.
inline constexpr int kMaxLooks = 3;

/// Runs the cells `repetitions` times in turn and compares; cells that are unclear then, and those of algorithms that
/// are, so many times more, and once again: a noisy cell needs more repetitions. A row keeps the first verdict that is
/// not `unclear`. Every look uses a third of options.error_rate, so that three of them err as seldom as one.
///
/// Nothing if interrupted. Throws InputError as InterleavedBuilds. Precondition: `cells` is a part of builds.cells(),
/// not empty.
[[nodiscard]] std::optional<Comparison> settle(std::set<TrackedCell> cells, InterleavedBuilds& builds, int repetitions,
                                               CompareOptions options);

/// Comparisons one after the other, each of the cells that were open in those before, as one. Taken apart from settle()
/// for its tests.
void take_over(Comparison& all, Comparison latest, const std::set<TrackedCell>& cells);

/// What two folders and the runs in turn come to together.
struct Settled {
  Comparison folders;
  std::optional<Comparison> in_turn;  ///< nothing: the folders left nothing open
  std::set<TrackedCell> not_run;      ///< open in the folders, but the study does not have them

  /// That of the runs in turn, where there are any; what was not run keeps the folders' verdict.
  [[nodiscard]] Outcome outcome() const;
};

}  // namespace mwt
