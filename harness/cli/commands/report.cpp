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

namespace mwt {

namespace {

struct ReportArguments {
  std::string folder;
  std::optional<std::string> tables;
  std::optional<std::string> paper;
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
  selection.families = names_of(options.families);
  selection.algorithms = names_of(options.algorithms);
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
  if (options.families) command += " --families " + quoted(*options.families);
  if (options.sizes) command += " --sizes " + quoted(*options.sizes);
  if (options.algorithms) command += " --algorithms " + quoted(*options.algorithms);
  return command;
}

void require_paper(const ReportArguments& options) {
  if (options.paper && options.tables) throw InputError("--paper prints no tables; give either it or --tables");
  if (options.paper) return;
  for (const auto& [name, value] : {std::pair("--families", &options.families), std::pair("--sizes", &options.sizes),
                                    std::pair("--algorithms", &options.algorithms)}) {
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
  const std::string missing = draw_paper_figures(*options.paper);
  if (!missing.empty()) std::cerr << "mwt: warning: " << missing << '\n';
  return kExitOk;
}

// The tables must not take the place of what they are made of, or of what is written beside them.
void require_usable_output(const ReportArguments& options) {
  if (!options.tables) return;
  std::vector<std::string> files;
  for (const char* name : {"runs.csv", "instances.csv", "environments.csv", "study.toml", "summary.csv",
                           "exponents.csv", "claims.csv", "claim_rows.csv"}) {
    files.push_back((std::filesystem::path(options.folder) / name).string());
  }
  const OutputOption output{"--tables", *options.tables};
  require_usable_outputs({&output, 1}, files);
}

int report(const ReportArguments& options) {
  require_paper(options);
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
  return kExitOk;
}

}  // namespace

Command report_command() {
  const auto options = std::make_shared<ReportArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("folder", options->folder, kFolder, "results folder of a study (mwt run)");
    declared.option("--tables", options->tables, kFile,
                    "write the tables to this file instead of printing them (often thousands of lines)");
    declared.option("--paper", options->paper, kFolder,
                    "write LaTeX tables, figures (PDF, PGF), their data and a document of them to this folder instead");
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
