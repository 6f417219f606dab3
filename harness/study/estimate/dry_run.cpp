#include "harness/study/estimate/dry_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"
#include "harness/rating/optimum_search.h"
#include "harness/records/environment.h"
#include "harness/study/estimate/estimate.h"
#include "harness/study/estimate/observed_times.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxListed = 8;

template <class Number>
std::string listed(const std::set<Number>& numbers) {
  if (numbers.size() > kMaxListed) {
    return fmt::format("{} .. {} ({} of them)", *numbers.begin(), *numbers.rbegin(), numbers.size());
  }
  std::vector<std::string> texts;
  for (const Number number : numbers) texts.push_back(std::to_string(number));
  return joined(texts, " ");
}

std::string family_table(const Plan& plan) {
  struct Row {
    std::string name;
    std::set<Index> sizes;
    std::set<std::uint64_t> seeds;
    std::size_t instances = 0;
  };
  std::vector<Row> rows;
  for (const PlannedInstance& instance : plan.instances) {
    const bool is_file = instance.generator == kFileGenerator;  // every one has a name of its own
    const std::string name = name_with_parameters(instance.generator, is_file ? "" : instance.parameters);
    if (rows.empty() || rows.back().name != name) rows.push_back({name, {}, {}});
    rows.back().sizes.insert(instance.n);
    rows.back().seeds.insert(instance.seed);
    ++rows.back().instances;
  }
  AlignedTable table({"family", "instances", "n", "seeds"}, {2, 3});
  for (const Row& row : rows) {
    table.add_row({row.name, std::to_string(row.instances), listed(row.sizes), listed(row.seeds)});
  }
  return table.text("  ");
}

std::string largest_n_text(Index n) { return n == std::numeric_limits<Index>::max() ? "any" : std::to_string(n); }

std::string algorithm_table(const Plan& plan) {
  struct Row {
    std::size_t runs = 0;
    std::size_t beyond = 0;
    Index max_n = 0;
  };
  std::map<std::string, Row> rows;
  for (const PlannedRun& run : plan.runs) {
    Row& row = rows[name_with_parameters(run.algorithm->name, run.parameters.canonical())];
    ++(is_within_reach(run, plan) ? row.runs : row.beyond);
    row.max_n = run.max_n;
  }
  AlignedTable table({"algorithm", "runs", "largest n", "not started beyond it"});
  for (const auto& [name, row] : rows) {
    table.add_row({name, std::to_string(row.runs), largest_n_text(row.max_n), std::to_string(row.beyond)});
  }
  return table.text("  ");
}

std::string limits_text(const RunLimits& limits) {
  return fmt::format("{}, {} MB", readable_duration(limits.time_s), limits.memory_bytes >> 20);
}

std::string optimum_text(const Study& study) {
  if (!study.seeks_optimum) return "not sought";
  std::vector<std::string> names;
  for (const OptimumSource& source : study.optimum_sources) names.push_back(source.algorithm);
  return fmt::format("sought by {}; each {}; what the optimum cache has is not sought",
                     names.empty() ? "every exact algorithm that takes the instance" : joined(names),
                     limits_text(study.optimum_limits));
}

std::string basis_text(TimeBasis basis) {
  switch (basis) {
    case TimeBasis::recorded: return "in cells that were recorded on this machine";
    case TimeBasis::measured: return "in cells that were measured just now";
    case TimeBasis::other_sizes: return "extrapolated from other sizes of the family";
    case TimeBasis::other_families: return "as on other families";
    case TimeBasis::other_variants: return "as with other parameters";
    case TimeBasis::nothing: return "without any observation, at their limits";
  }
  return "";
}

std::string estimate_text(const DurationEstimate& estimate) {
  std::string text = fmt::format("about {}, probably between {} and {}; with every run and search at its limit {}\n",
                                 readable_duration(estimate.likely), readable_duration(estimate.low),
                                 readable_duration(estimate.high), readable_duration(estimate.most));
  AlignedTable table({"of that", "runs", ""}, {2});
  for (const auto& [basis, part] : estimate.runs) {
    table.add_row({readable_duration(part.seconds), std::to_string(part.count), basis_text(basis)});
  }
  if (estimate.searches.count > 0) {
    table.add_row({readable_duration(estimate.searches.seconds), std::to_string(estimate.searches.count),
                   "searches for optima, unless the cache has them"});
  }
  return text + table.text("  ");
}

DurationEstimate estimate(const Study& study, const Catalogue& catalogue, const Plan& plan, const RunOptions& options,
                          std::ostream& out) {
  const EnvironmentRecord here = describe_environment(study.name, 1, "");
  const std::vector<PlannedWork> work = planned_work(study, catalogue, plan);
  const ObservedTimes times = observe_times(study, plan, work, options.folder, here);
  out << times.text() << '\n';
  for (const std::string& warning : timing_warnings(here)) out << "warning: " << warning << '\n';
  return estimate_duration(study, plan, work, times.model);
}

/// At most: which runs can be counted is seen when they have ended.
std::size_t runs_to_be_counted(const Study& study, const Plan& plan) {
  return static_cast<std::size_t>(std::ranges::count_if(plan.runs, [&](const PlannedRun& run) {
    const Index n = plan.instances[run.instance].n;
    return n <= study.max_counted_n && n <= run.max_n && run.repetition < kCountedRepetitions;
  }));
}

}  // namespace

void dry_run(const Study& study, const Catalogue& catalogue, const RunOptions& options, std::ostream& out) {
  static_cast<void>(optimum_sources_for(catalogue, study.optimum_sources, kNoIndex));  // are they known and exact?
  const Plan plan = part_of(make_plan(study, catalogue), options.shard);
  const std::string shard = options.shard.text();
  out << "study " << study.name << (shard.empty() ? "" : ", shard " + shard) << ": " << study.summary << '\n'
      << plan.instances.size() << " instances, " << plan.runs.size() << " runs (" << study.repetitions
      << " per algorithm and instance)\n\n"
      << family_table(plan) << '\n'
      << algorithm_table(plan) << '\n'
      << "a run's limits: " << limits_text(study.limits) << '\n'
      << "optimum: " << optimum_text(study) << '\n';
  for (const std::string& note : plan.notes) out << "note: " << note << '\n';
  out << std::flush;
  const DurationEstimate duration = estimate(study, catalogue, plan, options, out);
  out << "time on an idle machine, one run at a time: " << estimate_text(duration);
  if (const std::size_t counted_runs = runs_to_be_counted(study, plan); counted_runs > 0)
    out << "not in it: " << counted(counted_runs, "run") << " under callgrind, each 1 s and 50 to 100 times its time\n";
  out << "nothing was recorded\n";
}

}  // namespace mwt
