#include "harness/study/plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "base/error.h"
#include "generators/generation.h"
#include "geometry/point_set.h"
#include "harness/io/points/point_file.h"
#include "harness/io/text/text.h"
#include "harness/run/start_triangulation.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxRuns = 2000000;  // which take about a gigabyte while they are planned

// Runs `look_up`; its complaints get the place in the study file that they are about.
template <class LookUp>
auto at_place(const std::string& place, LookUp look_up) {
  try {
    return look_up();
  } catch (const InputError& error) {
    throw InputError(place + ": " + error.what());
  }
}

template <class Choice, class Entry>
std::vector<Choice> without_wildcard(const std::vector<Choice>& choices, std::span<const Entry> entries) {
  const auto is_named = [&](const std::string& name) {
    return std::any_of(choices.begin(), choices.end(), [&](const Choice& choice) { return choice.name == name; });
  };
  std::vector<Choice> expanded;
  for (const Choice& choice : choices) {
    if (choice.name != "*") {
      expanded.push_back(choice);
      continue;
    }
    for (const Entry& entry : entries) {
      if (is_named(entry.name)) continue;
      expanded.push_back(choice);
      expanded.back().name = entry.name;
    }
  }
  return expanded;
}

// A family with its parameters and a seed, without n.
struct Source {
  const GeneratorInfo& family;
  const Parameters& parameters;
  std::uint64_t seed;
};

// Whether the family has an instance of n points. A family that fails has one, so that its runs report the failure.
// Throws NotEnoughMemory.
bool has_instance(const Source& source, Index n, std::string& complaint) {
  try {
    const auto points = generate_points(source.family, n, source.seed, source.parameters);
    static_cast<void>(make_point_set(points, source.family.name));
    return true;
  } catch (const NotEnoughMemory&) {
    throw;
  } catch (const InputError& error) {
    complaint = error.what();
    return false;
  } catch (const GeneratorFailure&) {
    return true;
  }
}

// The nearest n of which the family has an instance, the smaller one of two; 0 if there is none near. `complaint` is
// the error message of the family for `wanted` itself.
Index nearest_legal_n(const Source& source, Index wanted, std::string& complaint) {
  if (has_instance(source, wanted, complaint)) return wanted;
  std::string ignored;
  const Index reach = std::max<Index>(5, wanted / 8);
  for (Index distance = 1; distance <= reach; ++distance) {
    const bool has_smaller = wanted > distance && has_instance(source, wanted - distance, ignored);
    if (has_smaller) return wanted - distance;
    const bool has_larger = wanted < kNoIndex - distance && has_instance(source, wanted + distance, ignored);
    if (has_larger) return wanted + distance;
  }
  return 0;
}

class Planner {
 public:
  Planner(const Study& study, const Catalogue& catalogue) : study_(study), catalogue_(catalogue) {}

  Plan make() {
    for (const AlgorithmChoice& choice : without_wildcard(study_.algorithms, catalogue_.algorithms())) {
      at_place(choice.place, [&] { add_algorithm(choice); });
    }
    for (const FamilyChoice& choice : without_wildcard(study_.families, catalogue_.generators())) {
      at_place(choice.place, [&] { add_family(choice); });
    }
    if (!study_.instance_files.patterns.empty()) add_files();
    return std::move(plan_);
  }

 private:
  struct AlgorithmTemplate {
    PlannedRun run;  // instance, repetition and id still open
    std::vector<std::string> families;
    std::string content_hash;  // of the file to start from, or of a command

    [[nodiscard]] bool takes(const std::string& family) const {
      return families.empty() || std::find(families.begin(), families.end(), family) != families.end();
    }
  };

  void add_algorithm(const AlgorithmChoice& choice) {
    const AlgorithmInfo& info = algorithm_named(choice.name, study_.commands, catalogue_);
    for (const std::string& family : choice.families) static_cast<void>(catalogue_.generator(family));
    PlannedRun run;
    run.algorithm = &info;
    run.parameters = Parameters(info.name, info.parameters, choice.parameters);
    run.max_n = max_n_for(info, choice.max_n);
    if (const auto file = start_file_of(info, run.parameters)) {
      run.start_file = (std::filesystem::path(study_.folder) / *file).string();
    }
    std::string content_hash = run.start_file ? sha256_of_file(*run.start_file) : "";
    for (const StudyCommand& command : study_.commands) {
      if (&command.info == &info) content_hash = command.content_hash;
    }
    algorithms_.push_back({std::move(run), choice.families, std::move(content_hash)});
  }

  void add_family(const FamilyChoice& choice) {
    const GeneratorInfo& family = catalogue_.generator(choice.name);
    const Parameters parameters(family.name, family.parameters, choice.parameters);
    std::vector<Index> sizes = choice.sizes.empty() ? study_.sizes : choice.sizes;
    if (family.fixed_n != 0) sizes = {family.fixed_n};
    if (sizes.empty()) throw InputError("no sizes for '" + family.name + "'; give the study or the family 'sizes'");
    std::vector<std::uint64_t> seeds = choice.seeds.empty() ? study_.seeds : choice.seeds;
    if (!family.seeded) seeds.resize(1);
    for (const Index size : sizes) {
      const Index n = legal_n({family, parameters, seeds.front()}, size);
      if (n == 0) continue;
      for (const std::uint64_t seed : seeds) {
        add_instance({family.name, parameters.canonical(), n, seed,
                      [&family, parameters, n, seed] { return generate_points(family, n, seed, parameters); }});
      }
    }
  }

  Index legal_n(const Source& source, Index wanted) {
    std::string complaint;
    const Index n = nearest_legal_n(source, wanted, complaint);
    const std::string family = name_with_parameters(source.family.name, source.parameters.canonical());
    if (n == 0) plan_.notes.push_back(fmt::format("left out: {} n={}: {}", family, wanted, complaint));
    if (n != 0 && n != wanted) {
      plan_.notes.push_back(fmt::format("{} has no n={}; taken: n={}", family, wanted, n));
    }
    return n;
  }

  void add_files() {
    for (const std::string& name : matching_files(study_.instance_files)) {
      const std::string path = (std::filesystem::path(study_.instance_files.folder) / name).string();
      try {
        const std::vector<Point> points = read_points(path);
        const std::string id = instance_id(make_point_set(points, path).points);
        add_instance({kFileGenerator, canonical_parameter("file", name), static_cast<Index>(points.size()),
                      study_.seeds.front(), [path] { return read_points(path); }, id});
      } catch (const InputError& error) {
        plan_.notes.push_back(std::string("left out: ") + error.what());
      }
    }
  }

  void add_instance(const PlannedInstance& instance) {
    std::string key = joined({study_.name, instance.generator, instance.parameters, std::to_string(instance.n),
                              std::to_string(instance.seed)},
                             "\n");
    if (!instance.file_instance_id.empty()) key += '\n' + instance.file_instance_id;
    if (!known_instances_.insert(key).second) return;
    const auto algorithms =
        static_cast<std::size_t>(std::count_if(algorithms_.begin(), algorithms_.end(), [&](const auto& algorithm) {
          return algorithm.takes(instance.generator);
        }));
    if (plan_.runs.size() + algorithms * static_cast<std::size_t>(study_.repetitions) > kMaxRuns) {
      throw InputError(
          fmt::format("study '{}' has more than {} runs; divide it into several studies", study_.name, kMaxRuns));
    }
    plan_.instances.push_back(instance);
    for (int repetition = 0; repetition < study_.repetitions; ++repetition) add_repetition(key, repetition);
  }

  // The algorithms in a random order, so that none always profits from what ran before it: that of the runs' hashes.
  void add_repetition(const std::string& instance_key, int repetition) {
    const std::size_t begin = plan_.runs.size();
    const std::string& family = plan_.instances.back().generator;
    for (const AlgorithmTemplate& algorithm : algorithms_) {
      if (!algorithm.takes(family)) continue;
      PlannedRun run = algorithm.run;
      run.instance = plan_.instances.size() - 1;
      run.repetition = repetition;
      std::string run_key =
          joined({instance_key, run.algorithm->name, run.parameters.canonical(), std::to_string(repetition)}, "\n");
      if (!algorithm.content_hash.empty()) run_key += '\n' + algorithm.content_hash;
      run.run_id = short_hash(run_key);
      if (known_runs_.insert(run.run_id).second) plan_.runs.push_back(std::move(run));
    }
    std::sort(plan_.runs.begin() + static_cast<std::ptrdiff_t>(begin), plan_.runs.end(),
              [](const PlannedRun& a, const PlannedRun& b) { return a.run_id < b.run_id; });
  }

  const Study& study_;
  const Catalogue& catalogue_;
  Plan plan_;
  std::vector<AlgorithmTemplate> algorithms_;
  std::set<std::string> known_instances_;
  std::set<std::string> known_runs_;
};

}  // namespace

std::string PlannedInstance::label() const {
  return fmt::format("{} n={} seed={}", name_with_parameters(generator, parameters), n, seed);
}

std::set<std::string> run_ids_of(const Plan& plan) {
  std::set<std::string> ids;
  for (const PlannedRun& run : plan.runs) ids.insert(run.run_id);
  return ids;
}

Plan make_plan(const Study& study, const Catalogue& catalogue) {
  Plan plan = Planner(study, catalogue).make();
  if (plan.runs.empty()) throw InputError("study '" + study.name + "' has nothing to run");
  return plan;
}

}  // namespace mwt
