// How products that are added to something are rounded: once or twice.
#pragma once

namespace mwt {

/// Rounds the product, then the sum. Vectors round once where the machine can; tests give the plain loops
/// (diamond_scalar.h, lmt_scalar.h) the same rounding, to compare them bit by bit.
struct RoundedTwice {
  [[nodiscard]] static float multiply_add(float a, float b, float c) { return a * b + c; }
};

}  // namespace mwt
