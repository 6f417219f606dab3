#include "verifier/verify.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mwt::verifier
