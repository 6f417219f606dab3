#include "harness/hunt/hunt.h"

#include <fmt/core.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

#include "base/error.h"
#include "harness/hunt/state_file.h"
#include "harness/run/interrupt.h"

namespace mwt {

namespace {

using Clock = std::chrono::steady_clock;

// The climbers' threads and the snapshots of their states.
class Expedition {
 public:
  Expedition(const HuntPlan& plan, const HuntLimits& limits, std::vector<ClimberState> states)
      : plan_(plan),
        limits_(limits),
        oracle_(plan.request, *plan.solver),
        deadline_(Clock::now() +
                  std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.budget_s))),
        states_(std::move(states)),
        running_(states_.size()) {
    for (std::size_t i = 0; i < states_.size(); ++i) threads_.emplace_back([this, i] { climb(i); });
  }

  ~Expedition() {
    stop_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  Expedition(const Expedition&) = delete;
  Expedition& operator=(const Expedition&) = delete;

  // Waits for at most a second; false when all climbers have ended. Rethrows what one of them threw.
  bool wait() {
    std::unique_lock lock(mutex_);
    all_done_.wait_for(lock, std::chrono::seconds(1), [this] { return running_ == 0; });
    if (InterruptWatch::requested()) stop_ = true;
    if (failure_) std::rethrow_exception(failure_);
    return running_ > 0;
  }

  [[nodiscard]] std::vector<ClimberState> states() {
    const std::lock_guard lock(mutex_);
    return states_;
  }

 private:
  [[nodiscard]] bool is_over(const ClimberState& state) const {
    return stop_ || Clock::now() >= deadline_ || (limits_.evaluations && state.evaluations >= *limits_.evaluations);
  }

  void climb(std::size_t number) {
    Climber climber(oracle_, plan_.n, plan_.seed, number, states()[number]);
    try {
      while (!is_over(climber.state())) {
        climber.step();
        const std::lock_guard lock(mutex_);
        states_[number] = climber.state();
      }
    } catch (...) {
      stop_ = true;
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (--running_ == 0) all_done_.notify_one();
  }

  const HuntPlan& plan_;
  const HuntLimits& limits_;
  AlphaOracle oracle_;
  Clock::time_point deadline_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;  // guards what follows
  std::condition_variable all_done_;
  std::vector<ClimberState> states_;
  std::size_t running_;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;  // last: they use all of the above
};

HuntResult result_of(const std::vector<ClimberState>& states) {
  HuntResult result;
  for (const ClimberState& state : states) {
    result.evaluations += state.evaluations;
    if (state.best.alpha > result.worst.alpha) result.worst = state.best;
  }
  return result;
}

std::vector<ClimberState> initial_states(const HuntPlan& plan, const std::string& state_file) {
  if (!std::filesystem::exists(state_file)) return std::vector<ClimberState>(static_cast<std::size_t>(plan.climbers));
  std::vector<ClimberState> states = read_hunt_state(state_file, plan.identity());
  if (states.size() != static_cast<std::size_t>(plan.climbers)) {
    throw InputError(
        fmt::format("{}: state of a hunt with {} climbers, not {}", state_file, states.size(), plan.climbers));
  }
  const auto fits = [&](const RatedInstance& instance) {
    return instance.points.empty() || instance.points.size() == plan.n;
  };
  for (const ClimberState& state : states) {
    if (!fits(state.current) || !fits(state.best))
      throw InputError(fmt::format("{}: has an instance of another size than n={}; delete the file to begin anew",
                                   state_file, plan.n));
  }
  return states;
}

}  // namespace

std::string HuntPlan::identity() const {
  const std::string parameters = request.parameters.canonical();
  return fmt::format("# mwt hunt 1: {}{} algorithm_seed={} n={} seed={} threads={} solver={}", request.algorithm->name,
                     parameters.empty() ? "" : " " + parameters, request.seed, n, seed, climbers, solver->name);
}

HuntResult hunt(const HuntPlan& plan, const HuntLimits& limits, const std::string& state_file,
                const std::function<void(const HuntResult&)>& has_improved) {
  const InterruptWatch watch;
  Expedition expedition(plan, limits, initial_states(plan, state_file));
  double reported = 0;
  bool goes_on = true;
  while (goes_on) {
    goes_on = expedition.wait();
    const std::vector<ClimberState> states = expedition.states();
    write_hunt_state(state_file, plan.identity(), states);
    const HuntResult result = result_of(states);
    if (result.worst.alpha > reported) has_improved(result);
    reported = result.worst.alpha;
  }
  HuntResult result = result_of(expedition.states());
  result.interrupted = InterruptWatch::requested();
  return result;
}

}  // namespace mwt
