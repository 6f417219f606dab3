// Ctrl-C and SIGTERM as a question that loops ask.
#pragma once

namespace mwt {

/// While one lives, SIGINT and SIGTERM only set a flag. One at a time.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  [[nodiscard]] static bool requested();
};

}  // namespace mwt
