#include "harness/tracking/comparison/interleaved_builds.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "generators/random.h"
#include "harness/io/exit_code.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/progress.h"
#include "harness/io/temporary_folder.h"
#include "harness/io/text/text.h"
#include "harness/records/profile_folder.h"
#include "harness/records/results_folder.h"
#include "harness/run/interrupt.h"
#include "harness/study/plan.h"
#include "harness/tracking/comparison/run_program.h"
#include "harness/tracking/result_set.h"

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

/// A pattern that this name alone matches.
std::string pattern_of(const std::string& name) {
  std::string pattern;
  for (const char c : name)
    pattern += std::string("*?[").find(c) == std::string::npos ? std::string(1, c) : std::string("[") + c + ']';
  return pattern;
}

/// "a=1 b=x" as a TOML table: { a = "1", b = "x" }. A start that is a file gets its whole path.
std::string toml_table(const std::string& parameters, const std::optional<std::string>& start_file = {}) {
  std::vector<std::string> entries;
  for (const auto& [name, value] : parse_canonical(parameters)) {
    const bool is_start = start_file && name == "start";
    entries.push_back(name + " = " + quoted(is_start ? fs::absolute(*start_file).string() : value));
  }
  return "{ " + joined(entries) + " }";
}

/// Where the points come from: a family, or one file.
std::string source_of(const Study& study, const PlannedInstance& instance) {
  if (instance.generator == kFileGenerator) {
    const std::string name = instance.parameters.substr(std::string("file=").size());
    return fmt::format("[instances]\nfolder = {}\nfiles = [{}]\n",
                       quoted(fs::absolute(study.instance_files.folder).string()), quoted(pattern_of(name)));
  }
  return fmt::format("[[families]]\nname = {}\nparameters = {}\nsizes = [{}]\n", quoted(instance.generator),
                     toml_table(instance.parameters), instance.n);
}

/// In front of a study of one cell.
constexpr const char* kCounts = "counts = {{ tool = \"callgrind\", max_n = {} }}\n";

/// A study of one cell and one repetition.
std::string study_of(const Study& study, const PlannedInstance& instance, const PlannedRun& run) {
  const RunLimits& limits = study.limits;
  return fmt::format(
      "name = \"cell\"\nsummary = \"one cell\"\nseeds = [{}]\nalgorithms = [{{ name = {}, parameters = {} }}]\nthreads "
      "= {}\nmin_time_s = {}\n[limits]\ntime_s = {}\ngrace_s = {}\nmemory_mb = {}\n[optimum]\nseek = false\n{}",
      instance.seed, quoted(run.algorithm->name), toml_table(run.parameters.canonical(), run.start_file), study.threads,
      number_text(study.min_time_s), number_text(limits.time_s), number_text(limits.grace_s),
      std::max<std::uint64_t>(1, limits.memory_bytes >> 20), source_of(study, instance));
}

void require_algorithms(const Plan& plan, const Study& study, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const bool has_it = std::any_of(plan.runs.begin(), plan.runs.end(),
                                    [&](const PlannedRun& run) { return run.algorithm->name == name; });
    if (!has_it) throw InputError(fmt::format("study '{}' has no algorithm '{}'", study.name, name));
  }
}

TrackedCell cell_of(const Study& study, const PlannedInstance& instance, const PlannedRun& run) {
  return {run.algorithm->name, run.parameters.canonical(),
          instance.generator,  instance.parameters,
          instance.n,          instance.seed,
          study.threads};
}

/// A study file for every cell that is to be run. Only cells of `algorithms`, unless that is empty.
std::map<TrackedCell, std::string> studies_of_cells(const Study& study, const Catalogue& catalogue,
                                                    const std::vector<std::string>& algorithms) {
  const Plan plan = make_plan(study, catalogue);
  require_algorithms(plan, study, algorithms);
  const auto is_wanted = [&](const std::string& name) {
    return algorithms.empty() || std::find(algorithms.begin(), algorithms.end(), name) != algorithms.end();
  };
  std::map<TrackedCell, std::string> cells;
  for (const PlannedRun& run : plan.runs) {
    const PlannedInstance& instance = plan.instances[run.instance];
    if (instance.n > run.max_n || !is_wanted(run.algorithm->name)) continue;
    cells.try_emplace(cell_of(study, instance, run), study_of(study, instance, run));
  }
  if (cells.empty()) throw InputError("study '" + study.name + "' has nothing to run");
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
      : program_(program_of(build)), results_(folder, study.name, study.file_content, false), study_name_(study.name) {}

  void run(const TrackedCell& cell, const std::string& study_file, const fs::path& scratch, int repetition) {
    const fs::path records = scratch / "records";
    const std::string log = (scratch / "log").string();
    fs::remove_all(records);
    const int code = run_program({program_, "run", study_file, "--out", records.string(), "--no-cache"}, log);
    if (InterruptWatch::requested()) return;
    // A failed run is a row, whatever the program's exit code.
    const bool has_records = code == kExitOk || (code == kExitNegative && fs::exists(records / "runs.csv"));
    if (!has_records) throw InputError(fmt::format("{}: exit code {}: {}", program_, code, end_of(read_file(log))));
    adopt(cell, read_results(records.string()), repetition);
  }

 private:
  static std::string end_of(const std::string& text) {
    return one_line(text.substr(text.size() - std::min<std::size_t>(text.size(), 300)));
  }

  /// All runs get the environment of the first one: it is the same machine and program throughout.
  void adopt(const TrackedCell& cell, ResultSet results, int repetition) {
    if (env_id_.empty() && !results.environments.empty()) {
      EnvironmentRecord environment = results.environments.front();
      environment.study = study_name_;
      env_id_ = environment.env_id;
      results_.append(environment);
    }
    for (RunRecord& run : results.runs) {
      run.schema_version = kSchemaVersion;
      run.study = study_name_;
      run.env_id = env_id_;
      run.params = cell.params;  // without the path of a start
      run.repetition = repetition;
      const FunctionCounts functions = read_profile(results.folder, run.run_id);
      run.run_id = short_hash(fmt::format("{}\n{}", run.run_id, repetition));
      if (!functions.empty()) {
        prepare_profile_folder(results_.path());
        write_profile(results_.path(), run.run_id, functions);
      }
      results_.append(run);
    }
  }

  std::string program_;
  ResultsFolder results_;
  std::string study_name_;
  std::string env_id_;
};

template <class Item>
void shuffle(std::vector<Item>& items, RandomEngine& engine) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[uniform_below(engine, i)]);
}

}  // namespace

struct InterleavedBuilds::Sides {
  Sides(const Study& study, const InterleavedOptions& options, const std::string& base_folder,
        const std::string& new_folder)
      : base(options.build_a, base_folder, study),
        now(options.build_b, new_folder, study),
        max_counted_n(options.with_counts ? study.max_counted_n : 0),
        engine(make_engine("interleaved_builds", options.seed)) {}

  void run(const TrackedCell& cell, const std::string& study) {
    const std::string study_file = (scratch.path() / "cell.toml").string();
    const bool counts = cell.n <= max_counted_n && repetition < kCountedRepetitions;
    write_file_atomically(study_file, (counts ? fmt::format(kCounts, cell.n) : "") + study);
    const bool base_first = uniform_below(engine, 2) == 0;
    for (Side* side : {base_first ? &base : &now, base_first ? &now : &base})
      side->run(cell, study_file, scratch.path(), repetition);
  }

  Side base;
  Side now;
  std::size_t max_counted_n;
  TemporaryFolder scratch{"mwt-compare"};
  RandomEngine engine;
  int repetition = 0;
};

InterleavedBuilds::InterleavedBuilds(const Study& study, const Catalogue& catalogue, const InterleavedOptions& options,
                                     std::ostream& out)
    : studies_(studies_of_cells(study, catalogue, options.algorithms)),
      options_(options),
      out_(out),
      sides_(std::make_unique<Sides>(study, options, base_folder(), new_folder())) {}

InterleavedBuilds::~InterleavedBuilds() = default;

std::string InterleavedBuilds::base_folder() const { return (fs::path(options_.folder) / "base").string(); }

std::string InterleavedBuilds::new_folder() const { return (fs::path(options_.folder) / "new").string(); }

std::set<TrackedCell> InterleavedBuilds::cells() const {
  std::set<TrackedCell> cells;
  for (const auto& [cell, study] : studies_) cells.insert(cell);
  return cells;
}

bool InterleavedBuilds::is_out_of_time() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  return options_.budget_s && elapsed.count() >= *options_.budget_s;
}

int InterleavedBuilds::repetitions() const { return sides_->repetition; }

bool InterleavedBuilds::run(const std::set<TrackedCell>& chosen, int repetitions) {
  std::vector<TrackedCell> order(chosen.begin(), chosen.end());
  const InterruptWatch watch;
  Progress progress(out_, options_.is_terminal, "pairs", order.size() * static_cast<std::size_t>(repetitions));
  for (const int end = sides_->repetition + repetitions; sides_->repetition < end; ++sides_->repetition) {
    shuffle(order, sides_->engine);
    for (const TrackedCell& cell : order) {
      if (InterruptWatch::requested()) break;
      sides_->run(cell, studies_.at(cell));
      progress.advance(false, fmt::format("repetition {}", sides_->repetition + 1));
    }
    if (is_out_of_time()) {
      ++sides_->repetition;
      break;
    }
  }
  progress.finish();
  return !InterruptWatch::requested();
}

}  // namespace mwt
