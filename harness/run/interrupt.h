// Ctrl-C and SIGTERM as a flag that loops read.
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
