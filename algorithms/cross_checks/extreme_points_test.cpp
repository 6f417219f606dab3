// Every algorithm at the limits of floating point: flat sets, tiny and huge ones, many magnitudes in one set.
#include "algorithms/common/testing/extreme_points.h"

#include <algorithm>
#include <set>
#include <string>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/greedy/greedy_builder.h"
#include "generators/registry.h"
#include "geometry/numbers/scaling.h"

namespace mwt {
namespace {

using test::ExtremePoints;

// What a solver finds and claims; nothing where it is not applicable.
struct Answer {
  std::string solver;
  Solution solution;
  Interval weight;         // as the caller sees it
  Interval scaled_weight;  // on exactly scaled points, whose lengths keep their digits
};

std::optional<Answer> answer_of(const std::string& solver, Points points, Deadline deadline = {}) {
  try {
    Solution solution = solve_and_check(solver, points, {}, deadline);
    const Interval found = weight(points, solution.triangulation);
    const Interval scaled = weight(exactly_scaled(points), solution.triangulation);
    return Answer{solver, std::move(solution), found, scaled};
  } catch (const NotApplicable&) {
    return {};
  }
}

constexpr double kProvedWidth = 1e-12;

bool claims_the_optimum(const Answer& answer) {
  if (!answer.solution.optimum || answer.solution.stopped_early()) return false;
  const bool is_denormal = answer.weight.upper < 0x1p-1000;  // where no interval of doubles is as narrow as a proof's
  return is_denormal || answer.solution.optimum->relative_width() <= kProvedWidth;
}

// No certified bound is contradicted, and optimal triangulations weigh the same within what a proof leaves open.
void expect_agreement(const std::vector<Answer>& answers) {
  for (const Answer& one : answers) {
    for (const Answer& other : answers) {
      if (one.solution.optimum) {
        ASSERT_LE(one.solution.optimum->lower, other.weight.upper) << one.solver << " against " << other.solver;
      }
      if (claims_the_optimum(one) && claims_the_optimum(other)) {
        ASSERT_LE(one.scaled_weight.lower, other.scaled_weight.upper * (1 + kProvedWidth))
            << one.solver << " against " << other.solver;
      }
    }
  }
}

// Calls check(points) for sets of all kinds in turn, of size_of(round) points, and stops at the first that fails.
template <class SizeOf, class Check>
void for_each_set(std::uint64_t first_seed, std::uint64_t sets, const SizeOf& size_of, const Check& check) {
  for (std::uint64_t i = 0; i < sets; ++i) {
    const auto kind = static_cast<ExtremePoints::Kind>(i % ExtremePoints::kKinds);
    const std::size_t n = size_of(i / ExtremePoints::kKinds);
    const std::vector<Point> points = ExtremePoints(first_seed + i).draw(kind, n);
    if (points.empty()) continue;
    SCOPED_TRACE(testing::Message() << "kind " << kind << ", seed " << first_seed + i << ", n " << n);
    check(points);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

// Solves sets of 4 to `max_n` points of all kinds; prints how many `exact` left open.
void compare_solvers(std::uint64_t first_seed, std::uint64_t sets, std::size_t max_n) {
  std::uint64_t open = 0;
  const auto size_of = [=](std::uint64_t round) -> std::size_t { return 4 + round % (max_n - 3); };
  for_each_set(first_seed, sets, size_of, [&](const std::vector<Point>& points) {
    std::vector<Answer> answers;
    for (const char* solver : {"exact", "subset_dp", "brute_force", "polygon_dp", "two_chains"}) {
      if (solver == std::string("brute_force") && points.size() > 8) continue;
      if (auto answer = answer_of(solver, points)) answers.push_back(*std::move(answer));
    }
    expect_agreement(answers);
    open += claims_the_optimum(answers.front()) ? 0 : 1;
  });
  EXPECT_LE(open, sets / 500) << "exact, where linear programs are numerically hard";
}

TEST(ExtremePoints, ExactSolversAgree) { compare_solvers(1, 4000, 9); }

TEST(ExtremePointsSlow, ExactSolversAgreeOnAMillionSets) { compare_solvers(1'000'000, 1'000'000, 8); }

TEST(ExtremePointsSlow, ExactSolversAgreeOnLargerSets) { compare_solvers(3'000'000, 100'000, 12); }

// Where the k-d tree has several leaves. The triangle program may not come to an end: its bounds count.
void compare_with_the_triangle_program(std::uint64_t first_seed, std::uint64_t sets, std::size_t min_n,
                                       std::size_t max_n) {
  const auto size_of = [=](std::uint64_t round) -> std::size_t { return min_n + round % (max_n + 1 - min_n); };
  for_each_set(first_seed, sets, size_of, [&](const std::vector<Point>& points) {
    std::vector<Answer> answers;
    for (const char* solver : {"exact", "triangle_lp", "greedy", "patch"}) {
      answers.push_back(*answer_of(solver, points, Context::Clock::now() + std::chrono::milliseconds(100)));
    }
    expect_agreement(answers);
  });
}

TEST(ExtremePoints, ExactAgreesWithTheTriangleProgram) { compare_with_the_triangle_program(5'000'000, 160, 4, 30); }

TEST(ExtremePointsSlow, ExactAgreesWithTheTriangleProgram) {
  compare_with_the_triangle_program(6'000'000, 8'000, 10, 40);
}

// Flat lattices: heights are integers times 2^-octaves.
std::vector<Point> flat_lattice(std::size_t n, int octaves, std::mt19937_64& random) {
  const std::uint64_t side = 3 + random() % (random() % 2 == 0 ? 6 : 60);
  std::vector<Point> points(n);
  for (Point& p : points) {
    p.x = static_cast<double>(random() % side);
    p.y = std::ldexp(static_cast<double>(random() % side), -octaves);
  }
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void compare_on_flat_lattices(std::uint64_t first_seed, std::uint64_t sets, int min_octaves, int max_octaves) {
  for (std::uint64_t seed = first_seed; seed < first_seed + sets; ++seed) {
    std::mt19937_64 random(seed);
    const auto octaves = static_cast<std::uint64_t>(max_octaves - min_octaves + 1);
    const int height = min_octaves + static_cast<int>(random() % octaves);
    const std::vector<Point> points = flat_lattice(4 + random() % 8, height, random);
    if (points.size() < 3 || all_collinear(points)) continue;
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", octaves " << height);
    expect_agreement({*answer_of("exact", points), *answer_of("subset_dp", points)});
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

// Here `exact` proved wrong optima, or ended with an internal failure.
TEST(ExtremePoints, ExactIsRightOnFlatLattices) { compare_on_flat_lattices(1, 2000, 195, 215); }

TEST(ExtremePointsSlow, ExactIsRightOnAHundredThousandFlatLattices) { compare_on_flat_lattices(1, 100'000, 100, 1000); }

void expect_optimum(const std::string& solver, Points points, const Interval& expected) {
  const Interval optimum = *solve_to_optimality(solver, points).optimum;
  EXPECT_TRUE(overlap(optimum, expected)) << solver << ": " << optimum.lower << " to " << optimum.upper;
}

// It proved 5.25123.
TEST(ExtremePoints, ExactIsRightOnPointsInAStripOfHeight3em63) {
  const std::vector<Point> points = generate("near_collinear", 11, 4, {{"height", "3e-63"}});
  for (const char* solver : {"exact", "subset_dp", "brute_force"}) {
    expect_optimum(solver, points, {5.0075612681459, 5.0075612681460});
  }
}

// It proved 2.57227.
TEST(ExtremePoints, ExactIsRightOnFiveFlatPoints) {
  const std::vector<Point> points = {{0.77172854574337246, 2.6183228769597503e-63},
                                     {0.85298579037003674, 2.1059701968539549e-63},
                                     {0.9462573054745721, 5.5833153673324228e-63},
                                     {0.14761292726287031, 4.3270356583517645e-63},
                                     {0.86681111908251451, 2.5452489326083183e-63}};
  for (const char* solver : {"exact", "subset_dp", "brute_force", "triangle_lp"}) {
    expect_optimum(solver, points, {2.5704618943663, 2.5704618943664});
  }
}

// It failed: "isolated vertices without candidates to a face".
TEST(ExtremePoints, ExactSolvesFourFlatPoints) {
  const std::vector<Point> points = {{-1.0812422590043267e-64, 0.27924710392474872},
                                     {-5.941185272744042e-64, 0.93710331224903254},
                                     {-2.9720537816637651e-64, 0.31023861912827583},
                                     {-1.2918542995165705e-64, 0.28706867075428077}};
  for (const char* solver : {"exact", "subset_dp", "brute_force", "triangle_lp"}) {
    expect_optimum(solver, points, {1.9967385733468, 1.9967385733469});
  }
}

// Both diagonals, 2 and the root of 5 times the smallest double, are 2 of these, but one triangulation is lighter.
TEST(ExtremePoints, SolversTellDenormalLengthsApart) {
  constexpr double kStep = std::numeric_limits<double>::denorm_min();
  const std::vector<Point> points = {{0, 0}, {kStep, -kStep}, {2 * kStep, kStep}, {kStep, kStep}};
  for (const char* solver : {"exact", "subset_dp", "brute_force", "triangle_lp", "polygon_dp"}) {
    const std::vector<Edge> edges = edges_of(solve_and_check(solver, points).triangulation);
    EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), Edge{1, 3})) << solver;
  }
}

std::vector<Edge> greedy_edges(Points points, std::size_t large_face) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  build_greedy(mesh, Context{}, large_face);
  return edges_of(mesh.triangulation());
}

void compare_greedy(std::uint64_t first_seed, std::uint64_t sets, std::size_t max_n) {
  const auto size_of = [=](std::uint64_t round) -> std::size_t { return 4 + round * 7 % (max_n - 3); };
  for_each_set(first_seed, sets, size_of, [&](const std::vector<Point>& points) {
    const std::vector<Edge> expected = edges_of(solve_and_check("greedy_naive", points).triangulation);
    ASSERT_EQ(edges_of(solve_and_check("greedy", points).triangulation), expected);
    ASSERT_EQ(greedy_edges(points, 0), expected) << "faces reduced before the queue";
  });
}

TEST(ExtremePoints, GreedyEqualsGreedyNaive) { compare_greedy(7'000'000, 1600, 20); }

TEST(ExtremePointsSlow, GreedyEqualsGreedyNaive) { compare_greedy(8'000'000, 60'000, 40); }

// Among others: greedy and patch crashed, flip returned flat triangles, quadtree ran forever.
void check_all_algorithms(std::uint64_t first_seed, std::uint64_t sets, std::size_t max_n) {
  const auto size_of = [=](std::uint64_t round) -> std::size_t { return 4 + round * 7 % (max_n - 3); };
  for_each_set(first_seed, sets, size_of, [&](const std::vector<Point>& points) {
    std::vector<Answer> answers;
    for (const AlgorithmInfo& algorithm : algorithms()) {
      const bool takes_long = algorithm.name == "brute_force" || algorithm.name == "subset_dp";
      if (takes_long && points.size() > 8) continue;
      const auto deadline = Context::Clock::now() + std::chrono::milliseconds(100);
      if (auto answer = answer_of(algorithm.name, points, deadline)) answers.push_back(*std::move(answer));
    }
    expect_agreement(answers);
  });
}

TEST(ExtremePoints, EveryAlgorithmIsValid) { check_all_algorithms(9'000'000, 400, 24); }

TEST(ExtremePointsSlow, EveryAlgorithmIsValid) { check_all_algorithms(10'000'000, 10'000, 40); }

// Where coordinates span 2^1600, differences vanished from the integers by which circles were compared: flip returned
// flat triangles.
TEST(ExtremePoints, MeshesAreValidWhereDifferencesVanish) {
  std::vector<Point> points;
  for (const auto& [x, y] : {std::pair{1, 2},
                             {4, 0},
                             {1, 0},
                             {3, 4},
                             {6, 6},
                             {7, 3},
                             {2, 4},
                             {0, 2},
                             {1, 5},
                             {7, 1},
                             {5, 0},
                             {2, 3},
                             {5, 3}}) {
    points.push_back({std::ldexp(x, 613), std::ldexp(y, -992)});
  }
  for (const char* algorithm : {"greedy", "flip", "patch", "quadtree", "annealing"}) {
    (void)solve_and_check(algorithm, points);
  }
}

}  // namespace
}  // namespace mwt
