// `mwt report --paper`: tables, figures and their data, ready to be included by a paper.
#pragma once

#include <string>

#include "harness/paper/paper_data.h"

namespace mwt {

/// Writes to the folder, which is made if need be:
///   tables/NAME.tex and .csv     quality, time
///   data/NAME.csv                what each figure shows; outcomes.csv, from which everything is computed
///   figures.tex                  a document with all tables and figures
///   README.md                    what is there, and the commands that repeat it
/// Figures are drawn from data/ by plots/draw_paper.py. What a study lacks (proved optima, several sizes) leaves out
/// the tables and figures made from it, also those that an earlier call wrote. `command` is the one that is repeated.
///
/// Returns the files written. Throws InputError: a file cannot be written; as select_for_paper().
[[nodiscard]] std::vector<std::string> write_paper(const ReportData& report, const PaperSelection& selection,
                                                   const std::string& folder, const std::string& command);

}  // namespace mwt
