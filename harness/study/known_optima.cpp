#include "harness/study/known_optima.h"

#include "geometry/number_text.h"
#include "harness/quality.h"

namespace mwt {

namespace {

std::string text_of(const Interval& interval) {
  return '[' + number_text(interval.lower) + ", " + number_text(interval.upper) + ']';
}

void reject(RunRecord& record, const Interval& known, const std::string& own) {
  record.status = RunStatus::error;
  record.message = "CONTRADICTION: " + own + " excludes the certified optimum " + text_of(known);
  record.optimum_lower.reset();
  record.optimum_upper.reset();
}

}  // namespace

bool KnownOptima::add(const std::string& instance_id, const Interval& bounds) {
  const auto [entry, is_new] = bounds_.try_emplace(instance_id, bounds);
  if (is_new) return true;
  const std::optional<Interval> common = intersection(entry->second, bounds);
  if (common) entry->second = *common;
  return common.has_value();
}

std::optional<Interval> KnownOptima::of(const std::string& instance_id) const {
  const auto entry = bounds_.find(instance_id);
  if (entry == bounds_.end()) return std::nullopt;
  return entry->second;
}

bool KnownOptima::rate(RunRecord& record) {
  if (record.status != RunStatus::ok) return true;
  const Interval weight{record.weight_lower.value(), record.weight_upper.value()};
  const std::optional<Interval> own = optimum_of(record);
  if (own && !add(record.instance_id, *own)) {
    reject(record, *of(record.instance_id), "its certified optimum " + text_of(*own));
    return false;
  }
  const std::optional<Interval> before = of(record.instance_id);
  if (before && !add(record.instance_id, {before->lower, weight.upper})) {
    reject(record, *before, "its weight " + text_of(weight));
    return false;
  }
  const std::optional<Interval> optimum = of(record.instance_id);
  record.optimality = name_of(optimality_of(optimum));
  record.optimal = name_of(is_optimal(weight, optimum));
  if (!optimum) return true;
  const Interval alpha = alpha_of(weight, *optimum);
  record.optimum_lower = optimum->lower;
  record.optimum_upper = optimum->upper;
  record.alpha_lower = alpha.lower;
  record.alpha_upper = alpha.upper;
  return true;
}

}  // namespace mwt
