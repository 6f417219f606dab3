#include "harness/rating/optimum_search.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/text/text.h"
#include "harness/rating/isolated_run.h"
#include "harness/rating/quality.h"
#include "harness/rating/sought_proof.h"

namespace mwt {

namespace {

OptimumKey key_of(const Instance& instance, const AlgorithmInfo& source) {
  return optimum_key(instance.id, source, Parameters(source.name, source.parameters, {}));
}

// What a source came to, for the note on an optimum that is not proved in the end.
std::string summary_of(const RatedRun& run) {
  if (run.status != RunStatus::ok) {
    return std::string(name_of(run.status)) + (run.message.empty() ? "" : ", " + run.message);
  }
  if (!run.certified_lower) return "no bounds";
  return fmt::format("bounds {} to {}{}", number_text(*run.certified_lower), number_text(run.weight_upper.value()),
                     run.stop_reason ? ", stopped early, " + std::string(phrase_of(*run.stop_reason)) : "");
}

// A search, however its sources are run.
class Search {
 public:
  Search(const Instance& instance, std::vector<const AlgorithmInfo*> sources, OptimumCache* cache,
         const std::optional<KnownWeight>& known)
      : instance_(instance), sources_(std::move(sources)), cache_(cache) {
    if (known) static_cast<void>(claims_.add_weight(*known));
    if (cache_ != nullptr) look_up();
  }

  // The source to run now; null once the optimum is proved or no source is left. If there must be a proof, another
  // source that writes one runs for a proved optimum, too.
  const AlgorithmInfo* next_source(bool must_prove) {
    while (next_ < sources_.size() && (must_prove || !is_proved())) {
      const AlgorithmInfo* const source = sources_[next_++];
      if (!is_proved() || source->has_proofs) return source;
    }
    return nullptr;
  }

  // Of the sources whose optimum came from the cache.
  [[nodiscard]] const std::vector<OptimumKey>& cached_keys() const { return cached_keys_; }

  [[nodiscard]] std::optional<Interval> bounds() const { return claims_.bounds(); }

  void add(const AlgorithmInfo& source, const RatedRun& run) {
    found_.note += (found_.note.empty() ? "" : "; ") + source.name + ": " + summary_of(run);
    if (is_disproved(run)) found_.contradictions.push_back(run.message);
    const std::vector<Disproof> disproofs = add_run(claims_, source.name, source.name, run);
    for (const Disproof& disproof : disproofs) found_.contradictions.push_back(disproof.text());
    const bool stands =
        std::ranges::none_of(disproofs, [&](const Disproof& disproof) { return disproof.claim.id == source.name; });
    if (!stands || run.status != RunStatus::ok || !run.certified_lower) return;
    const Interval own{*run.certified_lower, run.weight_upper.value()};
    if (optimality_of(own) == Optimality::proved) found_.is_cached = false;
    if (cache_ != nullptr) cache_->store(key_of(instance_, source), {own, run.wall_time_s.value_or(0)});
  }

  FoundOptimum finish() {
    found_.interval = claims_.bounds();
    found_.source = standing_sources();
    if (is_proved()) found_.note = found_.is_cached ? kCachedNote : "";
    if (!found_.contradictions.empty()) {
      found_.note = joined(found_.contradictions, "; ") + (found_.note.empty() ? "" : "; ") + found_.note;
    }
    if (!found_.warnings.empty() && claims_.lightest()) {
      static_cast<void>(cache_->discard_disproved(instance_.id, claims_.lightest()->weight));
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    found_.time_s = elapsed.count();
    return std::move(found_);
  }

 private:
  // All keys before any search: whichever source proved the optimum, it is proved.
  void look_up() {
    OptimumClaims cached = claims_;
    for (const AlgorithmInfo* source : sources_) {
      const std::optional<CachedOptimum> entry = cache_->find(key_of(instance_, *source));
      if (!entry) continue;
      cached_keys_.push_back(key_of(instance_, *source));
      const OptimumClaim claim{source->name, cached_claimant(source->name), entry->interval};
      for (const Disproof& disproof : cached.add_claim(claim)) {
        found_.warnings.push_back(disproof.text() + "; the optimum is sought anew");
      }
    }
    if (!found_.warnings.empty()) {
      cached_keys_.clear();
      return;
    }
    claims_ = cached;
    found_.is_cached = is_proved();
  }

  [[nodiscard]] bool is_proved() const { return optimality_of(claims_.bounds()) == Optimality::proved; }

  [[nodiscard]] std::string standing_sources() const {
    std::vector<std::string> names;
    for (const OptimumClaim& claim : claims_.standing()) {
      if (std::ranges::find(names, claim.id) == names.end()) names.push_back(claim.id);
    }
    return joined(names, "+");
  }

  const Instance& instance_;
  std::vector<const AlgorithmInfo*> sources_;
  OptimumCache* cache_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::size_t next_ = 0;
  std::vector<OptimumKey> cached_keys_;
  OptimumClaims claims_;
  FoundOptimum found_;
};

Request request_for(const AlgorithmInfo& source, double time_limit_s) {
  Request request;
  request.algorithm = &source;
  request.parameters = Parameters(source.name, source.parameters, {});
  request.time_limit_s = time_limit_s;
  return request;
}

// One source after the other, each in a process, and then the verifier; alive as long as one of them runs.
class IsolatedSearch : public std::enable_shared_from_this<IsolatedSearch> {
 public:
  IsolatedSearch(ProcessPool& pool, OptimumRequest request, std::function<void(FoundOptimum)> when_done)
      : pool_(pool),
        request_(std::move(request)),
        when_done_(std::move(when_done)),
        search_(*request_.instance, request_.sources, request_.cache, request_.known),
        proof_(request_.proof_file, request_.cache) {}

  void run() {
    proof_.begin(search_.cached_keys());
    run_next_source();
  }

 private:
  void run_next_source() {
    const AlgorithmInfo* source = search_.next_source(proof_.is_missing());
    if (source == nullptr) {
      check_proof();
      return;
    }
    const Timing once{1e-9, false};
    start_isolated_run(
        pool_, request_for(*source, request_.limits.time_s), *request_.instance, request_.limits, once,
        [self = shared_from_this(), source](const RatedRun& run) { self->add(*source, run); },
        proof_.candidate_of(*source));
  }

  void add(const AlgorithmInfo& source, const RatedRun& run) {
    search_.add(source, run);
    proof_.keep_if_better(key_of(*request_.instance, source), run);
    run_next_source();
  }

  void check_proof() {
    if (!proof_.exists()) {
      when_done_(search_.finish());
      return;
    }
    start_proof_check(pool_, *request_.instance, proof_.path(), request_.limits,
                      [self = shared_from_this()](const ProofCheck& check) { self->finish(check); });
  }

  void finish(ProofCheck check) {
    if (proof_.must_be_made_anew(check)) {
      run_next_source();
      return;
    }
    const std::optional<Interval> bounds = search_.bounds();
    if (check.interval && bounds && !overlap(*check.interval, *bounds)) {
      check.verdict = ProofVerdict::refused;
      check.note = fmt::format("it proves an optimum between {} and {}, the solvers one between {} and {}",
                               number_text(check.interval->lower), number_text(check.interval->upper),
                               number_text(bounds->lower), number_text(bounds->upper));
    }
    proof_.cache_if_new(check);
    FoundOptimum found = search_.finish();
    found.proof = std::move(check);
    when_done_(std::move(found));
  }

  ProcessPool& pool_;
  OptimumRequest request_;
  std::function<void(FoundOptimum)> when_done_;
  Search search_;
  SoughtProof proof_;
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

void seek_optimum(ProcessPool& pool, OptimumRequest request, std::function<void(FoundOptimum)> when_done) {
  std::make_shared<IsolatedSearch>(pool, std::move(request), std::move(when_done))->run();
}

FoundOptimum seek_optimum_here(const Instance& instance, const std::vector<const AlgorithmInfo*>& sources,
                               double time_limit_s) {
  Search search(instance, sources, nullptr, std::nullopt);
  while (const AlgorithmInfo* source = search.next_source(false)) {
    RatedRun run;
    try {
      run = judged(*source, instance.set.points, execute_once(request_for(*source, time_limit_s), instance.set.points));
    } catch (const NotApplicable& reason) {
      fail(run, RunStatus::not_applicable, reason.what());
    }
    search.add(*source, run);
  }
  return search.finish();
}

}  // namespace mwt
