// The ranges in which rounded arithmetic keeps its relative error bounds: the basis of every floating-point filter.
//
// A filter compares a rounded value with a margin that is a proven error bound and some room. Such bounds are relative
// to the magnitudes of the terms, and hold as long as nothing overflows and no product underflows. (Sums and
// differences of doubles never underflow inexactly.) A product of doubles that underflows is off by at most 2^-1075,
// and that is negligible as long as the magnitude of the whole is large enough. Outside of these ranges a filter is not
// sure, whatever it computed, and the slow exact way decides.
#pragma once

namespace mwt {

/// The largest magnitude of a coordinate that the program takes: beyond, sums of lengths overflow.
inline constexpr double kMaxCoordinate = 1e300;

/// Sums of products of two differences of coordinates: squared lengths, orientations, scalar products. `magnitude` is
/// the sum of the products' rounded magnitudes; NaN and infinity are not trusted.
///
/// Eight products that underflow are off by 2^-1072 in all, less than 2^-141 of any trusted magnitude (1e-280 >
/// 2^-931). All margins leave far more room than that, the narrowest of doubles 2^-54, those of double-doubles 2^-97: a
/// bound need not mention underflow. A single trusted product is exact with its remainder (exact_product() in
/// double_double.h), whose last bit is at least 2^-1036.
inline constexpr double kMinTrustedProduct = 1e-280;
inline constexpr double kMaxTrustedProduct = 1e300;
[[nodiscard]] constexpr bool is_trusted_product(double magnitude) {
  return magnitude > kMinTrustedProduct && magnitude < kMaxTrustedProduct;
}

/// The same for magnitudes of which up to three are multiplied: the results stay within 1e-270 and 1e270.
inline constexpr double kMinTrustedFactor = 1e-90;
inline constexpr double kMaxTrustedFactor = 1e90;
[[nodiscard]] constexpr bool is_trusted_factor(double magnitude) {
  return magnitude > kMinTrustedFactor && magnitude < kMaxTrustedFactor;
}

/// Squared lengths that are rounded to float: far from where floats lose bits (2^-126 = 1.2e-38) or overflow (3.4e38),
/// so that they err by 2^-24 of themselves, and so do their multiples by factors up to a million.
inline constexpr double kMinTrustedFloat = 1e-30;
inline constexpr double kMaxTrustedFloat = 1e30;
[[nodiscard]] constexpr bool is_trusted_float(double square) {
  return square > kMinTrustedFloat && square < kMaxTrustedFloat;
}

/// Lengths and sums of lengths: above it, lengths that underflow to multiples of 2^-1074, up to 2^70 of them, are off
/// by less than 2^-104 of the sum.
inline constexpr double kMinTrustedLength = 0x1p-900;

}  // namespace mwt
