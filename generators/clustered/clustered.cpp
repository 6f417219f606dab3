#include "generators/clustered/clustered.h"

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

namespace {

// Takes the standard normal point (s, t) to centre + s first_axis + t second_axis. The axes are orthogonal and as long
// as the standard deviations, so the covariance is first_axis first_axis' + second_axis second_axis'.
struct Cluster {
  Point centre;
  Point first_axis;
  Point second_axis;

  [[nodiscard]] Point at(const Point& standard) const {
    return {centre.x + (standard.x * first_axis.x + standard.y * second_axis.x),
            centre.y + (standard.x * first_axis.y + standard.y * second_axis.y)};
  }
};

Cluster random_cluster(RandomEngine& engine, double sigma, ClusterShape shape) {
  const Point centre = uniform_in_square(engine);
  if (shape == ClusterShape::isotropic) return {centre, {sigma, 0}, {0, sigma}};
  const Point direction = random_direction(engine);
  const double first = sigma * (.25 + 1.5 * uniform_unit(engine));
  const double second = sigma * (.25 + 1.5 * uniform_unit(engine));
  return {centre, {first * direction.x, first * direction.y}, {-second * direction.y, second * direction.x}};
}

std::vector<Point> clustered(Index n, std::uint64_t seed, const Parameters& parameters) {
  const auto clusters = integer_within("clustered", parameters, "clusters", 1, 1'000'000);
  const double sigma = real_within("clustered", parameters, "sigma", 1e-300, 1e150);
  const bool isotropic = parameters.text("shape") == "isotropic";
  return clustered_points(n, seed, static_cast<Index>(clusters), sigma,
                          isotropic ? ClusterShape::isotropic : ClusterShape::elliptic);
}

}  // namespace

GeneratorInfo clustered_entry() {
  return {.name = "clustered",
          .summary = "Gaussian clusters with random centres and covariances",
          .source = "the common clustered test model, as in Bentley's and in the DIMACS challenges' instances",
          .stresses = "claims C4 and C6 on uneven input: Delaunay's and insertion's long edges between clusters",
          .law = "none known; greedy reaches 1.03 at n=10, Delaunay 1.03 to 1.05",
          .max_n = kMaxPoints,
          .parameters = {{"clusters", ParameterType::integer, "5", "number of clusters, at least 1"},
                         {"sigma", ParameterType::real, "0.05",
                          "standard deviation of a cluster (elliptic: their mean over its axes), above 0"},
                         {"shape",
                          ParameterType::choice,
                          "elliptic",
                          "elliptic: random rotation and axes; isotropic: round clusters",
                          {"elliptic", "isotropic"}}},
          .function = clustered};
}

std::vector<Point> clustered_points(Index n, std::uint64_t seed, Index clusters, double sigma, ClusterShape shape) {
  RandomEngine engine = make_engine("clustered", seed);
  std::vector<Cluster> all;
  for (Index i = 0; i < clusters; ++i) all.push_back(random_cluster(engine, sigma, shape));
  return draw_distinct_points("clustered", n, [&](Index) {
    const Cluster& cluster = all[uniform_below(engine, clusters)];
    return cluster.at(standard_normal_point(engine));
  });
}

}  // namespace mwt
