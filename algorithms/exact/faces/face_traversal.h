// Walks around all faces of the certain edges, on several threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/exact/candidates/candidate_graph.h"
#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/faces/face_walk.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

/// Longer walks are collected one after the other, so that none is walked from each of its vertices.
inline constexpr std::size_t kLongWalk = 64;

/// Calls report(share done) now and then, from one thread at a time. The function may be empty.
class FaceProgress {
 public:
  using Report = std::function<void(double)>;

  FaceProgress(const Report& report, std::size_t total) : report_(report), total_(total) {}

  void advance() {
    if (!report_) return;
    const std::lock_guard lock(mutex_);
    ++done_;
    const bool is_due = done_ * 50 / total_ != (done_ - 1) * 50 / total_;
    if (is_due) report_(static_cast<double>(done_) / static_cast<double>(total_));
  }

 private:
  const Report& report_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

/// What one task finds, in a fixed order, whatever thread runs it. Visitors file walks that they do not finish.
struct FacePart {
  LengthSum certain;                  ///< of certain edges, each from its first end
  std::vector<Corner> long_walks;     ///< where walks longer than kLongWalk may start
  std::vector<Walk> composite_walks;  ///< parts of the boundaries of faces with holes or isolated vertices
  std::vector<Walk> late_walks;       ///< polygons that the deadline left
  std::vector<Index> isolated;        ///< vertices without certain edges
};

/// Shows every walk around a face, the outer one excepted, to a visitor: visit(walk, part), `Part` being a FacePart
/// with what else the visitor finds. Walks come in parallel, those of one part one after the other, on the threads of
/// the enclosing task arena; which part a walk belongs to does not depend on them.
template <class Part>
class FaceTraversal {
 public:
  explicit FaceTraversal(CandidateGraph graph) : graph_(std::move(graph)), walker_(graph_) {}
  FaceTraversal(const FaceTraversal&) = delete;
  FaceTraversal& operator=(const FaceTraversal&) = delete;

  [[nodiscard]] const CandidateGraph& graph() const { return graph_; }
  [[nodiscard]] const FaceWalker& walker() const { return *walker_; }
  [[nodiscard]] std::vector<Part>& parts() { return parts_; }
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

  /// Every part has its place: those of the blocks of vertices, then those of the long walks.
  template <class Visit>
  void run(const Visit& visit, const FaceProgress::Report& report = {}) {
    outer_face_ = walker_->owner_of_outer_face();
    visit_blocks(visit, report);
    visit_long_walks(visit, report);
  }

  /// The candidates inside composite faces. A candidate that crosses a certain edge leads out of its face at both ends
  /// or breaks the face's polygon, so it is one of them.
  [[nodiscard]] std::vector<Edge> open_candidates() const {
    std::vector<Edge> edges;
    for (const Part& part : parts_) {
      for (const Walk& walk : part.composite_walks) {
        for (const Corner& corner : walk) {
          for (std::uint32_t i = 0; i < corner.candidates; ++i) {
            edges.push_back({corner.vertex, candidate_of(graph_, corner, i)});
          }
        }
      }
      for (const Index vertex : part.isolated) {
        for (const Index target : graph_.star(vertex)) edges.push_back({vertex, target});
      }
    }
    return undirected_edges(std::move(edges));
  }

  /// Deletes these candidates and visits the composite walks again: some may be polygons now.
  template <class Visit>
  void remove_candidates(std::span<const Edge> candidates, const Visit& visit) {
    if (candidates.empty()) return;
    std::vector<std::vector<Edge>> composite, late;
    for (Part& part : parts_) {
      composite.push_back(take_starts(part.composite_walks));
      late.push_back(take_starts(part.late_walks));
    }
    remove_edges(graph_, candidates);
    walker_.emplace(graph_);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (const Edge& start : composite[i]) visit(walker_->corners_of_face(start), parts_[i]);
      for (const Edge& start : late[i]) parts_[i].late_walks.push_back(walker_->corners_of_face(start));
    }
  }

  /// All late walks; they are no longer in their parts.
  [[nodiscard]] std::vector<Walk> take_late_walks() {
    std::vector<Walk> late;
    for (Part& part : parts_) {
      std::move(part.late_walks.begin(), part.late_walks.end(), std::back_inserter(late));
      part.late_walks.clear();
    }
    return late;
  }

  /// The faces that the composite walks and isolated vertices belong to; the walks are no longer in their parts.
  /// Precondition: no open candidate crosses a certain edge.
  [[nodiscard]] std::vector<FaceRegion> take_composite_faces() {
    std::vector<Walk> composite;
    std::vector<Index> isolated;
    for (Part& part : parts_) {
      std::move(part.composite_walks.begin(), part.composite_walks.end(), std::back_inserter(composite));
      part.composite_walks.clear();
      isolated.insert(isolated.end(), part.isolated.begin(), part.isolated.end());
    }
    return group_into_regions(graph_, *walker_, composite, isolated);
  }

 private:
  static constexpr std::size_t kBlock = 4096;  // vertices per parallel task

  template <class Visit>
  void visit_blocks(const Visit& visit, const FaceProgress::Report& report) {
    const std::size_t size = graph_.points.size(), blocks = (size + kBlock - 1) / kBlock;
    parts_.resize(blocks);
    FaceProgress progress(report, blocks);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
      visit_block(static_cast<Index>(block * kBlock), static_cast<Index>(std::min(size, (block + 1) * kBlock)), visit,
                  parts_[block]);
      progress.advance();
    });
  }

  template <class Visit>
  void visit_block(Index begin, Index end, const Visit& visit, Part& part) const {
    Walk walk;
    for (Index v = begin; v < end; ++v) {
      bool is_isolated = true;
      for (std::uint32_t h = graph_.first[v]; h < graph_.first[v + std::size_t{1}]; ++h) {
        if (graph_.certain[h] == 0) continue;
        is_isolated = false;
        if (v < graph_.target[h]) part.certain.add(graph_.points[v], graph_.points[graph_.target[h]]);
        const WalkEnd walk_end = walker_->walk(v, h, kLongWalk, walk);
        if (walk_end == WalkEnd::too_long) part.long_walks.push_back({v, h, 0});
        if (walk_end == WalkEnd::closed && h != outer_face_) visit(walk, part);
      }
      if (is_isolated) part.isolated.push_back(v);
    }
  }

  // Starts come in ascending order, so that a walk's first one is its owner; the others find it visited.
  [[nodiscard]] std::vector<Walk> collect_long_walks() const {
    std::vector<Walk> walks;
    std::vector<bool> is_visited;
    for (const Part& part : parts_) {
      for (const Corner& start : part.long_walks) {
        is_visited.resize(graph_.target.size());
        if (is_visited[start.halfedge]) continue;
        Walk walk = walker_->corners_of_face(start.vertex, start.halfedge);
        for (const Corner& corner : walk) is_visited[corner.halfedge] = true;
        if (start.halfedge != outer_face_) walks.push_back(std::move(walk));
      }
    }
    return walks;
  }

  template <class Visit>
  void visit_long_walks(const Visit& visit, const FaceProgress::Report& report) {
    const std::vector<Walk> walks = collect_long_walks();
    const std::size_t blocks = parts_.size();
    parts_.resize(blocks + walks.size());
    FaceProgress progress(report, walks.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, walks.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            visit(walks[i], parts_[blocks + i]);
            progress.advance();
          }
        },
        tbb::simple_partitioner());
  }

  // Walks name halfedges by numbers that change when edges go: their first edges find them again.
  [[nodiscard]] std::vector<Edge> take_starts(std::vector<Walk>& walks) const {
    std::vector<Edge> starts;
    for (const Walk& walk : walks) starts.push_back({walk.back().vertex, graph_.target[walk.back().halfedge]});
    walks.clear();
    return starts;
  }

  CandidateGraph graph_;
  std::optional<FaceWalker> walker_;
  std::uint32_t outer_face_ = 0;
  std::vector<Part> parts_;
};

}  // namespace mwt
