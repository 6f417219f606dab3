// C12: fitted running times against the stated ones, the source report's literal algorithms and the fast ones side by
// side.
#include <fmt/core.h>

#include <cmath>
#include <set>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"

namespace mwt::claims {

namespace {

constexpr double kTolerance = 0.15;     // caches and memory make large inputs dearer per step
constexpr Index kMinPower = 20;         // below, fixed costs hide the growth
constexpr Index kMinNearLinear = 1000;  // below, n log n cannot be distinguished from n
constexpr double kSlowestGrowth = 1.5;  // per point: what "exponential" must exceed
constexpr std::size_t kMinSizes = 3;

enum class Shape { power, times_log, per_pass };

// What the source report states about one algorithm.
struct Statement {
  std::string algorithm;
  std::string family;
  std::string stated;
  Shape shape;
  double exponent;
};

const std::vector<Statement>& statements() {
  static const std::vector<Statement> all = {
      {"greedy_naive", "uniform", "O(n^4)", Shape::power, 4},
      {"hull_insertion", "uniform", "O(n^3)", Shape::power, 3},
      {"hull_insertion", "circle", "O(n^3)", Shape::power, 3},
      {"flip_naive", "uniform", "O(n^2 I)", Shape::per_pass, 2},
      {"quadtree", "uniform", "O(n log n)", Shape::times_log, 1},
      {"delaunay", "uniform", "O(n log n)", Shape::times_log, 1},
  };
  return all;
}

// The algorithms that the source report does not have, for comparison.
constexpr const char* kFamilyOfOthers = "uniform";

// Which sizes count is fixed beforehand, not by how long they take: the verdict must not depend on the machine's speed.
Index min_n(Shape shape) { return shape == Shape::times_log ? kMinNearLinear : kMinPower; }

// The CPU time, which other programs on the machine disturb less than wall time, divided by what the statement allows
// for beside the power of n. Nothing of runs before CPU times could be trusted: such a clock may have stood still.
std::optional<double> time_for(const RunRecord& run, Shape shape) {
  if (!(run.cpu_time_s.value_or(0) > 0) || run.n < min_n(shape)) return std::nullopt;
  if (shape == Shape::times_log) return *run.cpu_time_s / std::log(run.n);
  if (shape == Shape::per_pass) return *run.cpu_time_s / named_number(run.counters, "passes").value_or(1);
  return run.cpu_time_s;
}

std::optional<PowerLaw> fit(const Runs& runs, Shape shape) {
  return growth_of(
      runs, [shape](const RunRecord& run) { return time_for(run, shape); }, kMinSizes);
}

std::set<Index> sizes_of(const Runs& runs) {
  std::set<Index> sizes;
  for (const RunRecord* run : runs) sizes.insert(run->n);
  return sizes;
}

// The factor by which brute force takes longer with every point; nothing if it was timed at too few sizes.
std::optional<Estimate> growth_of_brute_force(const Runs& runs) {
  if (sizes_of(runs).size() < kMinSizes) return std::nullopt;
  std::vector<Measurement> measurements;
  for (const RunRecord* run : runs) measurements.push_back({std::exp(run->n), *run->cpu_time_s});
  const Estimate slope = fit_power_law(measurements)->exponent;
  return Estimate{std::exp(slope.value), std::exp(slope.lower), std::exp(slope.upper)};
}

// Brute force's few sizes all count.
Runs runs_of_brute_force(const StudyRecords& records) {
  return finished_runs(records, [](const RunRecord& run) {
    return run.algorithm == "brute_force" && run.generator == "uniform" && run.cpu_time_s.value_or(0) > 0;
  });
}

// The runs that are fitted.
Runs runs_of(const StudyRecords& records, const std::string& algorithm, const std::string& family, Shape shape) {
  return finished_runs(records, [&](const RunRecord& run) {
    const std::optional<std::string> start = named_value(run.params, "start");
    const bool is_usual = algorithm != "flip_naive" || start == "delaunay";
    return run.algorithm == algorithm && run.generator == family && is_usual && time_for(run, shape);
  });
}

class Judge {
 public:
  explicit Judge(const StudyRecords& records) : records_(records) {
    finding_.details.header = {"algorithm", "family", "stated", "sizes", "fitted exponent of n (95%)", "agrees"};
  }

  Finding judge() {
    judge_brute_force();
    for (const Statement& statement : statements()) judge_statement(statement);
    for (const char* algorithm : {"greedy", "flip", "patch", "annealing", "sweep", "exact"}) {
      show(algorithm);
    }
    finding_.verdict = contradicted_              ? ClaimVerdict::refuted
                       : finding_.missing.empty() ? ClaimVerdict::holds
                                                  : ClaimVerdict::undecided;
    return std::move(finding_);
  }

 private:
  void judge_brute_force() {
    const Runs runs = runs_of_brute_force(records_);
    const std::optional<Estimate> factor = growth_of_brute_force(runs);
    if (!factor) return miss_sizes("brute_force on uniform", "", runs);
    const bool agrees = factor->lower > kSlowestGrowth, contradicts = factor->upper < kSlowestGrowth;
    contradicted_ = contradicted_ || contradicts;
    if (!agrees && !contradicts)
      miss("brute_force: the interval of its growth per point holds " + fixed(kSlowestGrowth, 1));
    const std::string text = fixed(factor->value, 1) + "^n";
    add(runs, {"brute_force", "uniform", "exponential", size_range(runs), text, word_for(agrees, contradicts)});
    say("brute_force " + text);
  }

  void judge_statement(const Statement& statement) {
    const Runs runs = runs_of(records_, statement.algorithm, statement.family, statement.shape);
    const std::string name = statement.algorithm + " on " + statement.family;
    const std::optional<PowerLaw> law = fit(runs, statement.shape);
    if (!law) return miss_sizes(name, " from n = " + grouped(min_n(statement.shape)), runs);
    const double most = statement.exponent + kTolerance;
    const bool agrees = law->exponent.upper <= most, contradicts = law->exponent.lower > most;
    contradicted_ = contradicted_ || contradicts;
    const std::string beside = statement.shape == Shape::times_log  ? " beside log n"
                               : statement.shape == Shape::per_pass ? " per pass"
                                                                    : "";
    const std::string exponent = exponent_text(*law) + beside;
    if (!agrees && !contradicts)
      miss(fmt::format("{}: the interval of its exponent, {}, holds {:.2f}", name, exponent, most));
    add(runs, {statement.algorithm, statement.family, statement.stated, size_range(runs), exponent,
               word_for(agrees, contradicts)});
    say(fmt::format("{} n^{:.2f}{} ({})", name, law->exponent.value, beside, statement.stated));
  }

  static std::string word_for(bool agrees, bool contradicts) { return agrees ? "yes" : contradicts ? "no" : "open"; }

  void show(const std::string& algorithm) {
    const Runs runs = runs_of(records_, algorithm, kFamilyOfOthers, Shape::power);
    if (const auto law = fit(runs, Shape::power)) {
      add(runs, {algorithm, kFamilyOfOthers, "", size_range(runs), exponent_text(*law), ""});
    }
  }

  void add(const Runs& runs, std::vector<std::string> details) {
    finding_.rows.insert(finding_.rows.end(), runs.begin(), runs.end());
    finding_.details.rows.push_back(std::move(details));
  }

  void miss(const std::string& what) { finding_.missing += (finding_.missing.empty() ? "" : "; ") + what; }

  void miss_sizes(const std::string& name, const std::string& from, const Runs& runs) {
    std::vector<std::string> sizes;
    for (const Index n : sizes_of(runs)) sizes.push_back(grouped(n));
    miss(fmt::format("{} has CPU times of finished runs at {} sizes{}{}, {} are needed", name, sizes.size(), from,
                     sizes.empty() ? "" : " (n = " + joined(sizes, "; ") + ")", kMinSizes));
  }

  void say(const std::string& text) { finding_.measured += (finding_.measured.empty() ? "" : ", ") + text; }

  const StudyRecords& records_;
  Finding finding_;
  bool contradicted_ = false;
};

}  // namespace

Claim running_times() {
  return {
      "C12",
      "Times: brute force exponential, greedy O(n^4), DP + insertion O(n^3), local search O(n^2 I) for I passes, "
      "quadtree and Delaunay O(n log n)",
      "4.2 to 6",
      "CPU times on uniform points from n = 20 (brute force: all), for DP + insertion also on circle, where the hull "
      "is everything; for O(n log n) from n = 1,000; short runs are repeated until they can be timed",
      "each stated time is an upper bound: refuted if the fitted exponent's lower 95% limit exceeds the stated one by "
      "more than 0.15 somewhere (or brute force multiplies by less than 1.5 per point); holds if no upper limit does "
      "and every algorithm was timed at three sizes or more; otherwise undecided",
      "mwt run claims --out results/claims --resume",
      [](const StudyRecords& records) { return Judge(records).judge(); }};
}

}  // namespace mwt::claims
