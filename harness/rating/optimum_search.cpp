#include "harness/rating/optimum_search.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/text/text.h"
#include "harness/rating/known_optima.h"
#include "harness/rating/quality.h"
#include "harness/run/isolated_run.h"
#include "harness/study/plan.h"

namespace mwt {

namespace {

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
  OptimumClaims claims;
  FoundOptimum found;

  explicit Search(ProcessPool& p) : pool(p) {}

  void begin_search() {
    if (cache) look_up();
    ask_next_source();
  }

  // All keys before any search: whichever source proved the optimum, it is proved.
  void look_up() {
    OptimumClaims cached = claims;
    for (const AlgorithmInfo* source : sources) {
      const OptimumKey key = key_of(*source);
      const std::optional<CachedOptimum> entry = cache->find(key);
      if (!entry) continue;
      const OptimumClaim claim{source->name, cached_claimant(source->name), entry->interval};
      for (const Disproof& disproof : cached.add_claim(claim)) {
        found.warnings.push_back(disproof.text() + "; the optimum is sought anew");
      }
    }
    if (!found.warnings.empty()) return;
    claims = cached;
    found.is_cached = is_proved();
  }

  [[nodiscard]] OptimumKey key_of(const AlgorithmInfo& source) const {
    return optimum_key(instance->id, source, Parameters(source.name, source.parameters, {}));
  }

  [[nodiscard]] bool is_proved() const { return optimality_of(claims.bounds()) == Optimality::proved; }

  void ask_next_source() {
    if (is_proved() || next == sources.size()) {
      finish();
      return;
    }
    const AlgorithmInfo& source = *sources[next++];
    Request request;
    request.algorithm = &source;
    request.parameters = Parameters(source.name, source.parameters, {});
    request.time_limit_s = limits.time_s;
    RunRecord keys;
    keys.algorithm = source.name;
    const Timing once{1e-9, false};
    start_isolated_run(pool, request, instance, keys, limits, once,
                       [self = shared_from_this(), &source](const RunRecord& record) { self->take(source, record); });
  }

  void take(const AlgorithmInfo& source, const RunRecord& record) {
    note(source.name + ": " + answer_of(record));
    if (is_disproved(record)) found.contradictions.push_back(record.message);
    if (record.status == RunStatus::ok) believe(source, record);
    ask_next_source();
  }

  void believe(const AlgorithmInfo& source, const RunRecord& record) {
    const double weight = record.weight_upper.value();
    if (!record.certified_lower) {
      add(claims.add_weight({source.name, weight}));
      return;
    }
    const OptimumClaim claim{source.name, source.name, {*record.certified_lower, weight}};
    const std::vector<Disproof> disproofs = claims.add_claim(claim);
    add(disproofs);
    const bool stands = std::none_of(disproofs.begin(), disproofs.end(),
                                     [&](const Disproof& disproof) { return disproof.claim.id == claim.id; });
    if (cache && stands) cache->store(key_of(source), {claim.bounds, record.wall_time_s.value_or(0)});
  }

  void add(const std::vector<Disproof>& disproofs) {
    for (const Disproof& disproof : disproofs) found.contradictions.push_back(disproof.text());
  }

  // For the note on an optimum that is not proved in the end.
  static std::string answer_of(const RunRecord& record) {
    if (record.status != RunStatus::ok) {
      return std::string(name_of(record.status)) + (record.message.empty() ? "" : ", " + record.message);
    }
    if (!record.certified_lower) return "no bounds";
    return "bounds " + number_text(*record.certified_lower) + " to " + number_text(record.weight_upper.value()) +
           (record.stop_reason ? ", stopped early, " + std::string(phrase_of(*record.stop_reason)) : "");
  }

  void note(const std::string& text) { found.note += (found.note.empty() ? "" : "; ") + text; }

  [[nodiscard]] std::string standing_sources() const {
    std::vector<std::string> names;
    for (const OptimumClaim& claim : claims.standing()) names.push_back(claim.id);
    return joined(names, "+");
  }

  void finish() {
    found.interval = claims.bounds();
    found.source = standing_sources();
    if (is_proved()) found.note = found.is_cached ? kCachedNote : "";
    if (!found.contradictions.empty()) {
      found.note = joined(found.contradictions, "; ") + (found.note.empty() ? "" : "; ") + found.note;
    }
    if (!found.warnings.empty() && claims.lightest()) {
      static_cast<void>(cache->discard_disproved(instance->id, claims.lightest()->weight));
    }
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
    if (n <= max_n_for(info, source.max_n)) result.push_back(&info);
  }
  if (!sources.empty()) return result;
  for (const AlgorithmInfo& info : catalogue.algorithms()) {
    const bool takes_it = n <= max_n_for(info, {}) && (in_convex_position || !info.convex_position_only);
    if (info.exactness == Exactness::exact && takes_it) result.push_back(&info);
  }
  const auto rank = [](const AlgorithmInfo& info) { return std::pair(info.convex_position_only, max_n_for(info, {})); };
  std::stable_sort(result.begin(), result.end(),
                   [&](const AlgorithmInfo* a, const AlgorithmInfo* b) { return rank(*a) > rank(*b); });
  return result;
}

OptimumKey optimum_key(const std::string& instance_id, const AlgorithmInfo& solver, const Parameters& parameters) {
  return {instance_id, solver.name, solver.version, parameters.canonical()};
}

void seek_optimum(ProcessPool& pool, std::shared_ptr<const Instance> instance,
                  std::vector<const AlgorithmInfo*> sources, const RunLimits& limits, OptimumCache* cache,
                  const std::optional<KnownWeight>& known, std::function<void(FoundOptimum)> when_done) {
  const auto search = std::make_shared<Search>(pool);
  search->instance = std::move(instance);
  search->sources = std::move(sources);
  search->limits = limits;
  search->cache = cache;
  search->when_done = std::move(when_done);
  if (known) static_cast<void>(search->claims.add_weight(*known));
  search->begin_search();
}

}  // namespace mwt
