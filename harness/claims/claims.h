// The verdicts on the source report's claims, computed from the records of a study alone.
#pragma once

#include <string>
#include <vector>

#include "harness/claims/claim.h"

namespace mwt {

/// The claims in the source report's order, one file of rules/ for each or for those that share a rule. To add
/// one: its function, its declaration in rules/rules.h and its line in claims.cpp.
[[nodiscard]] const std::vector<Claim>& claims_of_the_source_report();

struct JudgedClaim {
  const Claim* claim = nullptr;
  Finding finding;  ///< refers to the records it was made from
};

/// Deterministic. The result must not outlive `records`.
[[nodiscard]] std::vector<JudgedClaim> judge_claims(const StudyRecords& records);

/// The verdicts as text for a terminal; in one line the claims that no run of the study is about.
[[nodiscard]] std::string claims_text(const std::vector<JudgedClaim>& judged);

/// Writes into the results folder, replacing what was there (results/README.md has the columns): claims.csv, one row
/// per claim; claim_rows.csv, the ids of the runs that each was judged by; claim_details/ID.csv where there are any.
/// Throws InputError if it cannot.
void write_claims(const std::string& folder, const std::vector<JudgedClaim>& judged);

/// Removes what write_claims() writes, if it is there. Throws InputError if it cannot.
void remove_claims(const std::string& folder);

}  // namespace mwt
