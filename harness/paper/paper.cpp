#include "harness/paper/paper.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/error.h"
#include "harness/io/output_file.h"
#include "harness/io/text/text.h"
#include "harness/paper/paper_tables.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFamilies = 3;  // blocks of the tables, unless the user chooses

// Families with instances to compare: those chosen, or those with most such instances.
std::vector<std::string> families_of(const PaperData& data, const PaperSelection& selection) {
  const PaperMeasure measure = data.common(PaperMeasure::gap).empty() ? PaperMeasure::time : PaperMeasure::gap;
  std::vector<std::string> families;
  std::map<std::string, std::size_t> counts;
  for (const std::size_t i : data.common(measure)) {
    if (counts[data.instances[i].family]++ == 0) families.push_back(data.instances[i].family);
  }
  std::ranges::stable_sort(families, std::greater{}, [&](const std::string& family) { return counts[family]; });
  if (selection.families.empty() && families.size() > kMostFamilies) families.resize(kMostFamilies);
  return families;
}

// A figure: the data it needs, and what figures.tex says of it.
struct PaperFigure {
  std::string name;
  std::vector<std::string> data;  // names of CSV files, of which at least the first must have rows
  std::string caption;            // LaTeX
};

std::string instances_text(const PaperData& data) {
  return fmt::format("the {} instances (for the gap: {}, with a proved optimum) on which all algorithms were run",
                     data.common(PaperMeasure::time).size(), data.common(PaperMeasure::gap).size());
}

std::vector<PaperFigure> figures_of(const PaperData& data) {
  return {
      {"profiles",
       {"profile_time", "profile_gap"},
       "Performance profiles (Dolan and Mor\\'e) over " + instances_text(data) +
           ": the share of instances on which the algorithm is within the given excess over the lightest "
           "triangulation, "
           "or within the given factor of the shortest time. A failure never counts."},
      {"distributions",
       {"distribution_time", "distribution_gap"},
       "Empirical distributions of the gap to the proved optimum and of the time per point, over the same instances. "
       "Curves of the gap begin at the share of optimal triangulations."},
      {"trade_off",
       {"trade_off"},
       "Mean gap against median time over the instances of equal $n$, with 95\\,\\% intervals (bootstrap). The line "
       "joins "
       "the algorithms that no other one beats in both."},
      {"growth",
       {"growth_points", "growth_lines"},
       "Growth of time and of $\\alpha$ with $n$: medians of time and means of $\\alpha$, and the power laws fitted to "
       "the observations of all sizes of the study, with 95\\,\\% bands (bootstrap) and their exponents. Dashed, with "
       "$\\sim$: a power law does not fit (F test of lack of fit, 1\\,\\%). Of $\\alpha$ only what has an exponent of "
       "at "
       "least 0.02."},
      {"pairs",
       {"pairs_time", "pairs_gap"},
       "Wilcoxon's signed-rank test of all pairs on the same instances, two-sided, zeros as Pratt has them: the "
       "matched-pairs rank-biserial correlation, $+1$ where the row is always better than the column and $-1$ where it "
       "is "
       "always "
       "worse. Bold with a star: significant at 5\\,\\% after Holm's correction for all pairs of the matrix. Gaps "
       "whose "
       "certified intervals overlap are equal; times are compared by their logarithms."},
      {"ranks",
       {"ranks_time", "ranks_gap", "rank_groups_time", "rank_groups_gap"},
       "Critical-difference diagrams: mean ranks over the same instances, 1 for the best. Bars join algorithms whose "
       "mean "
       "ranks differ by less than Nemenyi's critical difference (CD) at 5\\,\\%; $p$ is that of Friedman's test."},
  };
}

// Writes the files of one call, and remembers them.
class Writer {
 public:
  explicit Writer(std::string folder) : folder_(std::move(folder)) {
    for (const char* part : {"", "tables", "data", "figures"}) {
      std::error_code error;
      fs::create_directories(fs::path(folder_) / part, error);
      if (error) throw InputError((fs::path(folder_) / part).string() + ": cannot be made: " + error.message());
    }
  }

  void write(const std::string& name, const std::string& content) {
    const std::string path = (fs::path(folder_) / name).string();
    write_file_atomically(path, content);
    written_.push_back(path);
  }

  void remove(const std::string& name) const {
    std::error_code ignored;
    fs::remove(fs::path(folder_) / name, ignored);
  }

  [[nodiscard]] const std::vector<std::string>& written() const { return written_; }

 private:
  std::string folder_;
  std::vector<std::string> written_;
};

std::map<std::string, CsvRows> data_of_figures(const ReportData& report, const PaperData& data,
                                               const std::vector<std::string>& families) {
  std::map<std::string, CsvRows> all = {{"trade_off", trade_off_rows(data)},
                                        {"growth_points", growth_point_rows(report, data, families)},
                                        {"growth_lines", growth_line_rows(report, data, families)}};
  for (const PaperMeasure measure : {PaperMeasure::time, PaperMeasure::gap}) {
    if (data.common(measure).empty()) continue;
    all["profile_" + name_of(measure)] = profile_rows(data, measure);
    all["distribution_" + name_of(measure)] = distribution_rows(data, measure);
    all["pairs_" + name_of(measure)] = pair_rows(data, measure);
    all["ranks_" + name_of(measure)] = rank_rows(data, measure);
    all["rank_groups_" + name_of(measure)] = rank_group_rows(data, measure);
  }
  return all;
}

bool has_rows(const std::map<std::string, CsvRows>& all, const std::string& name) {
  const auto found = all.find(name);
  return found != all.end() && found->second.size() > 1;
}

constexpr const char* kPreamble = R"(\documentclass[a4paper,10pt]{article}
\usepackage[utf8]{inputenc}
\usepackage[margin=1.9cm,top=1.2cm,bottom=1.5cm,footskip=0.7cm]{geometry}
\usepackage{booktabs,graphicx,pgf}
% A figure as PGF, in the fonts of this document; without it as PDF.
\newcommand{\mwtfigure}[1]{\IfFileExists{figures/#1.pgf}{\input{figures/#1.pgf}}{%
  \IfFileExists{figures/#1.pdf}{\includegraphics{figures/#1.pdf}}{\fbox{figures/#1 is not drawn, see README.md}}}}
\renewcommand{\topfraction}{0.95}\renewcommand{\bottomfraction}{0.95}\renewcommand{\floatpagefraction}{0.8}
\renewcommand{\textfraction}{0.02}\setcounter{topnumber}{6}\setcounter{bottomnumber}{6}\setcounter{totalnumber}{9}
\setlength{\intextsep}{5pt}
\setlength{\textfloatsep}{5pt}\setlength{\floatsep}{5pt}\setlength{\abovecaptionskip}{3pt}\setlength{\belowcaptionskip}{2pt}
\makeatletter
\setlength{\@fptop}{0pt}\setlength{\@fpsep}{8pt plus 1fil}
\renewcommand{\@makecaption}[2]{\vskip\abovecaptionskip{\footnotesize #1: #2\par}\vskip\belowcaptionskip}
\makeatother
\pagestyle{plain}
\begin{document}
)";

std::string table_environment(const std::string& name, const std::string& caption) {
  return fmt::format(
      "\\begin{{table}}[!htbp]\n\\centering\\scriptsize\n\\caption{{{}}}\n\\input{{tables/{}}}\n\\end{{table}}\n\n",
      caption, name);
}

std::string figure_environment(const PaperFigure& figure) {
  return fmt::format("\\begin{{figure}}[!htbp]\n\\centering\n\\mwtfigure{{{}}}\n\\caption{{{}}}\n\\end{{figure}}\n\n",
                     figure.name, figure.caption);
}

std::string quality_caption(const PaperData& data) {
  return "Gap $\\alpha-1$ to the proved optimum in percent, over the instances on which all algorithms were run; mean "
         "with 95\\,\\% interval (bootstrap), median, 95\\,\\% quantile, maximum, and the number of optimal "
         "triangulations. "
         "Bold: significantly better than each other algorithm on the block's instances (signed-rank tests, Holm's "
         "correction for all pairs of all blocks, 5\\,\\%)." +
         (data.left_out.empty() ? ""
                                : fmt::format(" Left out: {} further algorithms or variants.", data.left_out.size()));
}

struct OptionalTables {
  bool quality = false;
  bool growth = false;
};

std::string document(const PaperData& data, const std::vector<PaperFigure>& figures, OptionalTables has,
                     const std::string& command) {
  std::string text = "% Made by: " + one_line(command) + "\n" + kPreamble;
  text += "\\noindent\\textbf{Study \\emph{" + latex_text(data.study) + "}}\n\n";
  if (has.quality) text += table_environment("quality", quality_caption(data));
  text +=
      table_environment("time",
                        "Median time of the algorithm alone in ms, with its 95\\,\\% interval (bootstrap). Bold: "
                        "significantly faster than each other algorithm, by the same tests of all pairs and cells.");
  if (has.growth)
    text +=
        table_environment("growth",
                          "Exponents of power laws in $n$, fitted to the observations of all sizes of the study, with "
                          "95\\,\\% intervals (bootstrap) and the explained share $R^2$ of the variance of the "
                          "logarithms. $\\sim$: the F test of lack of fit rejects a power law at 1\\,\\%, and the "
                          "exponent is a mean slope.");
  for (const PaperFigure& figure : figures) text += figure_environment(figure);
  return text + "\\end{document}\n";
}

std::string readme(const ReportData& report, const PaperData& data, const std::vector<PaperFigure>& figures,
                   const std::string& command) {
  const RunRecord& run = report.records.runs.front();
  std::string text = fmt::format(
      "# Tables and figures of the study `{}`\n\n"
      "All of it, again:\n\n```\n{}\n```\n\n"
      "The figures alone, from `data/`: `plots/draw_paper.py OUT [--only NAME,...]`. The document: `pdflatex "
      "figures.tex`, here.\n\n"
      "- Records: `{}`, written by mwt of commit {}. The study file is `study.toml` there; `mwt run study.toml` runs "
      "it again.\n"
      "- Algorithms: {}. Left out (run on other instances, or not chosen): {}.\n"
      "- `data/outcomes.csv` has every outcome. `in_gap` and `in_time` mark the instances on which all algorithms were "
      "run; everything but\n"
      "  the growth is computed from these, by `mwt`; `plots/` only draws.\n\n"
      "| figure | data |\n|---|---|\n",
      data.study, command, report.folder, run.git_commit, joined(data.algorithms),
      data.left_out.empty() ? "none" : joined(data.left_out));
  for (const PaperFigure& figure : figures) {
    std::vector<std::string> files;
    for (const std::string& name : figure.data) files.push_back("`data/" + name + ".csv`");
    text += fmt::format("| `figures/{}` | {} |\n", figure.name, joined(files));
  }
  return text;
}

void remove_table(const Writer& writer, const std::string& name) {
  for (const char* ending : {".csv", ".tex"}) writer.remove("tables/" + name + ending);
}

void write_table(Writer& writer, const std::string& name, const PaperTable& table, const std::string& command) {
  writer.write("tables/" + name + ".csv", csv_text(table.csv));
  writer.write("tables/" + name + ".tex", table.latex.text({"Made by: " + command, "Data: tables/" + name + ".csv"}));
}

}  // namespace

std::vector<std::string> write_paper(const ReportData& report, const PaperSelection& selection,
                                     const std::string& folder, const std::string& command) {
  const PaperData data = select_for_paper(report, selection);
  const std::vector<std::string> families = families_of(data, selection);
  const bool has_quality = !data.common(PaperMeasure::gap).empty();
  Writer writer(folder);
  const PaperTable growth = growth_table(report, data, families);
  const bool has_growth = !growth.latex.rows.empty();
  if (has_quality)
    write_table(writer, "quality", quality_table(data, families), command);
  else
    remove_table(writer, "quality");
  write_table(writer, "time", time_table(report, data, families), command);
  if (has_growth)
    write_table(writer, "growth", growth, command);
  else
    remove_table(writer, "growth");

  std::map<std::string, CsvRows> of_figures = data_of_figures(report, data, families);
  std::vector<PaperFigure> figures;
  for (PaperFigure& figure : figures_of(data)) {
    const std::vector<std::string> all_names = figure.data;
    std::erase_if(figure.data, [&](const std::string& name) { return !has_rows(of_figures, name); });
    for (const std::string& name : all_names) {
      if (has_rows(of_figures, name))
        writer.write("data/" + name + ".csv", csv_text(of_figures[name]));
      else
        writer.remove("data/" + name + ".csv");
    }
    const bool is_drawn = !figure.data.empty() && figure.data.front() == all_names.front();
    for (const char* ending : {".pdf", ".pgf"}) writer.remove("figures/" + figure.name + ending);
    if (is_drawn) figures.push_back(std::move(figure));
  }
  writer.write("data/outcomes.csv", csv_text(outcome_rows(data)));
  writer.write("figures.tex", document(data, figures, {has_quality, has_growth}, command));
  writer.write("README.md", readme(report, data, figures, command));
  return writer.written();
}

}  // namespace mwt
