#include "harness/study/merge.h"

#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "harness/io/text/text.h"
#include "harness/records/known_optima.h"
#include "harness/records/profile_folder.h"
#include "harness/records/proof_folder.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

struct Part {
  std::string folder;
  StudyRecords records;
};

std::string label_of(const RunRecord& run) {
  return fmt::format("{} on {} repetition={}", name_with_parameters(run.algorithm, run.params), label_of_instance(run),
                     run.repetition);
}

std::string label_of(const PlannedRun& run, const Plan& plan) {
  return fmt::format("{} on {} repetition={}", name_with_parameters(run.algorithm->name, run.parameters.canonical()),
                     plan.instances[run.instance].label(), run.repetition);
}

// A study that still runs would look like a gap: its lock shows that it runs.
std::vector<Part> read_parts(const MergeOptions& options) {
  std::vector<Part> parts;
  for (const std::string& folder : options.folders) {
    if (std::filesystem::exists(folder)) const FolderLock lock(folder, options.folder_use);
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
  throw InputError(
      fmt::format("{} and {} were recorded by different builds of mwt (commits {} and {}); run one again, or mix the "
                  "two with --accept-other-build",
                  one_folder, other_folder, one, other));
}

using InstanceName = std::tuple<std::string, std::string, Index, std::uint64_t>;

template <class Record>
InstanceName name_of(const Record& record) {
  return {record.generator, record.generator_params, record.n, record.seed};
}

// A point file that differs between two machines gives one name to two instances.
void require_same_points(const std::vector<RunRecord>& runs, const std::vector<InstanceRecord>& instances) {
  std::map<InstanceName, std::string> ids;
  const auto require = [&](const auto& record) {
    if (record.instance_id.empty()) return;
    const auto entry = ids.try_emplace(name_of(record), record.instance_id).first;
    if (entry->second == record.instance_id) return;
    throw InputError(fmt::format(
        "the shards have different points under one name, {}: {} and {}; run the study anew with the same files",
        label_of_instance(record), entry->second, record.instance_id));
  };
  for (const RunRecord& run : runs) require(run);
  for (const InstanceRecord& instance : instances) require(instance);
}

struct MergedRecords {
  StudyRecords records;
  std::vector<std::string> contradictions;
};

class Merger {
 public:
  Merger(const std::vector<Part>& parts, Plan plan) : parts_(parts), plan_(std::move(plan)) {}

  MergedRecords merge() {
    MergedRecords result;
    StudyRecords& merged = result.records;
    merged.study_file = parts_.front().records.study_file;
    collect_runs();
    require_all_runs();
    for (const PlannedRun& run : plan_.runs) merged.runs.push_back(*runs_.at(run.run_id).first);
    std::vector<InstanceRecord> instances;
    for (const Part& part : parts_) {
      instances.insert(instances.end(), part.records.instances.begin(), part.records.instances.end());
    }
    require_same_points(merged.runs, instances);
    for (const Disproof& disproof : reject_disproved(merged.runs, instances)) {
      result.contradictions.push_back(disproof.text());
    }
    merged.instances = in_order(instances);
    for (const Part& part : parts_) {
      merged.environments.insert(merged.environments.end(), part.records.environments.begin(),
                                 part.records.environments.end());
    }
    return result;
  }

 private:
  void collect_runs() {
    const std::set<std::string> planned = run_ids_of(plan_);
    for (const Part& part : parts_) {
      for (const RunRecord& run : part.records.runs) {
        if (!planned.contains(run.run_id)) {
          throw InputError(
              fmt::format("{}: this mwt does not plan its run {}; merge with the commit that recorded it ({}) and the "
                          "same point and start files; --study names the study file, if commands or start files count "
                          "from its folder",
                          part.folder, label_of(run), run.git_commit));
        }
        const auto [entry, is_new] = runs_.try_emplace(run.run_id, &run, part.folder);
        if (is_new) continue;
        throw InputError(fmt::format("{} and {} overlap: both have {}; name every shard once", entry->second.second,
                                     part.folder, label_of(run)));
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
      throw InputError(
          fmt::format("{} of {} runs are missing, the first: {}; shards that were begun: {}; run the others, or these "
                      "with --resume",
                      plan_.runs.size() - runs_.size(), plan_.runs.size(), label_of(run, plan_),
                      joined({shards.begin(), shards.end()})));
    }
  }

  // Of instances with the same points the first in the plan's order.
  [[nodiscard]] std::vector<InstanceRecord> in_order(const std::vector<InstanceRecord>& instances) const {
    std::map<InstanceName, const InstanceRecord*> rows;
    for (const InstanceRecord& row : instances) rows[name_of(row)] = &row;
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

namespace {

// Its copy in the results does for studies without commands and start files.
Study study_to_merge(const MergeOptions& options, const std::vector<Part>& parts) {
  if (!options.study_path) return read_study(options.folders.front() + "/study.toml", options.instance_folder);
  Study study = read_study(*options.study_path, options.instance_folder);
  if (study.file_content == parts.front().records.study_file) return study;
  throw InputError(
      fmt::format("{}: differs from the study.toml of {}; give the study file that the shards were run with",
                  *options.study_path, options.folders.front()));
}

}  // namespace

MergeOutcome merge_results(const MergeOptions& options, const Catalogue& catalogue) {
  const std::vector<Part> parts = read_parts(options);
  require_one_study(parts);
  if (!options.accepts_other_build) require_one_commit(parts);
  const Study study = study_to_merge(options, parts);
  MergedRecords merged = Merger(parts, make_plan(study, catalogue)).merge();
  write_records(options.target, merged.records, options.folder_use);
  copy_proofs(options.folders, options.target, merged.records.instances);
  copy_profiles(options.folders, options.target, merged.records.runs);
  MergeOutcome outcome;
  outcome.runs = merged.records.runs.size();
  outcome.contradictions = std::move(merged.contradictions);
  for (const Part& part : parts) {
    outcome.warnings.insert(outcome.warnings.end(), part.records.warnings.begin(), part.records.warnings.end());
  }
  return outcome;
}

}  // namespace mwt
