#include "harness/study/optimum_search.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "geometry/error.h"
#include "harness/quality.h"
#include "harness/study/isolated_run.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

// What a source's run says about why it did not prove the optimum; empty if it did.
std::string why_not_proved(const RunRecord& record) {
  if (record.status != RunStatus::ok) {
    return std::string(name_of(record.status)) + (record.message.empty() ? "" : ", " + record.message);
  }
  const std::optional<Interval> bounds = optimum_of(record);
  if (optimality_of(bounds) == Optimality::proved) return "";
  const std::string result = bounds ? "only bounds" : "no bounds";
  return result + (record.stop_reason ? ", " + std::string(phrase_of(*record.stop_reason)) : "");
}

// One search, alive as long as a process of it runs.
struct Search : std::enable_shared_from_this<Search> {
  ProcessPool& pool;
  std::shared_ptr<const Instance> instance;
  std::vector<const AlgorithmInfo*> sources;
  RunLimits limits;
  OptimumCache* cache = nullptr;
  std::function<void(FoundOptimum)> when_done;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  std::size_t next = 0;
  FoundOptimum found;

  explicit Search(ProcessPool& p) : pool(p) {}

  void begin_search() {
    if (cache) look_up();
    ask_next_source();
  }

  // All keys before any search: whichever source proved the optimum, it is proved.
  void look_up() {
    for (const AlgorithmInfo* source : sources) {
      const std::optional<CachedOptimum> entry = cache->find(key_of(*source));
      if (!entry) continue;
      combine(source->name, entry->interval);
      found.is_cached = true;
    }
    if (found.contradiction) note("both in the optimum cache " + cache->folder());
  }

  [[nodiscard]] OptimumKey key_of(const AlgorithmInfo& source) const {
    return optimum_key(instance->id, source, Parameters(source.name, source.parameters, {}));
  }

  [[nodiscard]] bool is_proved() const { return optimality_of(found.interval) == Optimality::proved; }

  void ask_next_source() {
    const bool is_settled = found.contradiction || is_proved();
    if (is_settled || next == sources.size()) {
      finish();
      return;
    }
    const AlgorithmInfo& source = *sources[next++];
    Request request;
    request.algorithm = &source;
    request.parameters = Parameters(source.name, source.parameters, {});
    request.time_limit_s = limits.time_s;
    const Timing once{1e-9, false};
    start_isolated_run(pool, request, instance, {}, limits, once,
                       [self = shared_from_this(), &source](const RunRecord& record) { self->take(source, record); });
  }

  void take(const AlgorithmInfo& source, const RunRecord& record) {
    if (const std::optional<Interval> bounds = optimum_of(record)) {
      combine(source.name, *bounds);
      if (cache && !found.contradiction) cache->store(key_of(source), {*bounds, record.wall_time_s.value_or(0)});
    }
    if (const std::string reason = why_not_proved(record); !reason.empty()) note(source.name + ": " + reason);
    ask_next_source();
  }

  void combine(const std::string& source, const Interval& bounds) {
    if (!found.interval) {
      found.interval = bounds;
      found.source = source;
      return;
    }
    const std::optional<Interval> common = intersection(*found.interval, bounds);
    found.contradiction = !common;
    if (!common) note("CONTRADICTION between " + found.source + " and " + source);
    found.interval = common;
    found.source += '+' + source;
  }

  void note(const std::string& text) { found.note += (found.note.empty() ? "" : "; ") + text; }

  void finish() {
    if (is_proved()) found.note = found.is_cached ? "cached" : "";
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    found.time_s = elapsed.count();
    when_done(std::move(found));
  }
};

const AlgorithmInfo& exact_algorithm(const Catalogue& catalogue, const OptimumSource& source) {
  try {
    const AlgorithmInfo& info = catalogue.algorithm(source.algorithm);
    if (info.exactness != Exactness::exact) throw InputError("'" + info.name + "' is not exact");
    return info;
  } catch (const InputError& error) {
    throw InputError(source.place + ": optimum source: " + error.what());
  }
}

}  // namespace

std::vector<const AlgorithmInfo*> optimum_sources_for(const Catalogue& catalogue,
                                                      const std::vector<OptimumSource>& sources, Index n,
                                                      bool in_convex_position) {
  std::vector<const AlgorithmInfo*> result;
  for (const OptimumSource& source : sources) {
    const AlgorithmInfo& info = exact_algorithm(catalogue, source);
    if (n <= largest_n_for(info, source.largest_n)) result.push_back(&info);
  }
  if (!sources.empty()) return result;
  for (const AlgorithmInfo& info : catalogue.algorithms()) {
    const bool takes_it = n <= largest_n_for(info, {}) && (in_convex_position || !info.convex_position_only);
    if (info.exactness == Exactness::exact && takes_it) result.push_back(&info);
  }
  const auto rank = [](const AlgorithmInfo& info) {
    return std::pair(info.convex_position_only, largest_n_for(info, {}));
  };
  std::stable_sort(result.begin(), result.end(),
                   [&](const AlgorithmInfo* a, const AlgorithmInfo* b) { return rank(*a) > rank(*b); });
  return result;
}

OptimumKey optimum_key(const std::string& instance_id, const AlgorithmInfo& solver, const Parameters& parameters) {
  return {instance_id, solver.name, solver.version, parameters.canonical()};
}

void seek_optimum(ProcessPool& pool, std::shared_ptr<const Instance> instance,
                  std::vector<const AlgorithmInfo*> sources, const RunLimits& limits, OptimumCache* cache,
                  std::function<void(FoundOptimum)> when_done) {
  const auto search = std::make_shared<Search>(pool);
  search->instance = std::move(instance);
  search->sources = std::move(sources);
  search->limits = limits;
  search->cache = cache;
  search->when_done = std::move(when_done);
  search->begin_search();
}

}  // namespace mwt
