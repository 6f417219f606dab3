#include "verifier/verify.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/testing/test_folder.h"
#include "verifier/refused.h"
#include "verifier/testing/naive_prover.h"

namespace mwt::verifier {
namespace {

using namespace testing;

TEST(Verify, BelievesProofsOfANaiveSolver) {
  const test::TestFolder folder;
  int proved = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const std::vector<Point> points = random_points(4 + seed % 22, seed, seed % 3 == 0 ? 6 : 0);
    const std::optional<Proof> proof = NaiveProver(points).prove();
    if (!proof) continue;
    SCOPED_TRACE(seed);
    ++proved;
    write_file(folder.path("proof"), file_of(encode(*proof)));
    Verdict verdict;
    ASSERT_NO_THROW(verdict = verify(points, folder.path("proof")));
    EXPECT_TRUE(verdict.is_optimal);
  }
  EXPECT_GT(proved, 200);
}

// Sums of lengths up to 2e300 may exceed all doubles; what is known then is no optimum.
TEST(Verify, InfiniteIntervalsAreNotOptimal) {
  constexpr double kMax = std::numeric_limits<double>::max(), kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(is_narrow(kMax, kInfinity));
  EXPECT_FALSE(is_narrow(kInfinity, kInfinity));
  EXPECT_TRUE(is_narrow(kMax, kMax));
  EXPECT_TRUE(is_narrow(1 - 1e-13, 1));
  EXPECT_FALSE(is_narrow(1 - 1e-11, 1));
}

}  // namespace
}  // namespace mwt::verifier
