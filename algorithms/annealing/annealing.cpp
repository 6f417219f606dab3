#include "algorithms/annealing/annealing.h"

#include <fmt/core.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>

#include "algorithms/common/start.h"
#include "algorithms/flip/flip.h"
#include "algorithms/step_trace.h"
#include "base/error.h"
#include "geometry/mesh/distance.h"
#include "geometry/numbers/scaling.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

double mean_edge_length(const PlanarMesh& mesh) {
  double sum = 0;
  const auto count = static_cast<double>(mesh.edge_count());
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    sum += rounded_distance(mesh.point(mesh.origin(2 * e)), mesh.point(mesh.target(2 * e))) / count;
  }
  return sum;
}

double change_by_flip(const PlanarMesh& mesh, MeshEdge e) {
  const Halfedge h = 2 * e;
  return rounded_distance(mesh.point(mesh.apex(h)), mesh.point(mesh.apex(h + 1))) -
         rounded_distance(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)));
}

void flip_and_note(PlanarMesh& mesh, MeshEdge e, double change, StepTrace& steps) {
  const Edge removed = mesh.labelled_edge(e);
  mesh.flip(e);
  steps.flips.push_back({removed, mesh.labelled_edge(e), -change * mesh.unit()});
}

AnnealingOptions options_of(const Parameters& parameters, const PlanarMesh& mesh, std::uint64_t seed) {
  const std::int64_t proposals = parameters.integer("proposals");
  const double initial = parameters.real("initial_temperature"), final = parameters.real("final_temperature");
  if (proposals < 0) throw InputError(fmt::format("annealing: proposals={} is negative", proposals));
  if (!(final > 0 && initial >= final)) {
    throw InputError("annealing: temperatures must satisfy 0 < final_temperature <= initial_temperature");
  }
  constexpr std::uint64_t kProposalsPerPoint = 300;
  const double unit = mean_edge_length(mesh);
  return {proposals > 0 ? static_cast<std::uint64_t>(proposals) : kProposalsPerPoint * mesh.point_count(),
          initial * unit, final * unit, seed};
}

Solution run_annealing(Points points, Context& context) {
  const auto start = [&] {
    const ScopedPhase phase(context, "start");
    return start_mesh(points, context);
  };
  PlanarMesh mesh = start();
  const ScopedPhase phase(context, "annealing");
  const Triangulation before = mesh.triangulation();
  StepTrace* const steps = context.steps;
  if (steps != nullptr) steps->start = before.triangles;
  const AnnealingOptions options = options_of(context.parameters, mesh, context.seed);
  const AnnealingResult result = anneal(mesh, options, context);
  const FlipResult flips = flip_to_local_optimum(mesh, FlipOrder::stack, context, steps != nullptr);
  if (steps != nullptr) {
    steps->annealed = steps->flips.size();
    steps->flips.insert(steps->flips.end(), flips.trace.begin(), flips.trace.end());
  }
  Solution solution;
  solution.triangulation = mesh.triangulation();
  const std::vector<Point> scaled = exactly_scaled(points);  // whose lengths keep their digits
  if (weight(scaled, solution.triangulation).upper > weight(scaled, before).upper) solution.triangulation = before;
  solution.counters = {{"proposals", static_cast<double>(options.proposals)},
                       {"accepted", static_cast<double>(result.accepted)},
                       {"flips", static_cast<double>(flips.flips)}};
  solution.stop_reason = deadline_if(result.stopped_early || flips.stopped_early);
  return solution;
}

}  // namespace

AnnealingResult anneal(PlanarMesh& mesh, const AnnealingOptions& options, const Context& context) {
  boost::random::mt19937_64 random(options.seed);
  boost::random::uniform_01<double> unit;
  const boost::random::uniform_int_distribution<MeshEdge> any_edge(0, static_cast<MeshEdge>(mesh.edge_count() - 1));
  constexpr std::uint64_t kStep = 4096;  // proposals at one temperature
  const double cooling = std::pow(options.final_temperature / options.initial_temperature,
                                  static_cast<double>(kStep) / static_cast<double>(options.proposals));
  double temperature = options.initial_temperature;
  AnnealingResult result;
  for (std::uint64_t i = 0; i < options.proposals; ++i) {
    if (i % kStep == kStep - 1) {
      temperature *= cooling;
      if (context.deadline_passed()) {
        result.stopped_early = true;
        break;
      }
    }
    const MeshEdge e = any_edge(random);
    if (mesh.is_hull(e)) continue;
    const double change = change_by_flip(mesh, e);
    if (change > 0 && unit(random) >= std::exp(-change / temperature)) continue;
    if (!mesh.is_flippable(e)) continue;
    if (context.steps == nullptr) {
      mesh.flip(e);
    } else {
      flip_and_note(mesh, e, change, *context.steps);
    }
    ++result.accepted;
  }
  return result;
}

AlgorithmInfo annealing_entry() {
  AlgorithmInfo info;
  info.name = "annealing";
  info.summary = "simulated annealing over edge flips, then flips to a local optimum";
  info.source =
      "S. Kirkpatrick, C. D. Gelatt, M. P. Vecchi, Optimization by simulated annealing, Science 220 (1983); over "
      "flips: "
      "the baseline customary for this problem";
  info.guarantee = "none known; never worse than its start";
  info.time = "O(1) per proposal";
  info.space = "O(n)";
  info.max_n = 1'000'000;
  info.version = 2;
  info.has_steps = true;
  info.parameters = {
      {"proposals", ParameterType::integer, "0", "flips proposed; 0: 300 per point"},
      {"initial_temperature", ParameterType::real, "0.1", "in mean edge lengths of the start"},
      {"final_temperature", ParameterType::real, "0.001", "in mean edge lengths of the start"},
      start_parameter("delaunay"),
  };
  info.function = run_annealing;
  return info;
}

}  // namespace mwt
