#include "harness/report/report.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/io/output_file.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_lines.h"
#include "harness/paper/paper.h"
#include "harness/report/drawing.h"
#include "harness/report/side_by_side.h"
#include "harness/study/study.h"

namespace mwt {

namespace {

constexpr const char* kPageNeeds = "python3-pandas, python3-matplotlib and python3-jinja2";

struct ReportArguments {
  std::string folder;
  std::optional<std::string> tables;
  bool page = false;
  std::optional<std::string> paper;
  std::optional<std::string> compare;
  std::optional<std::string> out;
  std::optional<std::string> choice;
  std::optional<std::string> families;
  std::optional<std::string> sizes;
  std::optional<std::string> algorithms;
};

std::vector<std::string> names_of(const std::optional<std::string>& list) {
  std::vector<std::string> names;
  for (const std::string& part : split(list.value_or(""), ',')) {
    const std::string_view name = trimmed(part);
    if (!name.empty()) names.emplace_back(name);
  }
  return names;
}

PaperSelection selection_of(const ReportArguments& options) {
  PaperSelection selection;
  if (options.choice) {
    const ResultChoice choice = read_result_choice(*options.choice);
    selection = {choice.families, choice.sizes, choice.algorithms};
  }
  if (options.families) selection.families = names_of(options.families);
  if (options.algorithms) selection.algorithms = names_of(options.algorithms);
  if (options.sizes) selection.sizes.clear();
  for (const std::string& text : names_of(options.sizes)) {
    const std::optional<Index> n = parse_whole_number<Index>(text);
    if (!n) throw InputError("--sizes: " + shown(text) + " is no number of points; give numbers such as 100,1000");
    selection.sizes.push_back(*n);
  }
  return selection;
}

// The command that repeats this one, fit for a shell.
std::string repeating_command(const ReportArguments& options) {
  const auto quoted = [](const std::string& text) {
    const bool is_plain =
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+.,/=:@%") ==
        std::string::npos;
    if (is_plain && !text.empty()) return text;
    std::string text_in_quotes = "'";
    text_in_quotes += joined(split(text, '\''), "'\\''");
    return text_in_quotes += '\'';
  };
  std::string command = "mwt report " + quoted(options.folder) + " --paper " + quoted(*options.paper);
  if (options.choice) command += " --choice " + quoted(*options.choice);
  if (options.families) command += " --families " + quoted(*options.families);
  if (options.sizes) command += " --sizes " + quoted(*options.sizes);
  if (options.algorithms) command += " --algorithms " + quoted(*options.algorithms);
  return command;
}

// Each option belongs to one kind of report; elsewhere it would do nothing.
void require_one_kind(const ReportArguments& options) {
  if (options.compare && (options.paper || options.tables || options.page))
    throw InputError("--compare prints two studies side by side; give it without --paper, --tables and --page");
  if (options.paper && options.page) throw InputError("--paper makes no page; give either it or --page");
  if (options.out && !options.compare) throw InputError("--out FOLDER is for the page of --compare FOLDER; give both");
  if (options.paper && options.tables) throw InputError("--paper prints no tables; give either it or --tables");
  if (options.paper) return;
  for (const auto& [name, value] :
       {std::pair("--choice", &options.choice), std::pair("--families", &options.families),
        std::pair("--sizes", &options.sizes), std::pair("--algorithms", &options.algorithms)}) {
    if (*value) throw InputError(std::string(name) + " chooses what --paper FOLDER shows; give both");
  }
}

int report_paper(const ReportArguments& options) {
  const PaperSelection selection = selection_of(options);
  const ReportData data = read_report_data(options.folder);
  for (const std::string& warning : data.records.warnings) std::cerr << "mwt: warning: " << warning << '\n';
  for (const std::string& warning : data.warnings) std::cerr << "mwt: warning: " << warning << '\n';
  for (const std::string& file : write_paper(data, selection, *options.paper, repeating_command(options)))
    std::cout << "written: " << file << '\n';
  std::cout.flush();
  const std::string missing =
      draw_by_script("draw_paper.py", {*options.paper},
                     "python3-pandas, python3-matplotlib and, for PGF, texlive-latex-base and texlive-pictures");
  if (!missing.empty()) std::cerr << "mwt: warning: " << missing << '\n';
  return kExitOk;
}

// Two studies side by side: as text and, with --out, as files and a page.
int report_comparison(const ReportArguments& options) {
  const ReportData a = read_report_data(options.folder);
  const ReportData b = read_report_data(*options.compare);
  for (const auto& [data, name] : {std::pair(&a, "A"), std::pair(&b, "B")}) {
    for (const std::string& warning : data->records.warnings)
      std::cerr << "mwt: warning: " << name << ": " << warning << '\n';
  }
  const SideBySide both = side_by_side(a, b);
  std::cout << side_by_side_text(both);
  if (!options.out) return kExitOk;
  const std::filesystem::path folder = *options.out;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(*options.out + ": cannot be made (" + error.message() + "); choose another folder");
  write_file_atomically((folder / "cells.csv").string(), side_by_side_cells_csv(both));
  write_file_atomically((folder / "plan.csv").string(), side_by_side_plan_csv(both));
  std::cout << "written: " << (folder / "cells.csv").string() << ", plan.csv" << std::endl;
  const std::string missing = draw_by_script("make_comparison.py", {*options.out}, kPageNeeds);
  if (!missing.empty()) std::cerr << "mwt: warning: " << missing << '\n';
  return kExitOk;
}

// The tables must not take the place of what they are made of, or of what is written beside them.
void require_usable_output(const ReportArguments& options) {
  if (!options.tables) return;
  std::vector<std::string> files;
  for (const char* name :
       {"runs.csv", "instances.csv", "environments.csv", "study.toml", "summary.csv", "observations.csv",
        "exponents.csv", "optima.csv", "ratings.csv", "claims.csv", "claim_rows.csv"}) {
    files.push_back((std::filesystem::path(options.folder) / name).string());
  }
  const OutputOption output{"--tables", *options.tables};
  require_usable_outputs({&output, 1}, files);
}

// The page, and what its gallery draws: the study's algorithms on the same points. Scripts print what they write.
void make_page(const std::string& folder) {
  std::cout.flush();
  for (const std::string& missing : {draw_by_script("gallery.sh", {own_path(), folder}, kPageNeeds),
                                     draw_by_script("make_page.py", {folder}, kPageNeeds)}) {
    if (!missing.empty()) std::cerr << "mwt: warning: " << missing << '\n';
  }
}

int report(const ReportArguments& options) {
  require_one_kind(options);
  if (options.compare) return report_comparison(options);
  if (options.paper) return report_paper(options);
  require_usable_output(options);
  const ReportData data = read_report_data(options.folder);
  for (const std::string& warning : data.records.warnings) std::cerr << "mwt: warning: " << warning << '\n';
  std::ostringstream tables;
  for (const ReportPart& part : report_tables()) part(data, tables);
  write_file_atomically(options.tables.value_or("-"), tables.str());
  const bool is_file = options.tables && !is_standard_output(*options.tables);
  if (is_file) std::cout << "written: " << *options.tables << '\n';
  for (const ReportPart& part : report_results()) part(data, std::cout);
  if (options.page) make_page(options.folder);
  return kExitOk;
}

}  // namespace

Command report_command() {
  const auto options = std::make_shared<ReportArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("folder", options->folder, kFolder, "results folder of a study (mwt run)");
    declared.option("--tables", options->tables, kFile,
                    "write the tables to this file instead of printing them (often thousands of lines)");
    declared.flag("--page", options->page,
                  "also make the page, FOLDER/report.html: figures, gallery, tables, a figure explorer");
    declared.option("--paper", options->paper, kFolder,
                    "write LaTeX tables, figures (PDF, PGF), their data and a document of them to this folder instead");
    declared.option("--compare", options->compare, kFolder,
                    "print the cells of this study beside those of the first, with ratios, and what differs in plan");
    declared.option("--out", options->out, kFolder, "write the comparison to this folder, too: CSV and a page");
    declared.option(
        "--choice", options->choice, kFile,
        "TOML file with lists of families, sizes and algorithms for --paper; the next options replace a list");
    declared.option("--families", options->families, ValueKind{"NAMES"}, "families of --paper, separated by commas");
    declared.option("--sizes", options->sizes, ValueKind{"NUMBERS"},
                    "numbers of points of --paper, separated by commas");
    declared.option("--algorithms", options->algorithms, ValueKind{"NAMES"},
                    "algorithms of --paper, separated by commas: names, or labels such as 'patch k=14'");
  };
  return {"report", "Print tables of time, alpha and growth from the records of a study, and write them as CSV",
          declare, [options] { return report(*options); }};
}

}  // namespace mwt
