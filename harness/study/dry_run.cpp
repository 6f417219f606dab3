#include "harness/study/dry_run.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "harness/aligned_table.h"
#include "harness/study/estimate.h"
#include "harness/study/optimum_search.h"
#include "harness/text.h"

namespace mwt {

namespace {

constexpr std::size_t kMostListed = 8;

template <class Number>
std::string listed(const std::set<Number>& numbers) {
  if (numbers.size() > kMostListed) {
    return std::to_string(*numbers.begin()) + " .. " + std::to_string(*numbers.rbegin()) + " (" +
           std::to_string(numbers.size()) + " of them)";
  }
  std::vector<std::string> texts;
  for (const Number number : numbers) texts.push_back(std::to_string(number));
  return joined(texts, " ");
}

std::string with_parameters(const std::string& name, const std::string& parameters) {
  return parameters.empty() ? name : joined({name, parameters}, " ");
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
    const std::string name = with_parameters(instance.generator, is_file ? "" : instance.parameters);
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

std::string algorithm_table(const Plan& plan) {
  struct Row {
    std::size_t runs = 0;
    std::size_t beyond = 0;
    Index largest_n = 0;
  };
  std::map<std::string, Row> rows;
  for (const PlannedRun& run : plan.runs) {
    Row& row = rows[with_parameters(run.algorithm->name, run.parameters.canonical())];
    ++(is_within_reach(run, plan) ? row.runs : row.beyond);
    row.largest_n = run.largest_n;
  }
  AlignedTable table({"algorithm", "runs", "largest n", "not started beyond it"});
  for (const auto& [name, row] : rows) {
    table.add_row({name, std::to_string(row.runs), std::to_string(row.largest_n), std::to_string(row.beyond)});
  }
  return table.text("  ");
}

std::string limits_text(const RunLimits& limits) {
  return readable_duration(limits.time_s) + ", " + std::to_string(limits.memory_bytes >> 20) + " MB";
}

std::string optimum_text(const Study& study) {
  if (!study.seeks_optimum) return "not sought";
  std::vector<std::string> names;
  for (const OptimumSource& source : study.optimum_sources) names.push_back(source.algorithm);
  return "sought by " + (names.empty() ? "every exact algorithm that takes the instance" : joined(names)) + "; each " +
         limits_text(study.optimum_limits) + "; what the optimum cache has is not sought";
}

StudyRecords earlier_records(const std::string& folder) {
  const bool has_any = std::filesystem::exists(std::filesystem::path(folder) / "runs.csv");
  return has_any ? read_records(folder) : StudyRecords{};
}

std::string estimate_text(const DurationEstimate& estimate, const Plan& plan, const std::string& folder) {
  const std::string bounds = "between " + readable_duration(estimate.least) + " and " +
                             readable_duration(estimate.most) + " (every run and search at its limit)";
  if (estimate.likely == 0) return bounds + "; a run recorded in " + folder + " would tell more";
  const std::string unknown =
      estimate.known < plan.runs.size()
          ? ", without " + std::to_string(plan.runs.size() - estimate.known) + " runs unknown there"
          : "";
  return "about " + readable_duration(estimate.likely) + " as recorded in " + folder + unknown + "; " + bounds;
}

}  // namespace

void dry_run(const Study& study, const Catalogue& catalogue, const RunOptions& options, std::ostream& out) {
  static_cast<void>(optimum_sources_for(catalogue, study.optimum_sources, kNoIndex));  // are they known and exact?
  const Plan plan = part_of(make_plan(study, catalogue), options.shard);
  const StudyRecords records = earlier_records(options.folder);
  const std::string shard = options.shard.text();
  out << "study " << study.name << (shard.empty() ? "" : ", shard " + shard) << ": " << study.summary << '\n'
      << plan.instances.size() << " instances, " << plan.runs.size() << " runs (" << study.repetitions
      << " per algorithm and instance)\n\n"
      << family_table(plan) << '\n'
      << algorithm_table(plan) << '\n'
      << "a run's limits: " << limits_text(study.limits) << '\n'
      << "optimum: " << optimum_text(study) << '\n';
  for (const std::string& note : plan.notes) out << "note: " << note << '\n';
  out << "time, one run at a time: "
      << estimate_text(estimate_duration(study, catalogue, plan, records), plan, options.folder)
      << "\nnothing was run\n";
}

}  // namespace mwt
