#include "harness/explore/played_steps.h"

#include <algorithm>
#include <array>
#include <utility>

#include "algorithms/step_trace.h"
#include "harness/explore/frame.h"

namespace mwt {

namespace {

using Kind = PlayedStep::Kind;

// Puts together what an algorithm noted.
class TracePlayer {
 public:
  TracePlayer(const StepTrace& trace, const PointSet& set) : trace_(trace), set_(set) {}

  PlayedSteps play(const Solution& solution) {
    played_.start = edges_of({set_.input_count, to_input_indices(set_, trace_.start)});
    shown_.insert(played_.start.begin(), played_.start.end());
    if (!trace_.kept.empty()) {
      play_greedy();
    } else if (!trace_.cells.empty()) {
      play_quadtree();
    } else if (!trace_.patches.empty()) {
      play_patches();
    } else if (!trace_.flips.empty()) {
      play_annealing();
    } else if (!trace_.splits.empty()) {
      play_insertion();
    } else {
      played_.begin_stage("start", "is in the start, which nothing changes");
    }
    played_.arrive_at(solution, set_, shown_, "result", "is in what the algorithm returns");
    return std::move(played_);
  }

 private:
  [[nodiscard]] Edge in_input(const Edge& edge) const {
    return make_edge(set_.input_indices[edge.a], set_.input_indices[edge.b]);
  }

  void put(const Edge& edge) {
    if (shown_.insert(edge).second) played_.add(Kind::add, edge);
  }

  void drop(const Edge& edge) {
    if (shown_.erase(edge) > 0) played_.add(Kind::remove, edge);
  }

  // Makes the steps that `make` adds one.
  template <class Make>
  void group(Index point, double gain, const Make& make) {
    const std::size_t head = played_.steps.size();
    played_.add(Kind::group, {0, point}, {kNoIndex, kNoIndex}, gain);
    make();
    played_.steps[head].a = static_cast<Index>(played_.steps.size() - head - 1);
  }

  void play_greedy() {
    played_.begin_stage("greedy", "is the shortest that crosses none taken before");
    for (const Edge& edge : trace_.kept) put(in_input(edge));
  }

  // A split joins the corners to the point; where the point lies on a side, that side leaves first. Splits of the same
  // point follow each other.
  void play_insertion() {
    played_.begin_stage("insertion", "joins an inserted point to a corner of the triangle that holds it");
    for (std::size_t i = 0; i < trace_.splits.size();) {
      const Index point = trace_.splits[i].point;
      group(set_.input_indices[point], 0, [&] {
        for (; i < trace_.splits.size() && trace_.splits[i].point == point; ++i) split(trace_.splits[i]);
      });
    }
  }

  void split(const TracedSplit& split) {
    for (std::size_t i = 0; i < split.triangle.size(); ++i) {
      if (split.triangle[i] == split.opposite)
        drop(in_input({split.triangle[(i + 1) % 3], split.triangle[(i + 2) % 3]}));
    }
    for (const Index corner : split.triangle) put(in_input({corner, split.point}));
  }

  void play_patches() {
    played_.begin_stage("patches", "is of the lightest triangulation of its patch");
    for (const TracedPatch& patch : trace_.patches) {
      group(kNoIndex, patch.gain, [&] {
        for (const Edge& edge : patch.removed) drop(in_input(edge));
        for (const Edge& edge : patch.added) put(in_input(edge));
      });
    }
  }

  void play_annealing() {
    played_.begin_stage("annealing", "is flipped: shorter, or longer and accepted at this temperature");
    for (std::size_t i = 0; i < trace_.flips.size(); ++i) {
      if (i == trace_.annealed)
        played_.begin_stage("flips", "is flipped: the other diagonal of its quadrilateral is shorter");
      const Flip& flip = trace_.flips[i];
      played_.add(Kind::flip, in_input(flip.removed), in_input(flip.added), flip.gain);
      shown_.erase(in_input(flip.removed));
      shown_.insert(in_input(flip.added));
    }
  }

  void play_quadtree() {
    played_.begin_stage("cells", "is in the lightest triangulation of its leaf's points");
    for (const TracedCell& cell : trace_.cells) play_cell(cell);
    played_.begin_stage("merge", "joins leaves: in the constrained Delaunay triangulation that keeps their edges");
    for (const Edge& edge : trace_.joints) put(in_input(edge));
  }

  void play_cell(const TracedCell& cell) {
    const auto box = static_cast<Index>(played_.boxes.size());
    played_.boxes.push_back({cell.left, cell.bottom, cell.right, cell.top});
    const std::size_t head = played_.steps.size();
    played_.add(Kind::cell, {box, 0}, {cell.is_leaf ? Index{0} : kNoIndex, kNoIndex});
    for (const Edge& edge : cell.edges) put(in_input(edge));
    played_.steps[head].b = static_cast<Index>(played_.steps.size() - head - 1);
  }

  const StepTrace& trace_;
  const PointSet& set_;
  PlayedSteps played_;
  std::set<Edge> shown_;
};

template <class Values>
void append_values(std::string& bytes, const Values& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
}

}  // namespace

void PlayedSteps::begin_stage(std::string name, std::string reason) {
  stages.push_back({std::move(name), std::move(reason), steps.size()});
}

void PlayedSteps::add(PlayedStep::Kind kind, const Edge& edge, const Edge& other, double value) {
  steps.push_back({kind, edge.a, edge.b, other.a, other.b, value});
}

void PlayedSteps::arrive_at(const Solution& solution, const PointSet& set, const std::set<Edge>& shown,
                            const std::string& name, const std::string& reason) {
  const std::vector<Edge> end = edges_in_input(solution, set);
  const std::set<Edge> wanted(end.begin(), end.end());
  if (wanted == shown) return;
  begin_stage(name, reason);
  for (const Edge& edge : shown) {
    if (!wanted.contains(edge)) add(Kind::remove, edge);
  }
  for (const Edge& edge : end) {
    if (!shown.contains(edge)) add(Kind::add, edge);
  }
}

std::vector<Edge> edges_in_input(const Solution& solution, const PointSet& set) {
  return edges_of({set.input_count, to_input_indices(set, solution.triangulation.triangles)});
}

PlayedSteps played_flips(const Solution& solution, const PointSet& set) {
  const auto in_input = [&](const Edge& edge) {
    return make_edge(set.input_indices[edge.a], set.input_indices[edge.b]);
  };
  PlayedSteps played;
  played.begin_stage("flips", "is flipped: the other diagonal of its quadrilateral is shorter");
  const std::vector<Edge> end = edges_in_input(solution, set);
  std::set<Edge> edges(end.begin(), end.end());
  for (auto flip = solution.flips.rbegin(); flip != solution.flips.rend(); ++flip) {
    edges.erase(in_input(flip->added));
    edges.insert(in_input(flip->removed));
  }
  for (const Flip& flip : solution.flips)
    played.add(Kind::flip, in_input(flip.removed), in_input(flip.added), flip.gain);
  played.start.assign(edges.begin(), edges.end());
  return played;
}

PlayedSteps played_trace(const StepTrace& trace, const Solution& solution, const PointSet& set) {
  return TracePlayer(trace, set).play(solution);
}

std::string bytes_of(const PlayedSteps& played) {
  std::string bytes;
  for (const PlayedStep& step : played.steps) append_values(bytes, std::array{step.value});
  for (const PlayedBox& box : played.boxes) append_values(bytes, std::array{box.left, box.bottom, box.right, box.top});
  for (const PlayedStep& step : played.steps)
    append_values(bytes, std::array{static_cast<std::uint32_t>(step.kind), step.a, step.b, step.c, step.d});
  append_indices(bytes, played.start);
  return bytes;
}

}  // namespace mwt
