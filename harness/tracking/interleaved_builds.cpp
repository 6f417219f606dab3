#include "harness/tracking/interleaved_builds.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "generators/random.h"
#include "geometry/error.h"
#include "geometry/input_file.h"
#include "geometry/number_text.h"
#include "geometry/output_file.h"
#include "harness/command_line.h"
#include "harness/progress.h"
#include "harness/study/interrupt.h"
#include "harness/study/plan.h"
#include "harness/study/results_folder.h"
#include "harness/text.h"
#include "harness/tracking/result_set.h"
#include "harness/tracking/run_program.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

/// As a TOML string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// "a=1 b=x" as a TOML table: { a = "1", b = "x" }.
std::string toml_table(const std::string& parameters) {
  std::vector<std::string> entries;
  for (const auto& [name, value] : parse_canonical(parameters)) entries.push_back(name + " = " + quoted(value));
  return "{ " + joined(entries) + " }";
}

/// A study of one cell and one repetition.
std::string study_of(const Study& study, const PlannedInstance& instance, const PlannedRun& run) {
  const RunLimits& limits = study.limits;
  return "name = \"cell\"\nsummary = \"one cell\"\nfamilies = [{ name = " + quoted(instance.generator) +
         ", parameters = " + toml_table(instance.parameters) + " }]\nsizes = [" + std::to_string(instance.n) +
         "]\nseeds = [" + std::to_string(instance.seed) + "]\nalgorithms = [{ name = " + quoted(run.algorithm->name) +
         ", parameters = " + toml_table(run.parameters.canonical()) +
         " }]\nthreads = " + std::to_string(study.threads) + "\nmin_time_s = " + number_text(study.min_time_s) +
         "\n[limits]\ntime_s = " + number_text(limits.time_s) + "\ngrace_s = " + number_text(limits.grace_s) +
         "\nmemory_mb = " + std::to_string(std::max<std::uint64_t>(1, limits.memory_bytes >> 20)) +
         "\n[optimum]\nseek = false\n";
}

void require_algorithms(const Plan& plan, const Study& study, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const bool has_it = std::any_of(plan.runs.begin(), plan.runs.end(),
                                    [&](const PlannedRun& run) { return run.algorithm->name == name; });
    if (!has_it) throw InputError("study '" + study.name + "' has no algorithm '" + name + "'");
  }
}

/// Every cell of a family that is to be run, as a study file. Only cells of `algorithms`, unless that is empty.
std::vector<std::string> cells_of(const Study& study, const Catalogue& catalogue,
                                  const std::vector<std::string>& algorithms) {
  const Plan plan = make_plan(study, catalogue);
  require_algorithms(plan, study, algorithms);
  const auto is_wanted = [&](const std::string& name) {
    return algorithms.empty() || std::find(algorithms.begin(), algorithms.end(), name) != algorithms.end();
  };
  std::vector<std::string> cells;
  std::set<std::string> known;
  for (const PlannedRun& run : plan.runs) {
    const PlannedInstance& instance = plan.instances[run.instance];
    if (instance.generator == kFileGenerator || instance.n > run.largest_n || !is_wanted(run.algorithm->name)) continue;
    std::string cell = study_of(study, instance, run);
    if (known.insert(cell).second) cells.push_back(std::move(cell));
  }
  if (cells.empty()) throw InputError("study '" + study.name + "' has nothing to run on generated points");
  return cells;
}

std::string program_of(const std::string& build) {
  const fs::path path(build);
  const fs::path program = fs::is_directory(path) ? path / "mwt" : path;
  if (access(program.c_str(), X_OK) != 0) throw InputError(program.string() + ": no program is there; build it first");
  return fs::absolute(program).string();
}

/// One of the two builds: its program and the results that it has given so far.
class Side {
 public:
  Side(const std::string& build, const std::string& folder, const Study& study)
      : program_(program_of(build)), results_(folder, study, false), study_name_(study.name) {}

  void run(const std::string& study_file, const fs::path& scratch, int repetition) {
    const fs::path records = scratch / "records";
    const std::string log = (scratch / "log").string();
    fs::remove_all(records);
    const int code = run_program({program_, "run", study_file, "--out", records.string(), "--no-cache"}, log);
    if (InterruptWatch::requested()) return;
    // A run that failed is a row, too.
    const bool has_records = code == kExitOk || (code == kExitNegative && fs::exists(records / "runs.csv"));
    if (!has_records)
      throw InputError(program_ + ": exit code " + std::to_string(code) + ": " + end_of(read_file(log)));
    adopt(read_results(records.string()), repetition);
  }

 private:
  static std::string end_of(const std::string& text) {
    return one_line(text.substr(text.size() - std::min<std::size_t>(text.size(), 300)));
  }

  /// All runs get the environment of the first one: it is the same machine and program throughout.
  void adopt(ResultSet results, int repetition) {
    if (env_id_.empty() && !results.environments.empty()) {
      EnvironmentRecord environment = results.environments.front();
      environment.study = study_name_;
      env_id_ = environment.env_id;
      results_.append(environment);
    }
    for (RunRecord& run : results.runs) {
      run.study = study_name_;
      run.env_id = env_id_;
      run.repetition = repetition;
      run.run_id = short_hash(run.run_id + '\n' + std::to_string(repetition));
      results_.append(run);
    }
  }

  std::string program_;
  ResultsFolder results_;
  std::string study_name_;
  std::string env_id_;
};

/// A folder that is gone when this object is.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (fs::temp_directory_path() / "mwt_compare_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw InputError(pattern + ": cannot make this folder");
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void shuffle_cells(std::vector<std::string>& cells, RandomEngine& engine) {
  for (std::size_t i = cells.size(); i > 1; --i) std::swap(cells[i - 1], cells[uniform_below(engine, i)]);
}

}  // namespace

bool run_interleaved(const Study& study, const Catalogue& catalogue, const InterleavedOptions& options,
                     std::ostream& out) {
  std::vector<std::string> cells = cells_of(study, catalogue, options.algorithms);
  Side base(options.build_a, (fs::path(options.folder) / "base").string(), study);
  Side now(options.build_b, (fs::path(options.folder) / "new").string(), study);
  const ScratchFolder scratch;
  const std::string study_file = (scratch.path() / "cell.toml").string();
  const InterruptWatch watch;
  Progress progress(out, options.is_terminal, "pairs", cells.size() * static_cast<std::size_t>(options.repetitions));
  RandomEngine engine = make_engine("interleaved_builds", options.seed);
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    shuffle_cells(cells, engine);
    for (const std::string& cell : cells) {
      if (InterruptWatch::requested()) break;
      write_file_atomically(study_file, cell);
      const bool base_first = uniform_below(engine, 2) == 0;
      (base_first ? base : now).run(study_file, scratch.path(), repetition);
      (base_first ? now : base).run(study_file, scratch.path(), repetition);
      progress.advance(false, "repetition " + std::to_string(repetition + 1));
    }
  }
  progress.finish();
  return !InterruptWatch::requested();
}

}  // namespace mwt
