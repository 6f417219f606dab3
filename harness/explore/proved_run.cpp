#include "harness/explore/proved_run.h"

#include <utility>

#include "algorithms/proof_trace.h"
#include "harness/io/input_file.h"
#include "harness/io/proof_file.h"
#include "harness/io/temporary_folder.h"

namespace mwt {

void start_proved_run(ProcessPool& pool, Request request, const Instance& instance, const RunLimits& limits,
                      std::function<void(RatedRun, std::string)> when_done) {
  ProofTrace proof;  // filled in the process, which has a copy
  request.proof = &proof;
  const auto enclose = [&](const Execution& execution) -> std::string {
    const Solution& solution = execution.solution;
    if (!proof.is_complete || !solution.optimum) return "";
    const TemporaryFolder folder("mwt-explore");
    const std::string path = folder.file("points.mwtproof");
    static_cast<void>(write_proof(path, instance.set.points, proof, solution.triangulation, *solution.optimum));
    return read_file(path);
  };
  start_isolated_run_with(pool, request, instance, limits, {1e-9, false}, enclose, std::move(when_done));
}

}  // namespace mwt
