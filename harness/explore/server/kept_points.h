// Point sets that pages have left with the server, so that links can name them.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace mwt {

/// As long as the object lives, and no more than fit: the one that was used longest ago goes first. Thread-safe.
class KeptPoints {
 public:
  explicit KeptPoints(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  /// Keeps these bytes, doubles x0 y0 x1 y1 ...; returns their name, which depends on nothing else. Nothing if they are
  /// no points, none, or too many.
  [[nodiscard]] std::optional<std::string> keep(const std::string& bytes);

  /// Null if there is no such set, or no longer.
  [[nodiscard]] std::shared_ptr<const std::string> find(const std::string& name);

 private:
  struct Kept {
    std::string name;
    std::shared_ptr<const std::string> bytes;
  };

  std::size_t max_bytes_;
  std::mutex mutex_;
  std::deque<Kept> kept_;  // the one used last in front
  std::size_t bytes_ = 0;
};

}  // namespace mwt
