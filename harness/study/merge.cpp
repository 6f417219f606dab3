#include "harness/study/merge.h"

#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "geometry/error.h"
#include "harness/study/known_optima.h"
#include "harness/study/plan.h"
#include "harness/study/results_folder.h"
#include "harness/text.h"

namespace mwt {

namespace {

struct Part {
  std::string folder;
  StudyRecords records;
};

std::string label_of(const RunRecord& run) {
  return run.algorithm + (run.params.empty() ? "" : " " + run.params) + " on " + run.generator +
         " n=" + std::to_string(run.n) + " seed=" + std::to_string(run.seed) +
         " repetition=" + std::to_string(run.repetition);
}

std::string label_of(const PlannedRun& run, const Plan& plan) {
  const std::string parameters = run.parameters.canonical();
  return run.algorithm->name + (parameters.empty() ? "" : " " + parameters) + " on " +
         plan.instances[run.instance].label() + " repetition=" + std::to_string(run.repetition);
}

// A study that still runs would look like a gap: its lock shows that it runs.
std::vector<Part> read_parts(const MergeOptions& options) {
  std::vector<Part> parts;
  for (const std::string& folder : options.folders) {
    if (std::filesystem::exists(folder)) const FolderLock lock(folder);
    parts.push_back({folder, read_records(folder)});
  }
  return parts;
}

void require_one_study(const std::vector<Part>& parts) {
  const Part& first = parts.front();
  for (const Part& part : parts) {
    if (part.records.study_file == first.records.study_file) continue;
    throw InputError(first.folder + " and " + part.folder + " are of different studies: their study.toml differ");
  }
}

void require_one_commit(const std::vector<Part>& parts) {
  std::map<std::string, std::string> folder_of_commit;
  for (const Part& part : parts) {
    for (const RunRecord& run : part.records.runs) folder_of_commit.try_emplace(run.git_commit, part.folder);
  }
  if (folder_of_commit.size() < 2) return;
  const auto& [one, one_folder] = *folder_of_commit.begin();
  const auto& [other, other_folder] = *folder_of_commit.rbegin();
  throw InputError(one_folder + " and " + other_folder + " were recorded by different builds of mwt (commits " + one +
                   " and " + other + "); run one again, or mix the two with --accept-other-build");
}

class Merger {
 public:
  Merger(const std::vector<Part>& parts, Plan plan) : parts_(parts), plan_(std::move(plan)) {}

  StudyRecords merge() {
    StudyRecords merged;
    merged.study_file = parts_.front().records.study_file;
    collect_runs();
    require_all_runs();
    for (const PlannedRun& run : plan_.runs) merged.runs.push_back(*runs_.at(run.run_id).first);
    merged.instances = instances_in_order();
    for (const Part& part : parts_) {
      merged.environments.insert(merged.environments.end(), part.records.environments.begin(),
                                 part.records.environments.end());
    }
    return merged;
  }

 private:
  void collect_runs() {
    std::set<std::string> planned;
    for (const PlannedRun& run : plan_.runs) planned.insert(run.run_id);
    for (const Part& part : parts_) {
      for (const RunRecord& run : part.records.runs) {
        if (!planned.contains(run.run_id)) {
          throw InputError(part.folder + ": this mwt does not plan its run " + label_of(run) +
                           "; merge with the commit that recorded it: " + run.git_commit);
        }
        const auto [entry, is_new] = runs_.try_emplace(run.run_id, &run, part.folder);
        if (is_new) continue;
        throw InputError(entry->second.second + " and " + part.folder + " overlap: both have " + label_of(run) +
                         "; name every shard once");
      }
    }
  }

  void require_all_runs() const {
    if (runs_.size() == plan_.runs.size()) return;
    std::set<std::string> shards;
    for (const Part& part : parts_) {
      for (const EnvironmentRecord& environment : part.records.environments) shards.insert(environment.shard);
    }
    for (const PlannedRun& run : plan_.runs) {
      if (runs_.contains(run.run_id)) continue;
      throw InputError(std::to_string(plan_.runs.size() - runs_.size()) + " of " + std::to_string(plan_.runs.size()) +
                       " runs are missing, the first: " + label_of(run, plan_) + "; shards that were begun: " +
                       joined({shards.begin(), shards.end()}) + "; run the others, or these with --resume");
    }
  }

  [[nodiscard]] std::vector<InstanceRecord> instances_in_order() const {
    using Key = std::tuple<std::string, std::string, Index, std::uint64_t>;
    std::map<Key, const InstanceRecord*> rows;
    KnownOptima known;
    for (const Part& part : parts_) {
      for (const InstanceRecord& row : part.records.instances) {
        rows[{row.generator, row.generator_params, row.n, row.seed}] = &row;
        const auto bounds = optimum_of(row);
        if (!bounds || known.add(row.instance_id, *bounds)) continue;
        throw std::logic_error("CONTRADICTION: certified optima of instance " + row.instance_id +
                               " exclude each other, the last in " + part.folder);
      }
    }
    std::vector<InstanceRecord> ordered;
    std::set<std::string> seen;
    for (const PlannedInstance& planned : plan_.instances) {
      const auto row = rows.find({planned.generator, planned.parameters, planned.n, planned.seed});
      if (row != rows.end() && seen.insert(row->second->instance_id).second) ordered.push_back(*row->second);
    }
    return ordered;
  }

  const std::vector<Part>& parts_;
  Plan plan_;
  std::map<std::string, std::pair<const RunRecord*, std::string>> runs_;  // by id, with the folder
};

}  // namespace

std::size_t merge_results(const MergeOptions& options, const Catalogue& catalogue) {
  const std::vector<Part> parts = read_parts(options);
  require_one_study(parts);
  if (!options.accepts_other_build) require_one_commit(parts);
  const Study study = read_study(options.folders.front() + "/study.toml", options.instance_folder);
  const StudyRecords merged = Merger(parts, make_plan(study, catalogue)).merge();
  write_records(options.target, merged);
  return merged.runs.size();
}

}  // namespace mwt
