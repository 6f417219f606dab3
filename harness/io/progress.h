// How far long work has come: a live line on a terminal, now and then a plain line elsewhere.
#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

namespace mwt {

/// Prints done/total, failures, rate and time left. A terminal's line is rewritten in place; elsewhere a line appears
/// now and then and at the end.
class Progress {
 public:
  Progress(std::ostream& out, bool is_terminal, std::string title, std::size_t total);

  /// So many pieces more are to be done.
  void expect(std::size_t more);

  /// One piece is done; `what` names it.
  void advance(bool failed, const std::string& what);

  /// Shows the time going by while a long piece runs.
  void refresh();

  /// A line of its own, above the live line.
  void announce(const std::string& line);

  /// Ends the live line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void show();
  [[nodiscard]] std::string status() const;

  std::ostream& out_;
  bool is_terminal_;
  std::string title_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
  std::string what_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_shown_ = begin_;
  bool is_finished_ = false;
};

}  // namespace mwt
