#include "harness/records/known_optima.h"

#include <cmath>
#include <iterator>

#include "harness/io/text/text.h"
#include "harness/rating/optimum_search.h"
#include "harness/rating/quality.h"

namespace mwt {

namespace {

// A trivial lower bound is no claim.
bool is_claim(const std::optional<double>& lower) { return lower && *lower > 0 && std::isfinite(*lower); }

std::string solver_of(const RunRecord& run) { return name_with_parameters(run.algorithm, run.params); }

std::string solver_of(const InstanceRecord& instance) {
  const bool is_cached = instance.optimum_note == kCachedNote;
  return is_cached ? cached_claimant(instance.optimum_source) : instance.optimum_source;
}

void append(std::vector<Disproof>& all, std::vector<Disproof> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<Disproof> KnownOptima::add(const InstanceRecord& record) {
  if (!is_claim(record.optimum_lower) || !record.optimum_upper) return {};
  return instances_[record.instance_id].add_claim(
      {record.instance_id, solver_of(record), {*record.optimum_lower, *record.optimum_upper}});
}

std::vector<Disproof> KnownOptima::add(const RunRecord& record) {
  if (record.status != RunStatus::ok) return {};
  return add_run(instances_[record.instance_id], record.run_id, solver_of(record), record);
}

std::optional<Interval> KnownOptima::of(const std::string& instance_id) const {
  const auto entry = instances_.find(instance_id);
  return entry == instances_.end() ? std::nullopt : entry->second.bounds();
}

std::optional<KnownWeight> KnownOptima::lightest_of(const std::string& instance_id) const {
  const auto entry = instances_.find(instance_id);
  return entry == instances_.end() ? std::nullopt : entry->second.lightest();
}

void KnownOptima::rate(RunRecord& record) const { mwt::rate(record, of(record.instance_id)); }

bool is_disproved(const InstanceRecord& record) { return record.optimum_note.starts_with(kContradiction); }

void reject(InstanceRecord& record, const Disproof& disproof) {
  record.optimum_lower.reset();
  record.optimum_upper.reset();
  record.optimality = name_of(Optimality::none);
  record.optimum_source.clear();
  record.optimum_note = disproof.text();
  record.verified.reset();
  record.proof_note.clear();
}

std::vector<Disproof> reject_disproved(std::vector<RunRecord>& runs, std::vector<InstanceRecord>& instances) {
  KnownOptima known;
  std::vector<Disproof> disproofs;
  for (const InstanceRecord& instance : instances) append(disproofs, known.add(instance));
  for (const RunRecord& run : runs) append(disproofs, known.add(run));
  std::map<std::string, const Disproof*> by_claim;
  for (const Disproof& disproof : disproofs) by_claim.emplace(disproof.claim.id, &disproof);
  std::set<std::string> unrated;  // instances whose ratings may rest on what was disproved
  for (InstanceRecord& instance : instances) {
    const auto disproof = by_claim.find(instance.instance_id);
    if (disproof == by_claim.end()) continue;
    reject(instance, *disproof->second);
    unrated.insert(instance.instance_id);
  }
  for (RunRecord& run : runs) {
    const auto disproof = by_claim.find(run.run_id);
    if (disproof == by_claim.end()) continue;
    reject(run, *disproof->second);
    unrated.insert(run.instance_id);
  }
  for (RunRecord& run : runs) {
    if (unrated.contains(run.instance_id)) known.rate(run);
  }
  return disproofs;
}

void rate_all(std::vector<RunRecord>& runs, const std::vector<InstanceRecord>& instances) {
  KnownOptima known;
  for (const InstanceRecord& instance : instances) static_cast<void>(known.add(instance));
  for (const RunRecord& run : runs) static_cast<void>(known.add(run));
  for (RunRecord& run : runs) {
    if (known.of(run.instance_id)) known.rate(run);
  }
}

std::vector<RunRecord> rated_by_all_bounds(std::vector<RunRecord> runs, std::vector<InstanceRecord> instances) {
  static_cast<void>(reject_disproved(runs, instances));
  rate_all(runs, instances);
  return runs;
}

}  // namespace mwt
