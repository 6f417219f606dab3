#include "harness/rating/proof_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/columns.h"
#include "harness/io/text/csv.h"
#include "verifier/refused.h"
#include "verifier/verify.h"

namespace mwt {

namespace {

constexpr std::array<std::pair<ProofVerdict, std::string_view>, 4> kNames{{{ProofVerdict::optimal, "optimal"},
                                                                           {ProofVerdict::bounded, "bounded"},
                                                                           {ProofVerdict::refused, "refused"},
                                                                           {ProofVerdict::failed, "failed"}}};

// A check as it goes through the pipe.
struct SentCheck {
  ProofVerdict verdict = ProofVerdict::failed;
  std::optional<double> lower, upper;
  std::string note;
  double time_s = 0;
};

const std::vector<Column<SentCheck>>& columns() {
  using S = SentCheck;
  static const std::vector<Column<S>> all = {column<S>("verdict", &S::verdict), column<S>("lower", &S::lower),
                                             column<S>("upper", &S::upper), column<S>("note", &S::note),
                                             time_column<S>("time_s", &S::time_s)};
  return all;
}

// A verdict must not depend on what else the machine does: the limit is one of CPU time, and of much more time on the
// clock.
constexpr double kPatience = 20;

// What happens inside the process.
SentCheck verified_here(Points points, const std::string& file) {
  SentCheck check;
  try {
    const verifier::Verdict verdict = verifier::verify({points.begin(), points.end()}, file);
    check.verdict = verdict.is_optimal ? ProofVerdict::optimal : ProofVerdict::bounded;
    check.lower = verdict.lower;
    check.upper = verdict.upper;
  } catch (const verifier::Refused& refused) {
    check.verdict = ProofVerdict::refused;
    check.note = refused.what();
  } catch (const InputError& damaged) {
    check.verdict = ProofVerdict::refused;
    check.note = damaged.what();
  } catch (const std::bad_alloc&) {
    check.note = "an allocation failed under the memory limit";
  } catch (const std::exception& failure) {
    check.note = failure.what();
  }
  return check;
}

std::string encoded_check(Points points, const std::string& file) {
  const auto begin = std::chrono::steady_clock::now();
  SentCheck check = verified_here(points, file);
  check.time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return csv_line(to_row(columns(), check));
}

std::string cause_of(const ProcessResult& process, double limit_s) {
  if (process.end == ProcessEnd::stopped_at_limit)
    return fmt::format("stopped at the limit of {} s of CPU time", number_text(limit_s));
  return process.how.empty() ? "the verifier's verdict was unreadable" : process.how;
}

ProofCheck check_after(const ProcessResult& process, double limit_s) {
  ProofCheck check;
  check.note = cause_of(process, limit_s);
  const std::vector<CsvRow> rows =
      process.end == ProcessEnd::finished ? parse_csv(process.output) : std::vector<CsvRow>();
  if (rows.size() != 1) return check;
  try {
    const SentCheck sent = read_row(columns(), rows.front());
    check.verdict = sent.verdict;
    if (sent.lower && sent.upper) check.interval = {*sent.lower, *sent.upper};
    check.note = sent.note;
    check.time_s = sent.time_s;
  } catch (const std::invalid_argument&) {  // the note above
  }
  return check;
}

}  // namespace

std::string to_text(ProofVerdict verdict) {
  for (const auto& [value, name] : kNames) {
    if (value == verdict) return std::string(name);
  }
  throw std::logic_error("a verdict without a name");
}

void read_text(const std::string& text, ProofVerdict& verdict) {
  const auto* const entry = std::ranges::find(kNames, text, &std::pair<ProofVerdict, std::string_view>::second);
  if (entry == kNames.end()) throw std::invalid_argument(text);
  verdict = entry->first;
}

void start_proof_check(ProcessPool& pool, const Instance& instance, const std::string& file, const RunLimits& limits,
                       std::function<void(const ProofCheck&)> when_done) {
  const Points points = instance.set.points;
  ProcessLimits process;
  process.cpu_s = limits.time_s + limits.grace_s;
  process.wall_s = kPatience * process.cpu_s;
  process.memory_bytes = limits.memory_bytes;
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(file, ignored);
  pool.start([&] { return encoded_check(points, file); }, process,
             [when_done = std::move(when_done), size, limit_s = process.cpu_s](const ProcessResult& result) {
               ProofCheck check = check_after(result, limit_s);
               check.bytes = size;
               when_done(check);
             });
}

}  // namespace mwt
