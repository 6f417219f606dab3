// What the page can have done: points made or read, algorithms run and rated. Each job answers in frames, in a process
// of its own, and does whatever may take long or fail in the isolated workers of studies.
#pragma once

#include <cstdint>
#include <string>

#include "harness/explore/server/job_host.h"
#include "harness/rating/isolated_run.h"
#include "harness/run/catalogue.h"

namespace mwt {

/// What a page may ask for.
struct JobLimits {
  Index max_n = 1'000'000;
  Index max_played_n = 5'000;                           ///< step by step
  double max_time_s = 60;                               ///< of each algorithm; a request may ask for less
  double points_time_s = 20;                            ///< to make or read points
  std::uint64_t memory_bytes = std::uint64_t{1} << 30;  ///< of each algorithm

  /// Of a whole job: all exact algorithms may get their turn.
  [[nodiscard]] unsigned job_time_s() const { return static_cast<unsigned>(6 * max_time_s + points_time_s); }
  [[nodiscard]] std::uint64_t job_memory_bytes() const { return 3 * memory_bytes; }
};

/// Does the job that the request, an encoded frame, names by its JSON key `job`:
///
///   generate  family, n, seed, parameters {name: value}            -> points
///   open      name (its ending is the format), bytes of the file   -> points
///   solve     algorithms [{name, parameters}], seed, optimum (true: seek the proved optimum, too), time_limit_s,
///             bytes of the points                                  -> instance, run..., rating... and optimum
///   play      algorithm {name, parameters}, seed, time_limit_s, bytes of the points  -> instance, trace
///   prove     as play                                              -> proof
///   hunt      algorithm {name, parameters}, n, seed, time_limit_s: the search of `mwt hunt` by one climber  ->
///   hunted...
///
/// Every frame of the answer has a `type`. The last one is `end`, or `error` with a message for people: a mistake in
/// the request, points that are no instance. An algorithm that crashes, hangs or takes too much memory is a `run` with
/// that status. Without a last frame the job was ended at its limits.
///
///   points    n                                                      bytes: points in input order
///   instance  n, distinct, duplicates, hull_size, instance_id
///   run       slot (position among `algorithms`), run {...} without rating, edges, triangles; bytes: the edges,
///   sorted,
///             and the triangles as positions in the input
///   optimum   source, status, optimum_lower, optimum_upper, note, wall_time_s, edges, triangles; bytes as of a run:
///   the
///             lightest triangulation that an exact algorithm returned
///   trace     steps, boxes, start_edges (counts), stages [{name, reason, begin}]; bytes: bytes_of(PlayedSteps)
///   proof     bytes: a proof file for mwt_verify
///   hunted    alpha, evaluations; bytes: the points, if they are worse than those before
///   rating    slot, run {...}: with optimum and alpha, as mwt solve --with-optimum states them
void do_job(const Catalogue& catalogue, const JobLimits& limits, const std::string& request, const JobAnswer& answer);

/// The `points` frame, with the `name` of where they are from.
[[nodiscard]] Frame points_frame(const std::string& name, Points points);

}  // namespace mwt
