#include "harness/study/plan.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "geometry/error.h"
#include "geometry/point_file.h"
#include "geometry/point_set.h"
#include "harness/start_triangulation.h"
#include "harness/text.h"

namespace mwt {

namespace {

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

// A family with its parameters and a seed, before n is known.
struct Source {
  const GeneratorInfo& family;
  const Parameters& parameters;
  std::uint64_t seed;
};

// The nearest n of which the family has an instance, the smaller one of two; 0 if there is none near.
Index nearest_legal_n(const Source& source, Index wanted, std::string& complaint) {
  const Index reach = std::max<Index>(5, wanted / 8);
  for (Index distance = 0; distance <= reach; ++distance) {
    for (const std::int64_t n : {std::int64_t{wanted} - distance, std::int64_t{wanted} + distance}) {
      if (n < 1) continue;
      try {
        const auto points = generate_points(source.family, static_cast<Index>(n), source.seed, source.parameters);
        static_cast<void>(make_point_set(points, source.family.name));
        return static_cast<Index>(n);
      } catch (const InputError& error) {
        complaint = error.what();
      }
    }
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
  void add_algorithm(const AlgorithmChoice& choice) {
    const AlgorithmInfo& info = catalogue_.algorithm(choice.name);
    PlannedRun run;
    run.algorithm = &info;
    run.parameters = Parameters(info.name, info.parameters, choice.parameters);
    run.largest_n = largest_n_for(info, choice.largest_n);
    if (start_file_of(info, run.parameters)) {
      throw InputError(info.name + ": a study cannot start from a given triangulation; choose one of the named starts");
    }
    algorithms_.push_back(std::move(run));
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
    std::string complaint = "no instance near that size";
    const Index n = nearest_legal_n(source, wanted, complaint);
    const std::string& family = source.family.name;
    if (n == 0) plan_.notes.push_back("left out: " + family + " n=" + std::to_string(wanted) + ": " + complaint);
    if (n != 0 && n != wanted) {
      plan_.notes.push_back(family + " has no n=" + std::to_string(wanted) + "; taken: n=" + std::to_string(n));
    }
    return n;
  }

  void add_files() {
    for (const std::string& name : matching_files(study_.instance_files)) {
      const std::string path = (std::filesystem::path(study_.instance_files.folder) / name).string();
      try {
        const std::vector<Point> points = read_points(path);
        static_cast<void>(make_point_set(points, path));
        add_instance({kFileGenerator, "file=" + name, static_cast<Index>(points.size()), study_.seeds.front(),
                      [path] { return read_points(path); }});
      } catch (const InputError& error) {
        plan_.notes.push_back(std::string("left out: ") + error.what());
      }
    }
  }

  void add_instance(const PlannedInstance& instance) {
    const std::string key = joined({study_.name, instance.generator, instance.parameters, std::to_string(instance.n),
                                    std::to_string(instance.seed)},
                                   "\n");
    if (!known_instances_.insert(key).second) return;
    plan_.instances.push_back(instance);
    for (int repetition = 0; repetition < study_.repetitions; ++repetition) add_repetition(key, repetition);
  }

  // The algorithms in a random order, so that none always profits from what ran before it: that of the runs' hashes.
  void add_repetition(const std::string& instance_key, int repetition) {
    const std::size_t begin = plan_.runs.size();
    for (PlannedRun run : algorithms_) {
      run.instance = plan_.instances.size() - 1;
      run.repetition = repetition;
      run.run_id = short_hash(
          joined({instance_key, run.algorithm->name, run.parameters.canonical(), std::to_string(repetition)}, "\n"));
      if (known_runs_.insert(run.run_id).second) plan_.runs.push_back(std::move(run));
    }
    std::sort(plan_.runs.begin() + static_cast<std::ptrdiff_t>(begin), plan_.runs.end(),
              [](const PlannedRun& a, const PlannedRun& b) { return a.run_id < b.run_id; });
  }

  const Study& study_;
  const Catalogue& catalogue_;
  Plan plan_;
  std::vector<PlannedRun> algorithms_;  // templates: instance, repetition and id still open
  std::set<std::string> known_instances_;
  std::set<std::string> known_runs_;
};

}  // namespace

std::string PlannedInstance::label() const {
  return generator + (parameters.empty() ? "" : " " + parameters) + " n=" + std::to_string(n) +
         " seed=" + std::to_string(seed);
}

Index largest_n_for(const AlgorithmInfo& algorithm, const std::optional<Index>& of_study) {
  const Index own = algorithm.largest_n == 0 ? kNoIndex : algorithm.largest_n;
  return std::min(own, of_study.value_or(kNoIndex));
}

Plan make_plan(const Study& study, const Catalogue& catalogue) {
  Plan plan = Planner(study, catalogue).make();
  if (plan.runs.empty()) throw InputError("study '" + study.name + "' has nothing to run");
  return plan;
}

}  // namespace mwt
