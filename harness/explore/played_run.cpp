#include "harness/explore/played_run.h"

#include <fmt/core.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "algorithms/proof_trace.h"
#include "algorithms/step_trace.h"
#include "harness/explore/frame.h"
#include "harness/explore/played_proof.h"
#include "harness/explore/played_steps.h"

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxSteps = 300'000;

std::string trace_frame(const PlayedSteps& played) {
  if (played.steps.size() > kMaxSteps) {
    throw std::runtime_error(fmt::format("{} steps; at most {} are played, so take fewer points or less work",
                                         played.steps.size(), kMaxSteps));
  }
  Json stages = Json::array();
  for (const PlayedStage& stage : played.stages)
    stages.push_back({{"name", stage.name}, {"reason", stage.reason}, {"begin", stage.begin}});
  const Json json = {{"type", "trace"},
                     {"steps", played.steps.size()},
                     {"boxes", played.boxes.size()},
                     {"start_edges", played.start.size()},
                     {"stages", stages}};
  return encoded({json.dump(), bytes_of(played)});
}

// Algorithms with a parameter `trace` record their flips only if it is on.
Parameters with_trace(const Request& request) {
  std::map<std::string, std::string> values = request.parameters.all();
  for (const ParameterInfo& info : request.algorithm->parameters) {
    if (info.name == "trace") values["trace"] = "on";
  }
  return {request.algorithm->name, request.algorithm->parameters, values};
}

}  // namespace

void start_played_run(ProcessPool& pool, Request request, const Instance& instance, const RunLimits& limits,
                      std::function<void(RatedRun, std::string)> when_done) {
  // The process has its own copies; nothing here changes.
  ProofTrace proof;
  StepTrace steps;
  request.parameters = with_trace(request);
  if (request.algorithm->has_proofs) request.proof = &proof;
  if (request.algorithm->has_steps) request.steps = &steps;
  const auto enclose = [&](const Execution& execution) -> std::string {
    if (proof.is_complete) return trace_frame(played_proof(proof, steps, execution.solution, instance.set));
    const bool has_steps = !steps.kept.empty() || !steps.start.empty() || !steps.cells.empty();
    if (has_steps) return trace_frame(played_trace(steps, execution.solution, instance.set));
    if (!execution.solution.flips.empty()) return trace_frame(played_flips(execution.solution, instance.set));
    return "";
  };
  start_isolated_run_with(pool, request, instance, limits, {1e-9, false}, enclose, std::move(when_done));
}

}  // namespace mwt
