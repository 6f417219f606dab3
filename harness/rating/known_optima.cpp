#include "harness/rating/known_optima.h"

#include <cmath>
#include <iterator>

#include "harness/io/text/text.h"
#include "harness/rating/quality.h"

namespace mwt {

namespace {

// A lower bound that says nothing is no claim.
bool is_claim(const std::optional<double>& lower) { return lower && *lower > 0 && std::isfinite(*lower); }

std::string solver_of(const RunRecord& run) { return name_with_parameters(run.algorithm, run.params); }

std::string solver_of(const InstanceRecord& instance) {
  const bool is_cached = instance.optimum_note == kCachedNote;
  return is_cached ? cached_claimant(instance.optimum_source) : instance.optimum_source;
}

void clear_rating(RunRecord& record) {
  record.optimum_lower.reset();
  record.optimum_upper.reset();
  record.optimality.clear();
  record.alpha_lower.reset();
  record.alpha_upper.reset();
  record.optimal.clear();
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
  if (record.status != RunStatus::ok || !record.weight_upper) return {};
  OptimumClaims& claims = instances_[record.instance_id];
  if (!is_claim(record.certified_lower)) return claims.add_weight({solver_of(record), *record.weight_upper});
  return claims.add_claim({record.run_id, solver_of(record), {*record.certified_lower, *record.weight_upper}});
}

std::optional<Interval> KnownOptima::of(const std::string& instance_id) const {
  const auto entry = instances_.find(instance_id);
  return entry == instances_.end() ? std::nullopt : entry->second.bounds();
}

std::optional<KnownWeight> KnownOptima::lightest_of(const std::string& instance_id) const {
  const auto entry = instances_.find(instance_id);
  return entry == instances_.end() ? std::nullopt : entry->second.lightest();
}

void KnownOptima::rate(RunRecord& record) const {
  if (record.status != RunStatus::ok) return;
  clear_rating(record);
  const Interval weight{record.weight_lower.value(), record.weight_upper.value()};
  const std::optional<Interval> optimum = of(record.instance_id);
  record.optimality = name_of(optimality_of(optimum));
  record.optimal = name_of(is_optimal(weight, optimum));
  if (!optimum) return;
  const Interval alpha = alpha_of(weight, *optimum);
  record.optimum_lower = optimum->lower;
  record.optimum_upper = optimum->upper;
  record.alpha_lower = alpha.lower;
  record.alpha_upper = alpha.upper;
}

bool is_disproved(const RunRecord& record) {
  return record.status == RunStatus::error && record.message.starts_with(kContradiction);
}

bool is_disproved(const InstanceRecord& record) { return record.optimum_note.starts_with(kContradiction); }

void reject(RunRecord& record, const Disproof& disproof) {
  record.status = RunStatus::error;
  record.message = disproof.text();
  record.delaunay_time_s.reset();
  clear_rating(record);
}

void reject(InstanceRecord& record, const Disproof& disproof) {
  record.optimum_lower.reset();
  record.optimum_upper.reset();
  record.optimality = name_of(Optimality::none);
  record.optimum_source.clear();
  record.optimum_note = disproof.text();
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

}  // namespace mwt
