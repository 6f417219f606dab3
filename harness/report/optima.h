// What is proved of a study's optima, and how many of the proofs the verifier accepts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/records/results_folder.h"

namespace mwt {

/// The instances of one family and size.
struct OptimumCell {
  std::string generator;
  std::string generator_params;
  Index n = 0;
  std::size_t instances = 0;
  std::size_t proved = 0;
  std::size_t without_bounds = 0;
  double widest = 0;  ///< largest relative width of a certified interval that proves no optimum
  std::map<ProofVerdict, std::size_t> verdicts;
  std::optional<double> time_s;                 ///< of the instance that took longest
  std::optional<std::uint64_t> peak_rss_bytes;  ///< of the instance that took most

  [[nodiscard]] std::size_t count(ProofVerdict verdict) const;
};

/// Families with runs, in the order of their first instance, sizes ascending. An instance's bounds are the best in the
/// records, whose runs are rated_by_all_bounds(); its time and memory are those of the fastest run that certifies the
/// best lower bound alone; without one, its time is that of the study's search for its optimum, unless that was cached.
[[nodiscard]] std::vector<OptimumCell> optima_of(const StudyRecords& records);

/// "optima: 8 of 9 instances proved; mwt_verify verifies 7 of them, and bounds of 0 others; it refuses 0 proofs and has
/// no verdict on 0". Without proofs only the first part.
[[nodiscard]] std::string optimum_summary(const std::vector<OptimumCell>& optima);

/// One line per n: instances, how many optima are proved, the widest interval of the others, and, if any proofs were
/// asked for, what the verifier says of them. Empty without instances.
[[nodiscard]] std::string optimum_table(const std::vector<OptimumCell>& optima);

/// One line per proof that the verifier refuses or has no verdict on: its instance and why. Empty if there is none.
[[nodiscard]] std::string rejected_proof_table(const std::vector<InstanceRecord>& instances);

}  // namespace mwt
