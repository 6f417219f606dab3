#include "harness/tracking/measures.h"

#include <algorithm>
#include <numeric>

#include "base/error.h"
#include "harness/io/text/text.h"
#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

bool is_repeatable(const RunRecord& run) { return run.status == RunStatus::ok && !run.stopped_early.value_or(false); }

std::optional<double> if_ok(const RunRecord& run, const std::optional<double>& value) {
  return run.status == RunStatus::ok ? value : std::nullopt;
}

/// CPU time where one thread is allowed: what other programs took is not in it. The Delaunay time, a median of short
/// runs, has hardly any of it either.
double undisturbed_time(const RunRecord& run) {
  return run.threads == 1 && run.cpu_time_s > 0.0 ? *run.cpu_time_s : *run.wall_time_s;
}

std::optional<double> relative_time(const RunRecord& run) {
  if (run.status != RunStatus::ok || !run.wall_time_s || !run.delaunay_time_s || *run.delaunay_time_s <= 0)
    return std::nullopt;
  return undisturbed_time(run) / *run.delaunay_time_s;
}

std::optional<double> memory(const RunRecord& run) {
  if (run.status != RunStatus::ok || !run.peak_rss_bytes) return std::nullopt;
  return static_cast<double>(*run.peak_rss_bytes);
}

std::optional<double> proved_alpha(const RunRecord& run) {
  return is_repeatable(run) && run.optimality == "proved" ? run.alpha_upper : std::nullopt;
}

std::optional<double> weight_of(const RunRecord& run) {
  if (!is_repeatable(run) || !run.weight_lower || !run.weight_upper) return std::nullopt;
  return Interval{*run.weight_lower, *run.weight_upper}.middle();
}

std::optional<double> failure(const RunRecord& run) {
  if (run.status == RunStatus::not_applicable) return std::nullopt;
  return is_failure(run.status) ? 1 : 0;
}

/// Of runs to their end: how far a run comes that is stopped depends on the machine.
template <std::optional<std::uint64_t> RatedRun::*member>
std::optional<double> count_of(const RunRecord& run) {
  if (!is_repeatable(run) || !(run.*member)) return std::nullopt;
  return static_cast<double>(*(run.*member));
}

std::vector<Measure> make_measures() {
  const auto wall = [](const RunRecord& run) { return if_ok(run, run.wall_time_s); };
  const auto cpu = [](const RunRecord& run) {
    return run.cpu_time_s > 0.0 ? if_ok(run, run.cpu_time_s) : std::nullopt;
  };
  return {
      {"relative_time", "", Aspect::time, false, relative_time},
      {"wall_time_s", "s", Aspect::time, false, wall},
      {"cpu_time_s", "s", Aspect::time, false, cpu},
      {"peak_rss_bytes", "bytes", Aspect::memory, false, memory},
      {"alpha", "", Aspect::quality, true, proved_alpha},
      {"weight", "", Aspect::quality, true, weight_of},
      {"failures", "", Aspect::failures, true, failure},
      {"instructions", "", Aspect::counts, true, count_of<&RatedRun::instructions>},
      {"cycles", "", Aspect::counts, false, count_of<&RatedRun::cycles>},
      {"cache_misses", "", Aspect::counts, false, count_of<&RatedRun::cache_misses>},
      {"branch_misses", "", Aspect::counts, false, count_of<&RatedRun::branch_misses>},
      {"callgrind_instructions", "", Aspect::counts, true, count_of<&RatedRun::callgrind_instructions>},
      {"callgrind_l1_misses", "", Aspect::counts, true, count_of<&RatedRun::callgrind_l1_misses>},
      {"callgrind_ll_misses", "", Aspect::counts, true, count_of<&RatedRun::callgrind_ll_misses>},
      {"callgrind_branch_misses", "", Aspect::counts, true, count_of<&RatedRun::callgrind_branch_misses>},
  };
}

}  // namespace

std::string name_of(Aspect aspect) {
  switch (aspect) {
    case Aspect::time: return "time";
    case Aspect::memory: return "memory";
    case Aspect::quality: return "quality";
    case Aspect::failures: return "failures";
    case Aspect::counts: return "counts";
  }
  return "";
}

std::span<const Measure> measures() {
  static const std::vector<Measure> all = make_measures();
  return all;
}

const Measure& measure_named(const std::string& name) {
  std::vector<std::string> known;
  for (const Measure& measure : measures()) {
    if (measure.name == name) return measure;
    known.push_back(measure.name);
  }
  throw InputError("unknown measure '" + name + "'; known: " + joined(known));
}

std::vector<double> values_of(const Measure& measure, const std::vector<const RunRecord*>& runs) {
  std::vector<double> values;
  for (const RunRecord* run : runs) {
    if (const auto value = measure.of(*run)) values.push_back(*value);
  }
  return values;
}

std::optional<TypicalValue> typical(const Measure& measure, const std::vector<const RunRecord*>& runs) {
  const std::vector<double> values = values_of(measure, runs);
  if (values.empty()) return std::nullopt;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return TypicalValue{measure.aspect == Aspect::failures ? mean : median(values), values.size()};
}

}  // namespace mwt
