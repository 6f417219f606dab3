// What every family promises, checked for every entry of the registry.
#include "generators/registry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "generators/testing.h"
#include "geometry/convex_hull.h"

namespace mwt {
namespace {

bool is_legal(const GeneratorInfo& family, Index n) { return n >= family.min_n && n <= family.max_n; }

std::vector<Index> legal_sizes(const GeneratorInfo& family) {
  if (family.fixed_n != 0) return {family.fixed_n};
  std::vector<Index> sizes = {3, 4, 5, 6, 7, 10, 100, 1000};
  std::erase_if(sizes, [&](Index n) { return !is_legal(family, n); });
  return sizes;
}

class EveryFamily : public testing::TestWithParam<std::string> {
 protected:
  const GeneratorInfo& family_ = find_generator(GetParam());
};

TEST_P(EveryFamily, introduces_itself) {
  for (const std::string& text : {family_.summary, family_.source, family_.stresses, family_.law}) {
    EXPECT_FALSE(text.empty());
    EXPECT_EQ(text.find('\n'), std::string::npos);
  }
  EXPECT_GE(family_.min_n, 3U);
  EXPECT_LE(family_.min_n, family_.max_n);
  if (family_.fixed_n != 0) {
    EXPECT_EQ(family_.min_n, family_.fixed_n);
    EXPECT_EQ(family_.max_n, family_.fixed_n);
  }
  ASSERT_NE(family_.function, nullptr);
  EXPECT_NO_THROW(Parameters(family_.name, family_.parameters,
                             [&] {
                               std::map<std::string, std::string> defaults;
                               for (const ParameterInfo& info : family_.parameters)
                                 defaults[info.name] = info.default_value;
                               return defaults;
                             }()))
      << "the defaults are values that a user could give";
}

TEST_P(EveryFamily, gives_exactly_n_distinct_finite_points_off_one_line) {
  for (const Index n : legal_sizes(family_)) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const std::vector<Point> points = generate(family_.name, n, seed);
      EXPECT_EQ(points.size(), n);
      const PointSet set = make_point_set(points, family_.name);  // throws unless finite and off one line
      const bool is_distinct = set.duplicates() == 0;
      EXPECT_TRUE(is_distinct || family_.repeats_points) << "n=" << n << " seed=" << seed;
      const bool has_negative_zero = std::any_of(points.begin(), points.end(), [](const Point& p) {
        return (p.x == 0 && std::signbit(p.x)) || (p.y == 0 && std::signbit(p.y));
      });
      EXPECT_FALSE(has_negative_zero);
    }
  }
}

TEST_P(EveryFamily, depends_on_the_seed_exactly_if_it_says_so) {
  for (const Index n : legal_sizes(family_)) {
    EXPECT_EQ(generate(family_.name, n, 7), generate(family_.name, n, 7));
    EXPECT_EQ(generate(family_.name, n, 7) != generate(family_.name, n, 8), family_.seeded) << "n=" << n;
  }
}

TEST_P(EveryFamily, refuses_other_sizes_and_names_the_nearest_legal_one) {
  const auto nearest = [](Index n) { return "nearest legal n is " + std::to_string(n); };
  EXPECT_NE(refusal(family_.name, family_.min_n - 1).find(nearest(family_.min_n)), std::string::npos);
  EXPECT_NE(refusal(family_.name, 0).find(nearest(family_.min_n)), std::string::npos);
  EXPECT_NE(refusal(family_.name, family_.max_n + 1).find(nearest(family_.max_n)), std::string::npos);
  EXPECT_EQ(refusal(family_.name, 1).find(family_.name + ": "), 0U);
}

TEST_P(EveryFamily, has_one_hull_by_both_methods) {
  for (const Index n : legal_sizes(family_)) {
    const PointSet set = make_point_set(generate(family_.name, n, 1), family_.name);
    EXPECT_EQ(graham_scan(set.points), monotone_chain(set.points)) << "n=" << n;
  }
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const GeneratorInfo& family : generators()) names.push_back(family.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Generators, EveryFamily, testing::ValuesIn(family_names()),
                         [](const auto& family) { return family.param; });

TEST(GeneratorRegistry, names_are_unique) {
  const std::vector<std::string> names = family_names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(GeneratorRegistry, unknown_names_and_parameters_are_refused) {
  EXPECT_NE(refusal("unifrom", 10).find("unknown generator 'unifrom'; known: uniform, "), std::string::npos);
  EXPECT_NE(refusal("uniform", 10, {{"sigma", "1"}}).find("uniform: unknown parameter 'sigma'"), std::string::npos);
  EXPECT_NE(refusal("clustered", 10, {{"sigma", "wide"}}).find("clustered: parameter sigma=wide"), std::string::npos);
}

TEST(GeneratorRegistry, families_with_the_same_seed_share_no_stream) {
  const std::vector<Point> square = generate("uniform", 100, 1);
  std::set<double> seen;
  for (const Point& p : square) seen.insert({p.x, p.y});
  for (const Point& p : generate("near_collinear", 100, 1, {{"height", "1"}})) EXPECT_FALSE(seen.contains(p.y));
  for (const Point& p : generate("far_from_origin", 100, 1, {{"offset", "0"}})) EXPECT_FALSE(seen.contains(p.x));
}

}  // namespace
}  // namespace mwt
