#include "harness/study/study_results.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>

namespace mwt {

StudyResults::StudyResults(ResultsFolder& folder, OptimumCache* cache, Announce announce)
    : folder_(folder), cache_(cache), announce_(std::move(announce)) {
  for (const InstanceRecord& record : folder.instances()) recorded_.insert(record.instance_id);
  adopt(folder.instances());
  adopt(folder.runs());
  // An instance whose optimum was disproved has none until one is found that stands.
  for (const InstanceRecord& instance : folder.instances()) {
    if (is_disproved(instance) && !instance.optimum_lower) to_seek_again_.insert(instance.instance_id);
  }
}

template <class Record>
void StudyResults::adopt(const std::vector<Record>& records) {
  std::map<std::string, std::pair<std::string, std::vector<Disproof>>> disproofs;  // by instance, with its label
  for (const Record& record : records) {
    for (const Disproof& disproof : known_.add(record)) {
      auto& [label, of_instance] = disproofs[record.instance_id];
      label = label_of_instance(record);
      of_instance.push_back(disproof);
    }
  }
  // Settling changes the records: only now.
  for (const auto& [instance_id, entry] : disproofs) settle(instance_id, entry.first, entry.second);
}

// Announces the disproved claims about an instance, throws them out of the optimum cache, and corrects the records.
void StudyResults::settle(const std::string& instance_id, const std::string& label,
                          const std::vector<Disproof>& disproofs) {
  if (disproofs.empty()) return;
  double weight = disproofs.front().weight;
  for (const Disproof& disproof : disproofs) {
    ++outcome_.contradictions;
    announce_(label + ": " + disproof.text());
    weight = std::min(weight, disproof.weight);
    if (disproof.claim.id == instance_id) to_seek_again_.insert(instance_id);
  }
  const auto discarded =
      cache_ == nullptr ? std::vector<std::string>() : cache_->discard_disproved(instance_id, weight);
  for (const std::string& path : discarded) announce_("removed from the optimum cache: " + path);
  folder_.settle(instance_id);
}

bool StudyResults::add(const InstanceRecord& record, const std::vector<std::string>& contradictions) {
  const std::string label = label_of_instance(record);
  for (const std::string& contradiction : contradictions) {
    ++outcome_.contradictions;
    announce_(label + ": " + contradiction);
  }
  to_seek_again_.erase(record.instance_id);
  const std::vector<Disproof> disproofs = known_.add(record);
  if (recorded_.insert(record.instance_id).second) {
    folder_.append(record);
  } else {
    folder_.replace(record);
    folder_.settle(record.instance_id);  // its runs are rated by it
  }
  settle(record.instance_id, label, disproofs);
  return contradictions.empty() && disproofs.empty();
}

RunRecord StudyResults::add(RunRecord run) {
  const std::string label = label_of_instance(run);
  const std::vector<Disproof> disproofs = known_.add(run);
  for (const Disproof& disproof : disproofs) {
    if (disproof.claim.id == run.run_id) reject(run, disproof);
  }
  known_.rate(run);
  if (is_disproved(run) && disproofs.empty()) {
    ++outcome_.contradictions;
    announce_(fmt::format("{} on {}: {}", run.algorithm, label, run.message));
  }
  folder_.append(run);
  settle(run.instance_id, label, disproofs);
  ++outcome_.runs;
  if (is_failure(run.status)) ++outcome_.failures;
  return folder_.runs().back();
}

// The cache may hold what the same solver proved before, although the study does not take it for the optimum.
void StudyResults::compare_with_cache(RunRecord& run, const OptimumKey& key) {
  if (cache_ == nullptr || run.status != RunStatus::ok || !run.certified_lower) return;
  const std::optional<CachedOptimum> earlier = cache_->find(key);
  if (!earlier) return;
  OptimumClaims claims;
  static_cast<void>(claims.add_claim({"cache", cache_->path_of(key), earlier->interval}));
  for (const Disproof& disproof : add_run(claims, "run", run.algorithm, run)) {
    if (disproof.claim.id == "run") {
      reject(run, disproof);
    } else {
      announce_(disproof.text() + "; it is removed from the optimum cache");
      static_cast<void>(cache_->discard_disproved(run.instance_id, disproof.weight));
    }
  }
}

// Other studies need not solve the instance again.
void StudyResults::keep_in_cache(const RunRecord& row, const OptimumKey& key) {
  if (cache_ == nullptr || row.status != RunStatus::ok || !row.certified_lower) return;
  const Interval optimum{*row.certified_lower, row.weight_upper.value()};
  if (!cache_->find(key)) cache_->store(key, {optimum, row.wall_time_s.value_or(0)});
}

bool StudyResults::has_optimum_row(const std::string& instance_id) const {
  return recorded_.contains(instance_id) && !to_seek_again_.contains(instance_id);
}

}  // namespace mwt
