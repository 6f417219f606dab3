#include "verifier/verify.h"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/error.h"
#include "verifier/bounds.h"
#include "verifier/diamond.h"
#include "verifier/point_tree.h"
#include "verifier/proof_reader.h"
#include "verifier/reductions.h"
#include "verifier/refused.h"
#include "verifier/regions.h"
#include "verifier/triangulation.h"

namespace mwt::verifier {

namespace {

enum class Step : std::uint8_t { end = 0, not_minimal = 1, crossing = 2, uncrossed = 3, beta_skeleton = 4, region = 5 };

constexpr std::size_t kHashBytes = 32;
constexpr std::uint64_t kLongestStep = 1 << 16;  // edges
constexpr double kMaxCoordinate = 1e300;         // beyond it, differences are no doubles

// The positions of the first of equal points each, ascending. -0 equals 0.
std::vector<Index> first_positions(const std::vector<Point>& input) {
  std::vector<Index> order(input.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
  const auto is_before = [&](Index a, Index b) {
    const Point &p = input[a], &q = input[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
  };
  std::sort(order.begin(), order.end(), is_before);
  const auto last = std::unique(order.begin(), order.end(), [&](Index a, Index b) { return input[a] == input[b]; });
  order.erase(last, order.end());
  std::sort(order.begin(), order.end());
  return order;
}

// Of x0 y0 x1 y1 ... as little-endian doubles.
std::array<std::uint8_t, kHashBytes> hash_of(const std::vector<Point>& points) {
  std::vector<std::uint8_t> bytes;
  for (const Point& p : points) {
    for (const double value : {p.x, p.y}) {
      const auto bits = std::bit_cast<std::uint64_t>(value);
      for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
    }
  }
  std::array<std::uint8_t, kHashBytes> hash{};
  unsigned length = 0;
  const int is_done = EVP_Digest(bytes.data(), bytes.size(), hash.data(), &length, EVP_sha256(), nullptr);
  if (is_done != 1 || length != kHashBytes) throw std::runtime_error("SHA-256 is not available");
  return hash;
}

class Verification {
 public:
  Verification(const std::vector<Point>& input, const std::string& proof_file) : proof_(proof_file) {
    for (const Point& p : input) {
      const bool is_usable = std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate;
      if (!is_usable) throw InputError("the points have a coordinate that is no number up to 1e300");
    }
    positions_ = first_positions(input);
    for (const Index i : positions_) points_.push_back({input[i].x + 0.0, input[i].y + 0.0});  // -0 becomes 0
    if (hull_of(points_).empty()) throw InputError("the points have no triangulation: all lie on one line");
  }

  Verdict run() {
    try {
      return check();
    } catch (const Refused& refused) {
      const std::string edge = edge_ > 0 ? fmt::format(", edge {}", edge_) : "";
      std::string message = where_ + edge + ": " + refused.what();
      if (!refused.points().empty()) message += ": points";
      for (const Index p : refused.points()) message += " " + name(p);
      throw Refused(message);
    }
  }

 private:
  Verdict check() {
    read_instance();
    read_order();
    hull_ = hull_of(points_);
    read_triangulation();
    where_ = "diamond test";
    tree_.emplace(points_);
    reductions_.emplace(points_, *tree_, diamond_candidates(points_, *tree_), hull_);
    verdict_.candidates = edge_count(reductions_->candidates());
    Step step = read_step();
    for (; step != Step::region && step != Step::end; step = read_step()) reduce(step);
    verdict_.removed = verdict_.candidates - edge_count(reductions_->candidates());
    verdict_.certain = edge_count(reductions_->certain());
    Regions regions(points_, *tree_, *reductions_, hull_);
    for (; step == Step::region; step = read_step()) regions.read(proof_);
    verdict_.regions = regions.count();
    require(step == Step::end, "reductions must not follow regions");
    proof_.expect_end();
    where_ = "all regions";
    conclude(regions);
    return verdict_;
  }

  void read_instance() {
    where_ = "instance";
    verdict_.points = points_.size();
    require(proof_.number() == points_.size(), "the proof is about another number of points");
    for (const std::uint8_t byte : hash_of(points_)) require(proof_.byte() == byte, "the proof is about other points");
    claimed_lower_ = proof_.real();
    claimed_upper_ = proof_.real();
  }

  // From here on points are named by their positions in the proof's order.
  void read_order() {
    where_ = "order";
    std::vector<bool> is_used(points_.size(), false);
    std::vector<Point> points;
    std::vector<Index> positions;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto p = static_cast<Index>(proof_.number_below(points_.size()));
      require(!is_used[p], "a point appears twice");
      is_used[p] = true;
      points.push_back(points_[p]);
      positions.push_back(positions_[p]);
    }
    points_ = std::move(points);
    positions_ = std::move(positions);
  }

  void read_triangulation() {
    where_ = "triangulation";
    const std::uint64_t count = proof_.number_below(2 * points_.size());
    Index last = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const Index a = proof_.index_near(last, points_.size());
      const Index b = proof_.index_near(a, points_.size());
      triangles_.push_back({a, b, proof_.index_near(b, points_.size())});
      last = a;
    }
    check_triangulation(points_, hull_, triangles_);
  }

  Step read_step() {
    ++steps_;
    where_ = fmt::format("step {}", steps_);
    return static_cast<Step>(proof_.number_below(static_cast<std::uint64_t>(Step::region) + 1));
  }

  // A list of edges with the same reason.
  void reduce(Step step) {
    const std::uint64_t count = proof_.number_below(kLongestStep + 1);
    std::vector<std::array<Index, 2>> edges;
    Index last = 0;
    for (std::uint64_t i = 0; i < count; ++i) edges.push_back({last = proof_.index_near(last, points_.size()), 0});
    for (auto& [a, b] : edges) {
      b = proof_.index_near(a, points_.size());
      require(a != b, "an edge ends where it begins", {a, b});
    }
    for (const auto& [a, b] : edges) {
      ++edge_;
      switch (step) {
        case Step::not_minimal: reductions_->remove_not_minimal(a, b); break;
        case Step::uncrossed: reductions_->mark_uncrossed(a, b); break;
        case Step::beta_skeleton: reductions_->mark_beta_skeleton(a, b); break;
        case Step::crossing: {
          const Index c = proof_.index_near(a, points_.size());
          reductions_->remove_crossing(a, b, c, proof_.index_near(c, points_.size()));
          break;
        }
        case Step::region:
        case Step::end: break;
      }
    }
    edge_ = 0;
  }

  void conclude(const Regions& regions) {
    verdict_.lower = lower_double(reductions_->weight_of_certain() + regions.lower_bound(triangles_));
    const Bounds weight = weight_of(points_, triangles_, hull_);
    verdict_.upper = upper_double(weight);
    where_ = "conclusion";
    if (!is_narrow(verdict_.lower, verdict_.upper)) {
      verdict_.lower = std::max(verdict_.lower, lower_double(reductions_->bound_by_degrees(hull_)));
    }
    if (verdict_.lower > verdict_.upper) throw std::logic_error("the lower bound is above the triangulation's weight");
    verdict_.is_optimal = is_narrow(verdict_.lower, verdict_.upper);
    const bool is_claim = 0 <= claimed_lower_ && claimed_lower_ <= claimed_upper_;
    require(is_claim && claimed_lower_ <= verdict_.upper && claimed_upper_ >= lower_double(weight),
            "the interval claimed contradicts the one proved");
    if (verdict_.lower < claimed_lower_ * (1 - kOptimalWidth) ||
        verdict_.upper > claimed_upper_ * (1 + kOptimalWidth)) {
      throw Refused(fmt::format("less is proved than claimed: [{:.17g}, {:.17g}] instead of [{:.17g}, {:.17g}]",
                                verdict_.lower, verdict_.upper, claimed_lower_, claimed_upper_));
    }
  }

  static std::size_t edge_count(const EdgeSet& edges) {
    std::size_t ends = 0;
    for (std::size_t v = 0; v < edges.point_count(); ++v) ends += edges.star(static_cast<Index>(v)).size();
    return ends / 2;
  }

  // The position in the file. While the order is not known no message names points.
  [[nodiscard]] std::string name(Index p) const { return std::to_string(positions_[p]); }

  ProofReader proof_;
  std::vector<Point> points_;
  std::vector<Index> positions_;  // in the file
  std::vector<Index> hull_;
  double claimed_lower_ = 0, claimed_upper_ = 0;
  std::vector<Corners> triangles_;
  std::optional<PointTree> tree_;
  std::optional<Reductions> reductions_;
  Verdict verdict_;
  std::string where_;
  std::uint64_t steps_ = 0, edge_ = 0;  // edge_: of the list at hand; 0 outside lists
};

}  // namespace

Verdict verify(const std::vector<Point>& points, const std::string& proof_file) {
  return Verification(points, proof_file).run();
}

}  // namespace mwt::verifier
