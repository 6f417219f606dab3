#include "harness/claims/claims.h"

#include <cctype>
#include <filesystem>

#include "base/error.h"
#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/output_file.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

std::string evidence_text(const JudgedClaim& judged) {
  if (judged.finding.rows.empty()) return judged.claim->data;
  const std::size_t runs = judged.finding.rows.size();
  return grouped(runs) + (runs == 1 ? " run: " : " runs: ") + judged.claim->data;
}

void write_table(const fs::path& path, const CsvRow& header, const std::vector<CsvRow>& rows) {
  write_file_atomically(path.string(), [&](OutputFile& file) {
    file.append(csv_line(header));
    for (const CsvRow& row : rows) file.append(csv_line(row));
  });
}

// Starts anew: details of a claim that has none any more must not stay.
fs::path empty_details_folder(const std::string& folder) {
  const fs::path details = fs::path(folder) / "claim_details";
  std::error_code error;
  fs::remove_all(details, error);
  fs::create_directory(details, error);
  if (error) throw InputError(details.string() + ": cannot be made: " + error.message());
  return details;
}

std::string wrapped(const std::string& text, std::size_t width, const std::string& indent) {
  std::string result = indent;
  std::size_t column = indent.size();
  for (const std::string& word : split(text, ' ')) {
    if (column + word.size() > width && column > indent.size()) {
      result.back() = '\n';
      result += indent;
      column = indent.size();
    }
    result += word + ' ';
    column += word.size() + 1;
  }
  result.back() = '\n';
  return result;
}

std::string claim_text(const JudgedClaim& judged) {
  constexpr std::size_t kWidth = 110;
  const auto& [claim, finding] = judged;
  std::string text = claim->id + std::string(5 - claim->id.size(), ' ');
  for (const char c : name_of(finding.verdict)) {
    text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text + '\n' + wrapped(claim->statement + " (section " + claim->section + ")", kWidth, "     ") +
         wrapped("-> " + finding.measured, kWidth, "     ");
}

void say_what_is_missing(JudgedClaim& judged) {
  auto& [claim, finding] = judged;
  const std::string missing = finding.missing.empty() ? "no finished run of: " + claim->data : finding.missing;
  finding.measured += (finding.measured.empty() ? "undecided: " : "; undecided: ") + missing;
}

}  // namespace

std::string_view name_of(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::reproduced: return "reproduced";
    case ClaimVerdict::holds: return "holds";
    case ClaimVerdict::refuted: return "refuted";
    case ClaimVerdict::refuted_better: return "refuted (better than claimed)";
    case ClaimVerdict::ill_posed: return "ill-posed";
    case ClaimVerdict::by_citation: return "by citation";
    case ClaimVerdict::undecided: break;
  }
  return "undecided";
}

const std::vector<Claim>& claims_of_the_source_report() {
  static const std::vector<Claim> all = {
      claims::greedy_example(),        claims::insertion_example(),
      claims::triangle_count(),        claims::greedy_alpha(),
      claims::greedy_linear_bound(),   claims::insertion_logarithmic(),
      claims::hull_lower_bound(),      claims::insertion_step(),
      claims::local_search_example(),  claims::local_search_probability(),
      claims::triangulation_numbers(), claims::running_times(),
      claims::quadtree_alpha(),        claims::np_hardness(),
      claims::triangulation_growth(),
  };
  return all;
}

std::vector<JudgedClaim> judge_claims(const StudyRecords& records) {
  std::vector<JudgedClaim> judged;
  for (const Claim& claim : claims_of_the_source_report()) judged.push_back({&claim, claim.judge(records)});
  for (JudgedClaim& result : judged) {
    if (result.finding.verdict == ClaimVerdict::undecided) say_what_is_missing(result);
  }
  return judged;
}

std::string claims_text(const std::vector<JudgedClaim>& judged) {
  std::string text = "the source report's claims\n";
  std::vector<std::string> not_judged;
  for (const JudgedClaim& result : judged) {
    const bool is_about = !result.finding.rows.empty() || result.finding.verdict != ClaimVerdict::undecided;
    if (is_about) {
      text += claim_text(result);
    } else {
      not_judged.push_back(result.claim->id);
    }
  }
  if (!not_judged.empty()) text += "no run of this study is about " + joined(not_judged) + '\n';
  return text;
}

void write_claims(const std::string& folder, const std::vector<JudgedClaim>& judged) {
  const fs::path details = empty_details_folder(folder);
  std::vector<CsvRow> claims, rows;
  for (const JudgedClaim& result : judged) {
    const auto& [claim, finding] = result;
    claims.push_back({claim->id, claim->statement, claim->section, finding.measured, evidence_text(result),
                      std::string(name_of(finding.verdict)), claim->rule, claim->command});
    for (const RunRecord* run : finding.rows) rows.push_back({claim->id, run->run_id});
    if (!finding.details.rows.empty()) {
      write_table(details / (claim->id + ".csv"), finding.details.header, finding.details.rows);
    }
  }
  write_table(fs::path(folder) / "claim_rows.csv", {"claim", "run_id"}, rows);
  write_table(fs::path(folder) / "claims.csv",
              {"claim", "statement", "section", "measured", "evidence", "verdict", "rule", "command"}, claims);
}

void remove_claims(const std::string& folder) {
  for (const char* name : {"claims.csv", "claim_rows.csv", "claim_details"}) {
    std::error_code error;
    fs::remove_all(fs::path(folder) / name, error);
    if (error) throw InputError((fs::path(folder) / name).string() + ": cannot be removed: " + error.message());
  }
}

}  // namespace mwt
