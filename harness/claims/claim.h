// A claim of the source report: its statement, by which rows of a study it is judged, and the rule of its verdict,
// fixed beforehand.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/records/results_folder.h"

namespace mwt {

enum class ClaimVerdict {
  reproduced,      ///< the source report's own figures came out
  holds,           ///< what it asserts was seen wherever it was looked for
  refuted,         ///< the records contradict it
  refuted_better,  ///< they contradict it, because the algorithm is better than claimed
  ill_posed,       ///< true or false according to something that the claim leaves open
  by_citation,     ///< no measurement can decide it; the literature does
  undecided,       ///< too few rows, or the intervals leave it open
};

/// "reproduced", "refuted (better than claimed)", ...
[[nodiscard]] std::string_view name_of(ClaimVerdict verdict);

using Runs = std::vector<const RunRecord*>;

/// The figures behind a verdict, as a table.
struct ClaimDetails {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// How a claim is judged by the records.
struct Finding {
  ClaimVerdict verdict = ClaimVerdict::undecided;
  std::string measured;  ///< one line with the figures
  std::string missing;   ///< if undecided: what would decide it; empty: any run to judge by
  Runs rows;             ///< the runs by which it was judged
  ClaimDetails details;  ///< may be empty
};

struct Claim {
  std::string id;         ///< C1 .. C15
  std::string statement;  ///< what the source report states
  std::string section;    ///< of the source report
  std::string data;       ///< which rows it is judged by, in words
  std::string rule;       ///< how the verdict follows from them
  std::string command;    ///< shell commands that show the matter by themselves
  /// Pure: the same records, the same finding. Records without anything to judge by give `undecided`.
  std::function<Finding(const StudyRecords&)> judge;
};

}  // namespace mwt
