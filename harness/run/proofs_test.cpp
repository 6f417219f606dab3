// Solvers write proofs, the verifier checks them: the two share no code, so this is a test of both.
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <numbers>

#include "algorithms/proof/convex_proof.h"
#include "algorithms/proof_trace.h"
#include "algorithms/registry.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/checker.h"
#include "geometry/convex_hull.h"
#include "geometry/point_set.h"
#include "geometry/weight.h"
#include "harness/io/points/point_file.h"
#include "harness/io/proof_file.h"
#include "harness/io/testing/folder_testing.h"
#include "verifier/refused.h"
#include "verifier/testing/damage.h"
#include "verifier/verify.h"

namespace mwt {
namespace {

using testing::TestFolder;
using verifier::Verdict;

struct Proved {
  Solution solution;
  Interval claim;
  Verdict verdict;
};

// Solves with a proof and verifies it; a refusal fails the test.
class Prover {
 public:
  std::optional<Proved> prove(const std::string& algorithm, Points points, Deadline deadline = {},
                              int threads = 1) const {
    const AlgorithmInfo& info = find_algorithm(algorithm);
    Context context;
    context.parameters = Parameters(info.name, info.parameters, {});
    context.deadline = deadline;
    context.threads = threads;
    ProofTrace trace;
    context.proof = &trace;
    Proved proved;
    proved.solution = info.function(points, context);
    EXPECT_TRUE(trace.is_complete);
    EXPECT_TRUE(proved.solution.optimum);
    if (!trace.is_complete || !proved.solution.optimum) return {};
    proved.claim = write_proof(file(), points, trace, proved.solution.triangulation, *proved.solution.optimum);
    try {
      proved.verdict = verifier::verify({points.begin(), points.end()}, file());
    } catch (const verifier::Refused& refused) {
      ADD_FAILURE() << algorithm << ": " << refused.what();
      return {};
    }
    return proved;
  }

  // As prove(), and the proof must show what the solver says: the optimum.
  std::optional<Proved> prove_optimum(const std::string& algorithm, Points points) const {
    auto proved = prove(algorithm, points);
    if (!proved) return {};
    const Interval& own = *proved->solution.optimum;
    EXPECT_LE(own.relative_width(), 1e-12);
    EXPECT_TRUE(proved->verdict.is_optimal) << proved->verdict.lower << " " << proved->verdict.upper;
    EXPECT_TRUE(overlap(own, {proved->verdict.lower, proved->verdict.upper}));
    return proved;
  }

  [[nodiscard]] std::string file() const { return folder_.path("p.mwtproof"); }

 private:
  TestFolder folder_;
};

// Visits all families at these sizes and seeds, where they have them.
void for_each_instance(const std::vector<Index>& sizes, std::uint64_t seeds,
                       const std::function<void(const std::string& family, Points points)>& visit) {
  for (const GeneratorInfo& family : generators()) {
    for (const Index n : sizes) {
      for (std::uint64_t seed = 1; seed <= (family.seeded ? seeds : 1); ++seed) {
        std::vector<Point> points;
        try {
          points = make_point_set(generate(family.name, n, seed), family.name).points;
        } catch (const InputError&) {
          continue;
        }
        SCOPED_TRACE(family.name + " n=" + std::to_string(n) + " seed=" + std::to_string(seed));
        visit(family.name, points);
      }
    }
  }
}

TEST(Proof, OfEveryFamilyIsVerified) {
  const Prover prover;
  for_each_instance({8, 12, 25, 60}, 1,
                    [&](const std::string&, Points points) { prover.prove_optimum("exact", points); });
}

TEST(Proof, OptimaOfSmallSetsAreThoseOfEnumeration) {
  const Prover prover;
  int checked = 0;
  for_each_instance({6, 9, 11}, 1, [&](const std::string&, Points points) {
    const auto proved = prover.prove_optimum("exact", points);
    Context context;
    const AlgorithmInfo& enumeration = find_algorithm("subset_dp");
    context.parameters = Parameters(enumeration.name, enumeration.parameters, {});
    const Interval expected = *enumeration.function(points, context).optimum;
    if (!proved) return;
    EXPECT_TRUE(overlap(expected, {proved->verdict.lower, proved->verdict.upper}));
    ++checked;
  });
  EXPECT_GT(checked, 60);
}

// A thousand instances of all families: lattices, collinear triples, wheels that need branching.
TEST(ProofSlow, AThousandSmallSetsAreVerifiedAndRight) {
  const Prover prover;
  int checked = 0;
  for_each_instance({7, 8, 9, 10, 11, 12}, 9, [&](const std::string&, Points points) {
    const auto proved = prover.prove_optimum("exact", points);
    const AlgorithmInfo& enumeration = find_algorithm(points.size() <= 9 ? "brute_force" : "subset_dp");
    Context context;
    context.parameters = Parameters(enumeration.name, enumeration.parameters, {});
    const Interval expected = *enumeration.function(points, context).optimum;
    if (!proved) return;
    EXPECT_TRUE(overlap(expected, {proved->verdict.lower, proved->verdict.upper}));
    ++checked;
  });
  EXPECT_GT(checked, 1000);
}

TEST(Proof, OfLargerSetsIsVerified) {
  const Prover prover;
  for (const char* family : {"uniform", "normal", "clustered", "lattice", "grid", "integer_uniform"}) {
    SCOPED_TRACE(family);
    prover.prove_optimum("exact", make_point_set(generate(family, 3000, 1), family).points);
  }
}

TEST(Proof, OfTsplibIsVerified) {
  const Prover prover;
  int instances = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MWT_SOURCE_DIR "/harness/studies/tsplib")) {
    if (entry.path().extension() != ".tsp") continue;
    SCOPED_TRACE(entry.path().filename());
    prover.prove_optimum("exact", make_point_set(read_points(entry.path()), "tsplib").points);
    ++instances;
  }
  EXPECT_EQ(instances, 8);
}

TEST(Proof, DoesNotDependOnThreads) {
  const TestFolder folder;
  const std::vector<Point> points = generate("uniform", 20000, 1);
  const AlgorithmInfo& info = find_algorithm("exact");
  std::vector<std::vector<std::uint8_t>> files;
  for (const int threads : {1, 2}) {
    Context context;
    context.parameters = Parameters(info.name, info.parameters, {});
    context.threads = threads;
    ProofTrace trace;
    context.proof = &trace;
    const Solution solution = info.function(points, context);
    write_proof(folder.path("p"), points, trace, solution.triangulation, *solution.optimum);
    files.push_back(verifier::testing::read_file(folder.path("p")));
  }
  EXPECT_EQ(files[0], files[1]);
}

TEST(Proof, TracingChangesNothing) {
  const std::vector<Point> points = generate("clustered", 2000, 1);
  const AlgorithmInfo& info = find_algorithm("exact");
  Context plain, noting;
  plain.parameters = noting.parameters = Parameters(info.name, info.parameters, {});
  ProofTrace trace;
  noting.proof = &trace;
  const Solution one = info.function(points, plain), other = info.function(points, noting);
  EXPECT_EQ(one.triangulation.triangles, other.triangulation.triangles);
  EXPECT_EQ(one.optimum, other.optimum);
}

TEST(Proof, OfFacesWithHolesIsVerified) {
  const Prover prover;
  for (const char* family : {"wheel", "wheels"}) {
    for (const Index n : {5U, 6U, 8U, 9U, 14U, 15U, 31U}) {
      SCOPED_TRACE(std::string(family) + " n=" + std::to_string(n));
      prover.prove_optimum("exact", make_point_set(generate(family, n, 1), family).points);
    }
  }
}

// A ring whose face has more than one hole, and a plate with two that can be joined in many ways of nearly equal
// length.
TEST(Proof, OfFacesWithSeveralHolesIsVerified) {
  const Prover prover;
  prover.prove_optimum("exact", make_point_set(generate("annulus", 1500, 1), "annulus").points);
  prover.prove_optimum("exact", make_point_set(generate("cad_plate", 800, 2), "cad_plate").points);
}

TEST(Proof, OfOtherSolversIsVerified) {
  const Prover prover;
  for (const Index n : {4U, 9U, 40U}) {
    for (const char* family : {"circle", "parabola", "integer_circle", "ellipse"}) {
      SCOPED_TRACE(std::string(family) + " n=" + std::to_string(n));
      const auto points = make_point_set(generate(family, n, 1), family).points;
      prover.prove_optimum("polygon_dp", points);
      prover.prove_optimum("exact", points);
    }
  }
  for (const char* family : {"greedy_corridor", "flip_corridor", "greedy_ratio"}) {
    SCOPED_TRACE(family);
    prover.prove_optimum("two_chains", make_point_set(generate(family, 40, 1), family).points);
  }
  for (const char* family : {"uniform", "integer_uniform", "wheel", "lattice", "circle"}) {
    SCOPED_TRACE(family);
    prover.prove_optimum("triangle_lp", make_point_set(generate(family, 25, 1), family).points);
  }
}

// Beyond what the plain program takes.
TEST(Proof, OfLargerPolygonsIsVerified) {
  const Prover prover;
  for (const char* family : {"circle", "parabola"}) {
    SCOPED_TRACE(family);
    const auto points = make_point_set(generate(family, 600, 1), family).points;
    prover.prove_optimum("exact", points);
    prover.prove_optimum("polygon_dp", points);
  }
}

// Ones that `exact` hands to two_chains; edges far longer than those of the optimum took the dual values' precision.
TEST(ProofSlow, OfALargeCorridorIsVerified) {
  for (const char* family : {"greedy_corridor", "flip_corridor"}) {
    SCOPED_TRACE(family);
    Prover().prove_optimum("exact", make_point_set(generate(family, 1000, 1), family).points);
  }
}

// Polygons without dual values prove less, and say so.
TEST(Proof, OfPolygonsBeyondTheLimitProvesTheHull) {
  Context context;
  ProofTrace trace;
  context.proof = &trace;
  const auto points = make_point_set(generate("circle", 3000, 1), "circle").points;
  note_convex_polygon(points, convex_hull(points), {}, context);
  EXPECT_TRUE(trace.is_complete);
  EXPECT_TRUE(trace.regions.empty());
  EXPECT_EQ(trace.lower_bound, cycle_length(points, convex_hull(points)).lower);
}

// The same if there is no time, or no memory, for dual values.
TEST(Proof, OfPolygonsWithoutTimeOrMemoryProvesTheHull) {
  const auto points = make_point_set(generate("circle", 500, 1), "circle").points;
  for (const bool is_late : {true, false}) {
    Context context;
    ProofTrace trace;
    context.proof = &trace;
    if (is_late) context.deadline = Context::Clock::now();
    if (!is_late) context.memory_bytes = 1'000'000;
    note_convex_polygon(points, convex_hull(points), {}, context);
    EXPECT_TRUE(trace.is_complete);
    EXPECT_TRUE(trace.regions.empty());
    EXPECT_EQ(trace.lower_bound, cycle_length(points, convex_hull(points)).lower);
  }
}

// One hole, and every other spoke may be the one that cuts the wheel open.
TEST(Proof, OfAWheelIsVerified) {
  Prover().prove_optimum("exact", make_point_set(generate("wheel", 300, 1), "wheel").points);
}

// Where the beta-skeleton divides what the LMT-skeleton leaves in pieces.
TEST(Proof, OfDivisionByTheBetaSkeletonIsVerified) {
  const Prover prover;
  int divided = 0;
  for (const char* family : {"cluster_in_triangle", "annulus"}) {
    SCOPED_TRACE(family);
    const auto proved = prover.prove_optimum("exact", make_point_set(generate(family, 1000, 1), family).points);
    if (!proved) continue;
    const auto& counters = proved->solution.counters;
    const auto crossing = counters.find("edges_across_beta_skeleton");
    if (crossing != counters.end() && crossing->second > 0) ++divided;
  }
  EXPECT_GT(divided, 0);
}

// Collinear points on the hull's sides.
TEST(Proof, OfPolygonsWithFlatCornersIsVerified) {
  const Prover prover;
  const std::vector<Point> points = {{0, 0}, {1, 0}, {2, 0}, {5, 0}, {5, 1}, {5, 4}, {2, 5}, {0, 4}, {0, 3}, {0, 1}};
  prover.prove_optimum("polygon_dp", points);
  prover.prove_optimum("exact", points);
}

TEST(Proof, OfExtremeCoordinatesIsVerified) {
  const Prover prover;
  for (const int exponent : {-1060, -1000, -700, -300, 300, 900}) {
    SCOPED_TRACE(exponent);
    std::vector<Point> points = generate("uniform", 40, 1);
    for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    const std::vector<Point> distinct = make_point_set(points, "scaled").points;
    prover.prove("exact", distinct);
  }
}

TEST(Proof, OfBoundsIsVerified) {
  const Prover prover;
  const std::vector<Point> points = generate("uniform", 3000, 1);
  const auto proved = prover.prove("exact", points, Context::Clock::now());
  ASSERT_TRUE(proved);
  EXPECT_TRUE(proved->solution.stopped_early());
  EXPECT_FALSE(proved->verdict.is_optimal);
  EXPECT_GT(proved->verdict.lower, 0);
}

// Real proofs, with holes and branching, damaged: as the verifier's own tests do with those of their naive solver.
TEST(Proof, DamagedOnesAreRefusedOrStillTrue) {
  const Prover prover;
  const TestFolder folder;
  unsigned seed = 1;
  for (const char* family : {"uniform", "wheel", "lattice"}) {
    const std::vector<Point> points = make_point_set(generate(family, 40, 1), family).points;
    const auto proved = prover.prove_optimum("exact", points);
    ASSERT_TRUE(proved);
    const auto plain = verifier::testing::decompressed(verifier::testing::read_file(prover.file()));
    const verifier::testing::Proof proof = verifier::testing::Decoder(plain).proof();
    EXPECT_EQ(verifier::testing::encode(proof), plain);
    std::vector<Point> in_order;
    for (const Index p : proof.order) in_order.push_back(points[p]);
    for (const verifier::testing::Damage& damage : verifier::testing::damages()) {
      verifier::testing::Patient patient{proof, in_order};
      verifier::testing::Dice dice(seed++);
      if (!damage.apply(patient, dice)) continue;
      SCOPED_TRACE(std::string(family) + ": " + damage.name);
      verifier::testing::write_file(folder.path("p"),
                                    verifier::testing::file_of(verifier::testing::encode(patient.proof)));
      try {
        const Verdict verdict = verifier::verify(points, folder.path("p"));
        // Ties: another optimum may lack the edge that was called one of the optimum.
        if (std::string(family) == "uniform") {
          EXPECT_EQ(damage.harm, verifier::testing::Harm::possible);
        }
        EXPECT_LE(verdict.lower, proved->verdict.upper);
        EXPECT_GE(verdict.upper, proved->verdict.lower);
      } catch (const verifier::Refused&) {
      }
    }
  }
}

}  // namespace
}  // namespace mwt
