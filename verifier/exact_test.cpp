#include "verifier/exact.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "verifier/bounds.h"
#include "verifier/diamond.h"

namespace mwt::verifier {
namespace {

using Rational = boost::multiprecision::cpp_rational;

int form_by_rationals(const Point& o, const Point& a, const Point& b, double s, double t) {
  const Rational ux = Rational(a.x) - Rational(o.x), uy = Rational(a.y) - Rational(o.y);
  const Rational vx = Rational(b.x) - Rational(o.x), vy = Rational(b.y) - Rational(o.y);
  const Rational form = Rational(s) * (ux * vy - uy * vx) + Rational(t) * (ux * vx + uy * vy);
  return form.sign();
}

// Coordinates near each other, on a line with rounding, or of very different size.
double coordinate(std::mt19937& random, int kind) {
  const double x = static_cast<double>(random() % 1000);
  switch (kind) {
    case 0: return x;
    case 1: return 0.1 * x;
    case 2: return 0.5 + x * 0x1p-53;
    case 3: return std::ldexp(x, static_cast<int>(random() % 200) - 100);
    default: return std::ldexp(x, static_cast<int>(random() % 2040) - 1074 + 8);
  }
}

TEST(Exact, SignsAreThoseOfRationals) {
  std::mt19937 random(1);
  for (int round = 0; round < 5000; ++round) {
    const int kind = round % 5;
    const auto point = [&] { return Point{coordinate(random, kind), coordinate(random, kind)}; };
    const Point o = point(), a = point(), b = point();
    for (const auto& [s, t] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {-1.0, kDiamondTangent}, {0.620408, 1.0}}) {
      ASSERT_EQ(sign_of_form(o, a, b, s, t), form_by_rationals(o, a, b, s, t)) << round;
    }
    const Point c = point();
    const auto square = [](const Point& p, const Point& q) -> Rational {
      const Rational x = Rational(p.x) - Rational(q.x), y = Rational(p.y) - Rational(q.y);
      return x * x + y * y;
    };
    const Rational difference = square(o, a) - square(b, c);
    ASSERT_EQ(compare_lengths(o, a, b, c), difference.sign()) << round;
  }
}

TEST(Exact, NearlyCollinearPointsAreToldApart) {
  const Point a{0.1, 0.1}, b{0.3, 0.3}, on{0.2, 0.2}, above{0.2, std::nextafter(0.2, 1)};
  EXPECT_EQ(turn(a, b, on), form_by_rationals(a, b, on, 1, 0));
  EXPECT_EQ(turn(a, b, above), form_by_rationals(a, b, above, 1, 0));
  EXPECT_EQ(turn({0, 0}, {3e300, 3e300}, {1e-300, 1e-300}), 0);
  EXPECT_EQ(turn({0, 0}, {1e300, 1e300}, {1e-300, 2e-300}), 1);
}

TEST(Exact, CrossingMeansWhatTriangulationsCannotHave) {
  const Point a{0, 0}, b{4, 0}, c{2, 2}, d{2, -2}, middle{2, 0}, beyond{6, 0};
  EXPECT_TRUE(do_cross(a, b, c, d));
  EXPECT_TRUE(do_cross(a, b, c, middle)) << "ends inside";
  EXPECT_TRUE(do_cross(a, b, middle, beyond)) << "overlap";
  EXPECT_FALSE(do_cross(a, b, b, beyond)) << "one after the other";
  EXPECT_FALSE(do_cross(a, b, a, c)) << "a common end";
  EXPECT_FALSE(do_cross(a, b, c, {2, 1}));
}

TEST(Exact, TheDiamondsAngleIsRoundedDown) {
  mpfr_t value;
  mpfr_init2(value, 200);
  mpfr_const_pi(value, MPFR_RNDN);
  mpfr_mul_ui(value, value, 5, MPFR_RNDN);  // pi / 4.6 = 5 pi / 23
  mpfr_div_ui(value, value, 23, MPFR_RNDN);
  mpfr_tan(value, value, MPFR_RNDN);
  EXPECT_LT(mpfr_cmp_d(value, std::nextafter(kDiamondTangent, 1)), 0);
  EXPECT_GT(mpfr_cmp_d(value, kDiamondTangent), 0);
  mpfr_clear(value);
}

TEST(Bounds, EncloseLengths) {
  const Bounds five = length({0, 0}, {3, 4});
  EXPECT_EQ(lower_double(five), 5);
  EXPECT_EQ(upper_double(five), 5);
  const Bounds root = length({0, 0}, {1, 1});
  EXPECT_LE(lower_double(root), std::sqrt(2.0));
  EXPECT_GE(upper_double(root), std::sqrt(2.0));
  EXPECT_EQ(std::nextafter(lower_double(root), 2), upper_double(root));
  const Bounds tiny = length({0, 0}, {0x1p-1074, 0});
  EXPECT_EQ(lower_double(tiny), 0x1p-1074);
  EXPECT_EQ(lower_double(scaled(five, 3)), 40);
  EXPECT_EQ(floor_below(five, 1000), 5);
  EXPECT_EQ(floor_below(root, 1000), 1);
  EXPECT_EQ(floor_below(five, 4), 4);
}

}  // namespace
}  // namespace mwt::verifier
