// How the verifier ends when it does not believe.
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/point.h"

namespace mwt::verifier {

/// A step of the proof does not follow.
class Refused : public std::runtime_error {
 public:
  /// `points` are those that the message speaks of, by their positions in the proof's order.
  explicit Refused(const std::string& message, std::initializer_list<Index> points = {})
      : std::runtime_error(message), points_(points) {}

  [[nodiscard]] const std::vector<Index>& points() const { return points_; }

 private:
  std::vector<Index> points_;
};

inline void require(bool follows, const char* otherwise, std::initializer_list<Index> points = {}) {
  if (!follows) throw Refused(otherwise, points);
}

}  // namespace mwt::verifier
