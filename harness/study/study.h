// A study: what is to be run, as read from a study file. harness/studies/README.md documents the file's keys.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/algorithm.h"
#include "geometry/point.h"
#include "harness/rating/isolated_run.h"
#include "harness/rating/optimum_search.h"
#include "harness/run/catalogue.h"
#include "harness/study/instance_files.h"

namespace mwt {

/// One family with its parameters; sizes and seeds are the study's unless it has its own.
struct FamilyChoice {
  std::string name;  ///< "*": every family that the study does not name otherwise
  std::map<std::string, std::string> parameters;
  std::vector<Index> sizes;
  std::vector<std::uint64_t> seeds;
  std::string place;  ///< "FILE:LINE" for messages
};

/// One algorithm with its parameters.
struct AlgorithmChoice {
  std::string name;  ///< "*": every algorithm that the study does not name otherwise
  std::map<std::string, std::string> parameters;
  std::optional<Index> max_n;  ///< at most the registry's
  std::string place;
  std::vector<std::string> families{};  ///< run on these alone; empty: on all of the study
};

/// An algorithm of the study's own: a command.
struct StudyCommand {
  AlgorithmInfo info;
  std::string content_hash;  ///< of the command and the files that it names
};

/// The first repetitions of a run are counted, each by itself: the second confirms the first.
inline constexpr int kCountedRepetitions = 2;

struct Study {
  std::string name;
  std::string summary;
  std::string file_content;  ///< copied into the results
  std::string folder;        ///< of the study file: start triangulations that it names are sought here
  std::vector<FamilyChoice> families;
  InstanceFiles instance_files;
  std::vector<Index> sizes;
  std::vector<std::uint64_t> seeds = {1};
  std::vector<AlgorithmChoice> algorithms;
  std::vector<StudyCommand> commands;  ///< of those among them that have one, in the order of the file
  int repetitions = 1;
  int threads = 1;
  double min_time_s = 0.005;  ///< CPU time; shorter executions are repeated until they fill it (repeated_timing.h)
  bool measures_delaunay_time = false;  ///< every run also times CGAL's Delaunay triangulation of its points
  std::size_t max_counted_n = 0;        ///< runs on at most so many points are counted under callgrind (counted_run.h)
  RunLimits limits;
  RunLimits optimum_limits;
  bool seeks_optimum = true;
  std::size_t max_proof_n = 0;                 ///< optima of at most so many points are proved in files and verified
  std::vector<OptimumSource> optimum_sources;  ///< run in this order; empty: every exact algorithm of the registry
};

/// Reads a study file. A parameter whose value is a list stands for one choice per element; several lists multiply.
/// Throws InputError "FILE:LINE: what; remedy": not TOML, an unknown key, a value of the wrong type
/// or range, a missing key; an `instance_folder`, which replaces that of the study's point files, for a study without
/// any. Names of families and algorithms are checked when the study is planned.
[[nodiscard]] Study read_study(const std::string& path, const std::optional<std::string>& instance_folder = {});

/// The commands among the algorithms of a study file, which needs to have no more than those; none without a file.
/// Throws InputError as read_study(), and if the file has none.
[[nodiscard]] std::vector<StudyCommand> read_commands(const std::optional<std::string>& study_file);

/// What a file chooses of a study's results; a list that it lacks is empty.
struct ResultChoice {
  std::vector<std::string> families;
  std::vector<Index> sizes;
  std::vector<std::string> algorithms;
};

/// Reads the lists `families`, `sizes` and `algorithms` of a TOML file, at least one of them. Throws InputError as
/// read_study().
[[nodiscard]] ResultChoice read_result_choice(const std::string& path);

/// The algorithm of that name: of the commands, else of the catalogue. Throws InputError as Catalogue::algorithm().
[[nodiscard]] const AlgorithmInfo& algorithm_named(const std::string& name, const std::vector<StudyCommand>& commands,
                                                   const Catalogue& catalogue);

/// Whether a study of this content (of a study file, or of study.toml in results) is made to judge the source report's
/// claims: its key `claims`. Throws InputError: not TOML.
[[nodiscard]] bool judges_claims(const std::string& study_file);

/// The path of a study: itself if it is a file or looks like a path, else a study of that name in the project's
/// harness/studies. Throws InputError listing the known names.
[[nodiscard]] std::string find_study_file(const std::string& name_or_path);

/// The names of the project's studies, sorted.
[[nodiscard]] std::vector<std::string> study_names();

}  // namespace mwt
