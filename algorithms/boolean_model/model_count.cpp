#include "algorithms/boolean_model/model_count.h"

#include <algorithm>

namespace mwt {

namespace {

enum class State : std::uint8_t { open, in, out };

class Counting {
 public:
  Counting(const CrossingModel& model, const Deadline& deadline)
      : model_(model), deadline_(deadline), state_(model.edges.size(), State::open) {}

  std::optional<ModelCount> run() {
    count();
    if (is_late_) return {};
    return result_;
  }

 private:
  void count() {
    constexpr std::uint64_t kStepsPerLook = 1024;
    if (++steps_ % kStepsPerLook == 0 && has_passed(deadline_)) is_late_ = true;
    if (is_late_) return;
    const std::size_t before = trail_.size();
    const auto open = std::find(state_.begin(), state_.end(), State::open);
    if (open == state_.end()) {
      ++result_.count;
      const auto chosen = static_cast<std::size_t>(std::count(state_.begin(), state_.end(), State::in));
      result_.have_the_same_size = result_.have_the_same_size && chosen == model_.size;
      return;
    }
    const auto edge = static_cast<std::uint32_t>(open - state_.begin());
    for (const State state : {State::in, State::out}) {
      if (decide(edge, state)) count();
      take_back(before);
    }
  }

  // Whether the consequences leave anything possible.
  bool decide(std::uint32_t edge, State state) {
    std::vector<std::pair<std::uint32_t, State>> pending{{edge, state}};
    while (!pending.empty()) {
      const auto [e, wanted] = pending.back();
      pending.pop_back();
      if (state_[e] == wanted) continue;
      if (state_[e] != State::open) return false;
      state_[e] = wanted;
      trail_.push_back(e);
      if (wanted == State::in) {
        for (const std::uint32_t f : model_.crossing[e]) pending.emplace_back(f, State::out);
        continue;
      }
      if (!has_reason(e, pending)) return false;
      for (const std::uint32_t f : model_.crossing[e]) {
        if (state_[f] == State::out && !has_reason(f, pending)) return false;
      }
    }
    return true;
  }

  // An edge that is out needs one in, or one that is open, which must be in if it is the last.
  bool has_reason(std::uint32_t edge, std::vector<std::pair<std::uint32_t, State>>& pending) const {
    std::uint32_t open = 0, last = 0;
    for (const std::uint32_t f : model_.crossing[edge]) {
      if (state_[f] == State::in) return true;
      if (state_[f] != State::open) continue;
      ++open;
      last = f;
    }
    if (open == 1) pending.emplace_back(last, State::in);
    return open > 0;
  }

  void take_back(std::size_t before) {
    for (; trail_.size() > before; trail_.pop_back()) state_[trail_.back()] = State::open;
  }

  const CrossingModel& model_;
  const Deadline& deadline_;
  std::vector<State> state_;
  std::vector<std::uint32_t> trail_;
  ModelCount result_;
  std::uint64_t steps_ = 0;
  bool is_late_ = false;
};

}  // namespace

std::optional<ModelCount> count_models(const CrossingModel& model, const Deadline& deadline) {
  return Counting(model, deadline).run();
}

}  // namespace mwt
