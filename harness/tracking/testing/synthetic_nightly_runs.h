// For tests of tracking: records of nightly runs that never were, with known changes in them.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "generators/random.h"
#include "harness/records/results_folder.h"

namespace mwt::testing {

inline std::string synthetic_commit(int nightly_run) {
  std::string digits = std::to_string(nightly_run);
  return std::string(40 - digits.size(), 'c') + digits;
}

/// What is made worse in a run: called for every one.
using Tamper = std::function<void(int nightly_run, RunRecord&, RandomEngine&)>;

struct SyntheticStudy {
  std::vector<std::string> algorithms = {"delaunay", "exact", "flip", "greedy", "patch", "sweep"};
  std::vector<std::string> families = {"uniform", "clustered"};
  std::vector<Index> sizes = {100, 1000};
  std::vector<std::uint64_t> seeds = {1, 2};
  int repetitions = 3;
  double noise = 0.03;  ///< of times, relatively: of every cell on every night, and as much again of every run
  bool has_delaunay_time = true;
};

inline RunRecord synthetic_run(const SyntheticStudy& study, const std::string& algorithm, RandomEngine& engine) {
  RunRecord run;
  run.study = "synthetic";
  run.env_id = "abacus";
  run.algorithm = algorithm;
  run.status = RunStatus::ok;
  run.checker = "ok";
  run.wall_time_s = 0.001 * static_cast<double>(algorithm.size()) * std::exp(study.noise * standard_normal(engine));
  run.cpu_time_s = run.wall_time_s;
  run.iterations = 50;
  if (study.has_delaunay_time) run.delaunay_time_s = 0.002;
  run.peak_rss_bytes = 10'000'000 + 4096 * uniform_below(engine, 20);
  const double weight = 100 + static_cast<double>(algorithm.size());
  run.weight_lower = run.weight_upper = weight;
  run.optimum_lower = run.optimum_upper = 100;
  run.alpha_lower = run.alpha_upper = weight / 100;
  run.optimality = "proved";
  run.optimal = "no";
  run.stopped_early = false;
  return run;
}

inline std::vector<RunRecord> synthetic_runs(const SyntheticStudy& study, int nightly_run, std::uint64_t seed,
                                             const Tamper& tamper = {}) {
  RandomEngine engine = make_engine("synthetic", scatter_bits(seed) + static_cast<std::uint64_t>(nightly_run));
  std::vector<RunRecord> runs;
  for (const std::string& algorithm : study.algorithms) {
    for (const std::string& family : study.families) {
      for (const Index n : study.sizes) {
        for (const std::uint64_t instance_seed : study.seeds) {
          const double luck = std::exp(study.noise * standard_normal(engine));
          for (int repetition = 0; repetition < study.repetitions; ++repetition) {
            RunRecord run = synthetic_run(study, algorithm, engine);
            *run.wall_time_s *= luck;
            *run.cpu_time_s *= luck;
            run.generator = family;
            run.n = n;
            run.seed = instance_seed;
            run.instance_id = family + std::to_string(n) + '-' + std::to_string(instance_seed);
            run.repetition = repetition;
            run.git_commit = synthetic_commit(nightly_run);
            run.binary_sha256 = "binary" + std::to_string(nightly_run);
            char date[32];
            std::snprintf(date, sizeof date, "2026-%02d-%02dT03:00:00Z", 1 + nightly_run / 28, 1 + nightly_run % 28);
            run.recorded_at = date;
            if (tamper) tamper(nightly_run, run, engine);
            run.cpu_time_s = run.wall_time_s;  // nothing else runs on this machine
            runs.push_back(run);
          }
        }
      }
    }
  }
  return runs;
}

inline EnvironmentRecord synthetic_environment(const std::string& cpu = "Abacus 2000") {
  EnvironmentRecord environment;
  environment.env_id = "abacus";
  environment.study = "synthetic";
  environment.cpu_model = cpu;
  environment.logical_cpus = 2;
  environment.memory_bytes = std::uint64_t{8} << 30;
  return environment;
}

inline void write_synthetic_nightly_run(const std::string& folder, const std::vector<RunRecord>& runs,
                                        const EnvironmentRecord& environment = synthetic_environment()) {
  write_records(folder, {"name = \"synthetic\"\n", runs, {}, {environment}});
}

}  // namespace mwt::testing
