// Points, triangles, intervals and errors of the library.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace mwt::v1 {

/// A point of the plane: finite coordinates up to 1e300.
struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

/// Positions of the corners in the points that were given, from 0, counter-clockwise.
using Triangle = std::array<std::uint32_t, 3>;

/// A certified interval: the true value lies between its ends.
struct Interval {
  double lower = 0;
  double upper = 0;
};

/// What every function throws; the messages are those of the program mwt.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A mistake in what was given: points, names, parameters, files.
class InputError : public Error {
 public:
  using Error::Error;
};

/// The algorithm does not take these points: too many, or not in convex position.
class NotApplicable : public Error {
 public:
  using Error::Error;
};

/// The caller's interrupt stopped the computation.
class Interrupted : public Error {
 public:
  using Error::Error;
};

/// A bug of the library.
class InternalError : public Error {
 public:
  using Error::Error;
};

}  // namespace mwt::v1
