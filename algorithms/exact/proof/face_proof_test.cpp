#include "algorithms/exact/proof/face_proof.h"

#include <gtest/gtest.h>

#include "algorithms/exact/testing/stage_testing.h"
#include "algorithms/proof_trace.h"

namespace mwt {
namespace {

using namespace stage_testing;

// The walk around the large wheel is long, the small one's is not, and each has a hub with candidates all around. The
// long walk was left out, its hub was not: the program failed with an internal error.
TEST(FaceProof, LeavesFacesOutAsAWholeAfterTheDeadline) {
  std::vector<Point> points = generate("wheel", 100, 1);
  for (const Point& p : generate("wheel", 15, 1)) points.push_back({p.x + 3, p.y});
  const KdOrder order = make_kd_order(points);
  Context late;
  late.deadline = Context::Clock::now() - std::chrono::seconds(1);
  ProofTrace trace;
  late.proof = &trace;
  note_faces(candidate_graph(order), {}, late);
  EXPECT_TRUE(trace.is_complete);
  EXPECT_GT(trace.lower_bound, 0);
}

}  // namespace
}  // namespace mwt
