#include "harness/io/progress.h"

#include <fmt/core.h>

#include <utility>

#include "harness/io/text/text.h"

namespace mwt {

namespace {

using namespace std::chrono_literals;
constexpr std::chrono::steady_clock::duration kTerminalInterval = 100ms;
constexpr std::chrono::steady_clock::duration kPlainInterval = 20s;
constexpr const char* kClearLine = "\r\x1b[K";
constexpr std::size_t kTerminalWidth = 79;  // a line that wraps could not be rewritten

}  // namespace

Progress::Progress(std::ostream& out, bool is_terminal, std::string title, std::size_t total)
    : out_(out), is_terminal_(is_terminal), title_(std::move(title)), total_(total) {}

void Progress::expect(std::size_t more) {
  total_ += more;
  if (more > 0) is_finished_ = false;
}

void Progress::advance(bool failed, const std::string& what) {
  ++done_;
  if (failed) ++failed_;
  what_ = what;
  if (done_ == total_) {
    finish();
  } else {
    refresh();
  }
}

void Progress::refresh() {
  if (!is_finished_ && Clock::now() - last_shown_ >= (is_terminal_ ? kTerminalInterval : kPlainInterval)) show();
}

void Progress::announce(const std::string& line) {
  out_ << (is_terminal_ ? kClearLine : "") << line << '\n' << std::flush;
  if (is_terminal_ && !is_finished_) show();
}

void Progress::finish() {
  if (std::exchange(is_finished_, true)) return;
  what_.clear();
  show();
  if (is_terminal_) out_ << '\n' << std::flush;
}

void Progress::show() {
  last_shown_ = Clock::now();
  if (is_terminal_) {
    out_ << kClearLine << status().substr(0, kTerminalWidth) << std::flush;
  } else {
    out_ << status() << '\n' << std::flush;
  }
}

std::string Progress::status() const {
  const std::chrono::duration<double> elapsed = Clock::now() - begin_;
  std::string line = fmt::format("{} {}/{}, {} failed", title_, done_, total_, failed_);
  if (is_finished_) return line + ", took " + readable_duration(elapsed.count());
  if (done_ > 0) {
    const double rate = static_cast<double>(done_) / elapsed.count();
    line += fmt::format(", {:.1f}/s, {} left", rate, readable_duration(static_cast<double>(total_ - done_) / rate));
  }
  return line + (what_.empty() ? "" : ", last: " + what_);
}

}  // namespace mwt
