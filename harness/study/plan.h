// From a study to the list of its instances and runs, before anything is run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/catalogue.h"
#include "harness/study/study.h"

namespace mwt {

struct PlannedInstance {
  const GeneratorInfo* family = nullptr;
  Parameters parameters;
  Index n = 0;
  std::uint64_t seed = 0;

  /// "uniform n=100 seed=1", for messages.
  [[nodiscard]] std::string label() const;
  [[nodiscard]] std::vector<Point> generate() const { return generate_points(*family, n, seed, parameters); }
};

struct PlannedRun {
  std::size_t instance = 0;  ///< position in Plan::instances
  const AlgorithmInfo* algorithm = nullptr;
  Parameters parameters;
  int repetition = 0;
  Index largest_n = 0;                      ///< beyond it the run is recorded as not_applicable without being started
  std::optional<std::string> start_file{};  ///< path of the triangulation to start from
  std::string run_id;  ///< hash of study name, instance, algorithm, parameters, repetition: the same on every machine
};

struct Plan {
  std::vector<PlannedInstance> instances;
  std::vector<PlannedRun> runs;    ///< by instance, then by repetition, so that repetitions interleave
  std::vector<std::string> notes;  ///< what was left out or changed, for the user
};

/// A named instance (fixed n) is planned once, a family that no seed changes with the first seed only. A size that the
/// family does not have becomes the nearest one it has within an eighth (at least 5), or is left out with a note.
/// Equal cells are planned once. Generates one instance per family and size to find out.
/// Throws InputError, naming the study file's line: unknown names, wrong parameters, no sizes where needed.
[[nodiscard]] Plan make_plan(const Study& study, const Catalogue& catalogue);

/// The smaller of an entry's and a study's limit; 0 in an entry means none.
[[nodiscard]] Index largest_n_for(const AlgorithmInfo& algorithm, const std::optional<Index>& of_study);

}  // namespace mwt
