// From a study to the list of its instances and runs, before anything is run.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "harness/run/catalogue.h"
#include "harness/study/study.h"

namespace mwt {

/// `generator` of instances that were read from a file; their parameters are "file=NAME".
inline constexpr const char* kFileGenerator = "file";

struct PlannedInstance {
  std::string generator;   ///< a family, or kFileGenerator
  std::string parameters;  ///< in canonical form
  Index n = 0;             ///< duplicates included
  std::uint64_t seed = 0;
  std::function<std::vector<Point>()> make_points;  ///< throws InputError if there is no such instance after all
  std::string file_instance_id{};                   ///< of a file: content hash of its points when the plan was made

  /// "uniform n=100 seed=1", for messages.
  [[nodiscard]] std::string label() const;
};

struct PlannedRun {
  std::size_t instance = 0;  ///< position in Plan::instances
  const AlgorithmInfo* algorithm = nullptr;
  Parameters parameters;
  int repetition = 0;
  Index max_n = 0;                          ///< beyond it the run is recorded as not_applicable without being started
  std::optional<std::string> start_file{};  ///< path of the triangulation to start from
  std::string run_id;  ///< hash of study name, instance, algorithm, parameters, repetition and the content of the files
                       ///< that these name: the same on every machine
};

struct Plan {
  std::vector<PlannedInstance> instances;
  std::vector<PlannedRun> runs;    ///< by instance, then by repetition; within these in a random order, always the same
  std::vector<std::string> notes;  ///< what was left out or changed, for the user
};

/// A named instance (fixed n) is planned once, an unseeded family and a file with the first seed only. A
/// size that the family does not have becomes the nearest one it has within an eighth (at least 5), or is left out with
/// a note, as is a file without usable points. Equal cells are planned once. Generates one instance per family and
/// size, and reads every file, to find out.
/// Throws InputError, naming the study file's line: unknown names, wrong parameters, no sizes where needed, no files.
[[nodiscard]] Plan make_plan(const Study& study, const Catalogue& catalogue);

[[nodiscard]] std::set<std::string> run_ids_of(const Plan& plan);

/// One of several parts of a study that can be run apart.
struct Shard {
  std::size_t number = 1;  ///< 1 .. count
  std::size_t count = 1;

  /// "2/4"; empty for the whole study.
  [[nodiscard]] std::string text() const;
};

/// From "i/N". Throws InputError unless 1 <= i <= N.
[[nodiscard]] Shard parse_shard(const std::string& text);

/// The instances of one shard with all their runs, in the plan's order. Every instance is in exactly one of the `count`
/// shards; each shard gets its share of every size.
[[nodiscard]] Plan part_of(const Plan& plan, const Shard& shard);

/// The instances with these labels and all their runs, in the plan's order.
[[nodiscard]] Plan part_of(const Plan& plan, const std::set<std::string>& labels);

}  // namespace mwt
