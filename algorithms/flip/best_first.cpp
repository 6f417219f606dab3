#include "algorithms/flip/best_first.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "algorithms/flip/counted_flips.h"
#include "algorithms/flip/improving_flip.h"
#include "geometry/mesh/kept_memory.h"

namespace mwt {

namespace {

// A possible flip: its gain and its edge. Larger ones come first, so as a time, larger is earlier.
using Candidate = std::pair<double, MeshEdge>;
constexpr Candidate kBeginning = {std::numeric_limits<double>::infinity(), 0};

using FlipNumber = std::uint32_t;
constexpr FlipNumber kNone = 0;

struct DoneFlip {
  Candidate time;
  MeshEdge edge;
  FlipNumber first_of_burst;
  FlipNumber previous;  // the flip of the same edge before
  std::uint32_t marks;  // of the edge before
};

// The flips that are done, in an order in which they can be done: where neighbourhoods meet, that of their times.
class FlipHistory {
 public:
  explicit FlipHistory(std::size_t edge_count) : last_(edge_count, kNone) {}

  // Flips done, those taken back among them.
  [[nodiscard]] std::size_t size() const { return flips_.size(); }
  [[nodiscard]] std::size_t taken_back() const { return taken_back_; }

  [[nodiscard]] FlipNumber next_number() const { return static_cast<FlipNumber>(flips_.size()) + 1; }
  [[nodiscard]] FlipNumber last_of(MeshEdge e) const { return last_[e]; }
  [[nodiscard]] const DoneFlip& operator[](FlipNumber flip) const { return flips_[flip - 1]; }

  [[nodiscard]] bool is_taken_back(FlipNumber flip) const { return last_[(*this)[flip].edge] < flip; }

  // Whether the last flip of e came after that time, or after another flip.
  [[nodiscard]] bool changed_after(MeshEdge e, const Candidate& time) const {
    return last_[e] != kNone && (*this)[last_[e]].time < time;
  }
  [[nodiscard]] bool changed_after(MeshEdge e, FlipNumber flip) const {
    if (last_[e] == kNone) return false;
    const Candidate &time = (*this)[last_[e]].time, &other = (*this)[flip].time;
    return time < other || (time == other && last_[e] > flip);
  }

  void add(const DoneFlip& flip) {
    last_[flip.edge] = next_number();
    flips_.push_back(flip);
  }
  void take_back(FlipNumber flip) {
    last_[(*this)[flip].edge] = (*this)[flip].previous;
    ++taken_back_;
  }

 private:
  KeptVector<FlipNumber> last_;  // of each edge
  KeptVector<DoneFlip> flips_;   // also those taken back
  std::size_t taken_back_ = 0;
};

class BestFirstSearch {
 public:
  BestFirstSearch(PlanarMesh& mesh, const Context& context, bool with_trace)
      : mesh_(mesh), flips_(mesh, context, with_trace), history_(mesh.edge_count()) {}

  FlipResult run(std::size_t portion) {
    while ((known_ < mesh_.edge_count() || !early_.empty()) && !flips_.stopped_early()) {
      const std::size_t rest = mesh_.edge_count() - known_;
      look_through(reaches_far() ? rest : std::min(rest, portion));
      play();
    }
    return flips_.take_result();
  }

 private:
  // Whether so much was done and taken back that it is cheaper to look through all edges now.
  [[nodiscard]] bool reaches_far() const {
    constexpr std::size_t kAlways = 8192, kCostOfTakingBack = 8;
    return known_ < mesh_.edge_count() &&
           history_.size() + kCostOfTakingBack * history_.taken_back() > known_ + kAlways;
  }

  [[nodiscard]] Candidate candidate(MeshEdge e) const { return {gain_of(mesh_, e), e}; }

  // The flips possible at the start among the next edges. Where done flips have changed the triangles, flips may seem
  // possible that were not; their gains differ when they are visited.
  void look_through(std::size_t count) {
    first_.swap(early_);
    early_.clear();
    for (const std::size_t end = known_ + count; known_ < end; ++known_) {
      if (improves(mesh_, known_)) first_.push_back(candidate(known_));
    }
  }

  // Adds first_ to the search. It is sorted, which is cheaper than a heap. What is left when flips reach far is played
  // with the rest of the edges.
  void play() {
    std::sort(first_.begin(), first_.end(), std::greater<Candidate>());
    now_ = kBeginning;
    std::size_t next = 0;
    while ((next < first_.size() || !later_.empty()) && !reaches_far() && !flips_.out_of_time()) {
      const bool is_first = later_.empty() || (next < first_.size() && later_.top() < first_[next]);
      const Candidate best = is_first ? first_[next++] : later_.top();
      if (!is_first) later_.pop();
      if (best < now_) begin_burst(best);
      visit(best);
    }
    early_.insert(early_.end(), first_.begin() + static_cast<std::ptrdiff_t>(next), first_.end());
  }

  void begin_burst(const Candidate& time) {
    now_ = time;
    first_of_burst_ = kNone;
  }

  void visit(const Candidate& best) {
    const MeshEdge e = best.second;
    rewind_around(e);
    // Flips nearby may have changed the quadrilateral; then a newer candidate stands for it.
    if (best.first != gain_of(mesh_, e) || !improves(mesh_, e)) return;
    look_early_at_sides(e);
    flip(e);
    for (const MeshEdge side : sides_of(mesh_, e)) {
      if (improves(mesh_, side)) later_.push(candidate(side));
    }
  }

  void look_early_at_sides(MeshEdge e) {
    for (const MeshEdge side : sides_of(mesh_, e)) {
      if (side >= known_ && improves(mesh_, side)) early_.push_back(candidate(side));
    }
  }

  void flip(MeshEdge e) {
    if (first_of_burst_ == kNone) first_of_burst_ = history_.next_number();
    history_.add({now_, e, first_of_burst_, history_.last_of(e), mesh_.marks(e)});
    flips_.flip(e);
  }

  // Makes the neighbourhood of e what it is now_.
  void rewind_around(MeshEdge e) {
    const auto is_later = [&](MeshEdge near) { return history_.changed_after(near, now_); };
    while (const auto later = find_around(e, is_later)) take_back(history_.last_of(*later));
    if (!restored_.empty()) reconsider_restored();
  }

  // An edge with that property in the neighbourhood of e: among the edges of the triangles at e and beyond its sides.
  template <class Property>
  [[nodiscard]] std::optional<MeshEdge> find_around(MeshEdge e, Property has_property) const {
    if (has_property(e)) return e;
    for (const MeshEdge side : sides_of(mesh_, e)) {
      if (has_property(side)) return side;
      if (mesh_.is_hull(side)) continue;
      for (const MeshEdge beyond : sides_of(mesh_, side)) {
        if (has_property(beyond)) return beyond;
      }
    }
    return std::nullopt;
  }

  // Takes back a flip, before it all that came after it around it, and after it the rest of its burst.
  void take_back(FlipNumber flip) {
    std::vector<FlipNumber> pending = {flip};
    while (!pending.empty()) {
      const FlipNumber top = pending.back();
      if (history_.is_taken_back(top)) {
        pending.pop_back();
        continue;
      }
      const auto came_after = [&](MeshEdge near) { return history_.changed_after(near, top); };
      if (const auto after = find_around(history_[top].edge, came_after)) {
        pending.push_back(history_.last_of(*after));
      } else {
        take_back_alone(top);
        pending.back() = history_[top].first_of_burst;
      }
    }
  }

  void take_back_alone(FlipNumber flip) {
    const MeshEdge e = history_[flip].edge;
    flips_.take_back(e);
    mesh_.marks(e) = history_[flip].marks;
    history_.take_back(flip);
    restored_.push_back(e);
  }

  // Flips that are possible again join the search, unless their time is over: then they are not known yet.
  void reconsider_restored() {
    std::vector<MeshEdge> edges = restored_;
    for (const MeshEdge e : restored_) {
      for (const MeshEdge side : sides_of(mesh_, e)) edges.push_back(side);
    }
    restored_.clear();
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const MeshEdge e : edges) {
      if (improves(mesh_, e) && candidate(e) < now_) later_.push(candidate(e));
    }
  }

  PlanarMesh& mesh_;
  CountedFlips flips_;
  FlipHistory history_;
  MeshEdge known_ = 0;                    // edges below this number have been looked through
  std::vector<Candidate> first_, early_;  // possible at the start: in this portion, in the next
  std::priority_queue<Candidate> later_;  // possible by flips
  Candidate now_ = kBeginning;            // the time
  FlipNumber first_of_burst_ = kNone;     // the first flip of that time
  std::vector<MeshEdge> restored_;        // edges whose last flip was taken back
};

}  // namespace

FlipResult flip_best_first(PlanarMesh& mesh, const Context& context, bool with_trace, std::size_t portion) {
  return BestFirstSearch(mesh, context, with_trace).run(with_trace ? mesh.edge_count() : portion);
}

}  // namespace mwt
