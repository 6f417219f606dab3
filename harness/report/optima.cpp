#include "harness/report/optima.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "harness/io/text/aligned_table.h"
#include "harness/rating/optimum_search.h"
#include "harness/rating/quality.h"
#include "harness/rating/rated_run.h"

namespace mwt {

namespace {

// What the runs on one instance certify.
struct BestRuns {
  std::optional<Interval> bounds;     // of all of them together
  const RunRecord* solver = nullptr;  // the fastest that certifies the best lower bound

  void add(const RunRecord& run) {
    if (run.status != RunStatus::ok) return;
    if (const std::optional<Interval> optimum = optimum_of(run)) bounds = optimum;
    if (!run.certified_lower) return;
    const auto rank = [](const RunRecord& r) { return std::pair(-*r.certified_lower, r.wall_time_s.value_or(0)); };
    if (solver == nullptr || rank(run) < rank(*solver)) solver = &run;
  }
};

template <class Value>
void raise(std::optional<Value>& largest, const std::optional<Value>& value) {
  if (value && (!largest || *largest < *value)) largest = value;
}

void add(OptimumCell& cell, const InstanceRecord& instance, const BestRuns& runs) {
  ++cell.instances;
  const std::optional<Interval> optimum = runs.bounds ? runs.bounds : optimum_of(instance);
  const bool is_proved = optimality_of(optimum) == Optimality::proved;
  if (is_proved) ++cell.proved;
  if (!optimum) ++cell.without_bounds;
  if (optimum && !is_proved) cell.widest = std::max(cell.widest, optimum->relative_width());
  if (instance.verified) ++cell.verdicts[*instance.verified];
  if (runs.solver != nullptr) {
    raise(cell.time_s, runs.solver->wall_time_s);
    raise(cell.peak_rss_bytes, runs.solver->peak_rss_bytes);
  } else if (instance.optimum_note != kCachedNote) {
    raise(cell.time_s, instance.optimum_time_s);
  }
}

void add(OptimumCell& sum, const OptimumCell& cell) {
  sum.instances += cell.instances;
  sum.proved += cell.proved;
  sum.without_bounds += cell.without_bounds;
  sum.widest = std::max(sum.widest, cell.widest);
  for (const auto& [verdict, count] : cell.verdicts) sum.verdicts[verdict] += count;
}

}  // namespace

std::size_t OptimumCell::count(ProofVerdict verdict) const {
  const auto entry = verdicts.find(verdict);
  return entry == verdicts.end() ? 0 : entry->second;
}

std::vector<OptimumCell> optima_of(const StudyRecords& records) {
  std::map<std::string, BestRuns> runs;  // by instance
  std::set<std::pair<std::string, std::string>> with_runs;
  for (const RunRecord& run : records.runs) {
    runs[run.instance_id].add(run);
    with_runs.emplace(run.generator, run.generator_params);
  }
  std::vector<std::pair<std::string, std::string>> families;
  std::map<std::tuple<std::size_t, Index>, OptimumCell> cells;  // by place of the family, and n
  for (const InstanceRecord& instance : records.instances) {
    const std::pair family(instance.generator, instance.generator_params);
    if (!with_runs.contains(family)) continue;  // the study was interrupted
    const auto place = static_cast<std::size_t>(std::ranges::find(families, family) - families.begin());
    if (place == families.size()) families.push_back(family);
    OptimumCell& cell = cells[{place, instance.n}];
    std::tie(cell.generator, cell.generator_params) = family;
    cell.n = instance.n;
    add(cell, instance, runs[instance.instance_id]);
  }
  std::vector<OptimumCell> ordered;
  for (auto& [key, cell] : cells) ordered.push_back(std::move(cell));
  return ordered;
}

std::string optimum_summary(const std::vector<OptimumCell>& optima) {
  OptimumCell all;
  for (const OptimumCell& cell : optima) add(all, cell);
  std::string text = fmt::format("optima: {} of {} instances proved", all.proved, all.instances);
  if (!all.verdicts.empty()) {
    text += fmt::format(
        "; mwt_verify verifies {} of them, and bounds of {} others; it refuses {} proofs and has no "
        "verdict on {}",
        all.count(ProofVerdict::optimal), all.count(ProofVerdict::bounded), all.count(ProofVerdict::refused),
        all.count(ProofVerdict::failed));
  }
  return text + '\n';
}

std::string optimum_table(const std::vector<OptimumCell>& optima) {
  std::map<Index, OptimumCell> sizes;
  for (const OptimumCell& cell : optima) add(sizes[cell.n], cell);
  const bool has_proofs = std::ranges::any_of(optima, [](const OptimumCell& cell) { return !cell.verdicts.empty(); });
  std::vector<std::string> header = {"n", "instances", "proved", "widest interval", "no bounds"};
  if (has_proofs) header.insert(header.end(), {"verified", "bounds verified", "refused", "no verdict"});
  AlignedTable table(std::move(header));
  for (const auto& [n, cell] : sizes) {
    std::vector<std::string> row = {std::to_string(n), std::to_string(cell.instances), std::to_string(cell.proved),
                                    cell.widest > 0 ? fmt::format("{:.2g} %", 100 * cell.widest) : "-",
                                    std::to_string(cell.without_bounds)};
    if (has_proofs) {
      for (const ProofVerdict verdict :
           {ProofVerdict::optimal, ProofVerdict::bounded, ProofVerdict::refused, ProofVerdict::failed})
        row.push_back(std::to_string(cell.count(verdict)));
    }
    table.add_row(std::move(row));
  }
  if (table.is_empty()) return "";
  return "optima of the instances" + std::string(has_proofs ? "; verified: proofs that mwt_verify accepts" : "") +
         "\n" + table.text();
}

std::string rejected_proof_table(const std::vector<InstanceRecord>& instances) {
  AlignedTable table({"proof of", "verdict", "why"}, {0, 1, 2});
  for (const InstanceRecord& record : instances) {
    if (record.verified == ProofVerdict::refused || record.verified == ProofVerdict::failed)
      table.add_row({label_of_instance(record), to_text(*record.verified), record.proof_note});
  }
  return table.is_empty() ? "" : table.text();
}

}  // namespace mwt
