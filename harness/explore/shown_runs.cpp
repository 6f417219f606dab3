#include "harness/explore/shown_runs.h"

#include <algorithm>
#include <utility>

#include "harness/explore/frame.h"
#include "harness/rating/optimum_search.h"

namespace mwt {

namespace {

// What run in its process sends back.
std::string edges_and_triangles(const Execution& execution, const PointSet& set) {
  const Triangulation in_input{set.input_count, to_input_indices(set, execution.solution.triangulation.triangles)};
  std::string bytes;
  append_indices(bytes, edges_of(in_input));
  append_indices(bytes, in_input.triangles);
  return bytes;
}

bool is_exact(const Catalogue& catalogue, const std::string& algorithm) {
  return catalogue.algorithm(algorithm).exactness == Exactness::exact;
}

}  // namespace

ShownRun ShownRuns::run_isolated(ProcessPool& pool, const Request& request, const std::function<void()>& wait) {
  ShownRun shown;
  shown.algorithm = request.algorithm->name;
  const Timing once{1e-9, false};
  start_isolated_run_with(
      pool, request, instance_, limits_, once,
      [this](const Execution& execution) { return edges_and_triangles(execution, instance_.set); },
      [&shown](RatedRun run, std::string enclosed) {
        shown.run = std::move(run);
        shown.edges_and_triangles = std::move(enclosed);
      });
  wait();
  for (const Disproof& disproof : add_run(claims_, shown.algorithm, shown.algorithm, shown.run))
    optimum_.contradictions.push_back(disproof.text());
  return shown;
}

void ShownRuns::run(ProcessPool& pool, const Request& request, const std::function<void()>& wait) {
  runs_.push_back(run_isolated(pool, request, wait));
  if (is_exact(catalogue_, runs_.back().algorithm)) offer_witness(runs_.back());
}

void ShownRuns::offer_witness(const ShownRun& run) {
  if (run.run.status != RunStatus::ok || !run.run.weight_upper) return;
  if (optimum_.witness && *optimum_.witness->run.weight_upper <= *run.run.weight_upper) return;
  optimum_.witness = run;
  optimum_.source = run.algorithm;
}

void ShownRuns::seek_optimum(ProcessPool& pool, const std::function<void()>& wait) {
  const auto n = static_cast<Index>(instance_.set.points.size());
  for (const AlgorithmInfo* source : optimum_sources_for(catalogue_, {}, n, instance_.hull_size == n)) {
    if (is_proved()) break;
    const bool has_run = std::ranges::any_of(runs_, [&](const ShownRun& run) { return run.algorithm == source->name; });
    if (has_run) continue;
    Request request;
    request.algorithm = source;
    request.parameters = Parameters(source->name, source->parameters, {});
    request.time_limit_s = limits_.time_s;
    const ShownRun run = run_isolated(pool, request, wait);
    offer_witness(run);
    if (run.run.status != RunStatus::ok) {
      optimum_.note += (optimum_.note.empty() ? "" : "; ") + source->name + ": " +
                       std::string(name_of(run.run.status)) + (run.run.message.empty() ? "" : ", " + run.run.message);
    }
  }
  optimum_.interval = claims_.bounds();
  if (is_proved()) optimum_.note.clear();
}

void ShownRuns::rate_all() {
  for (ShownRun& shown : runs_) {
    if (shown.run.status == RunStatus::ok) rate(shown.run, claims_.bounds());
  }
}

}  // namespace mwt
