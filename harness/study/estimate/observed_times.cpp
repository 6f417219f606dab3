#include "harness/study/estimate/observed_times.h"

#include <fmt/core.h>

#include <chrono>
#include <filesystem>

#include "harness/io/text/text.h"

namespace mwt {

namespace {

constexpr double kCalibrationTime = 8;  // s

}  // namespace

std::string ObservedTimes::text() const {
  return fmt::format("estimated from {} recorded runs in {} folders of this machine and {} runs made just now in {}",
                     past.runs, past.folders, measured, readable_duration(elapsed_s));
}

ObservedTimes observe_times(const Study& study, const Plan& plan, const std::vector<PlannedWork>& work,
                            const std::string& folder, const EnvironmentRecord& here) {
  ObservedTimes times;
  const std::string siblings = std::filesystem::path(folder).parent_path().string();
  times.past = add_past_times(times.model, {folder, siblings.empty() ? "." : siblings, "results"}, here, study.threads);
  const auto begin = std::chrono::steady_clock::now();
  times.measured = calibrate(times.model, study, plan, work, kCalibrationTime);
  times.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return times;
}

}  // namespace mwt
