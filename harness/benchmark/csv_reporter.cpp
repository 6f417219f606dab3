#include "harness/benchmark/csv_reporter.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number_text.h"

// Google Benchmark announces that its CSV may go; it has no other.
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace mwt {

namespace {

constexpr std::array<std::string_view, 4> kCounters = {"over_delaunay", "stopped_early", "alpha_lower", "alpha_upper"};

class CsvReporter final : public benchmark::CSVReporter {
 public:
  // On the screen the context goes to standard error; a file would begin with lines that are no CSV.
  bool ReportContext(const Context& context) override {
    return &GetErrorStream() == &GetOutputStream() || CSVReporter::ReportContext(context);
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    std::ostream& out = GetOutputStream();
    if (!std::exchange(has_header_, true)) out << header();
    for (Run run : runs) {
      keep_fixed_counters(run);
      std::string row = captured(run);
      // A failed benchmark's row ends before the counters.
      if (run.error_occurred) row.insert(row.size() - 1, kCounters.size(), ',');
      out << row;
    }
    out.flush();
  }

 private:
  [[nodiscard]] std::string captured(const Run& run) {
    std::ostream& out = GetOutputStream();
    std::ostringstream text;
    SetOutputStream(&text);
    CSVReporter::ReportRuns({run});
    SetOutputStream(&out);
    return text.str();
  }

  // It goes out with the first row, so a row is made that has all counters, and left out.
  [[nodiscard]] std::string header() {
    Run run;
    run.error_occurred = true;
    for (const std::string_view name : kCounters) run.counters[std::string(name)] = {};
    const std::string text = captured(run);
    return text.substr(0, text.find('\n') + 1);
  }

  static void keep_fixed_counters(Run& run) {
    benchmark::UserCounters kept;
    for (const auto& [name, counter] : run.counters) {
      if (std::find(kCounters.begin(), kCounters.end(), name) != kCounters.end()) {
        kept[name] = counter;
      } else {
        run.report_label += (run.report_label.empty() ? "" : " ") + name + '=' + number_text(counter.value);
      }
    }
    run.counters = kept;
  }

  bool has_header_ = false;
};

}  // namespace

std::unique_ptr<benchmark::BenchmarkReporter> make_csv_reporter() { return std::make_unique<CsvReporter>(); }

}  // namespace mwt
