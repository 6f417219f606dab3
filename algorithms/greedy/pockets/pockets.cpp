#include "algorithms/greedy/pockets/pockets.h"

#include <algorithm>

#include "algorithms/algorithm.h"
#include "algorithms/greedy/pockets/boundary_stretch.h"
#include "algorithms/greedy/pockets/distant_ears.h"
#include "algorithms/greedy/pockets/pocket_insertion.h"

namespace mwt {

namespace {

class Pockets {
 public:
  Pockets(const GreedyParts& parts, std::size_t stretch)
      : context_(parts.context),
        size_(stretch),
        stretch_(parts.mesh),
        ears_(parts.mesh, parts.order, stretch_),
        insertion_(parts, stretch_) {}

  std::size_t take(FaceBoundary& boundary);

 private:
  static constexpr int kOverlap = 40;  // so many corners that are left, on either side of a stretch

  [[nodiscard]] bool take_stretch(FaceBoundary& boundary, std::size_t from);
  void cut_ears(Corner first, Corner last);
  void wait(Corner c);

  const Context& context_;
  std::size_t size_;  // of a stretch
  BoundaryStretch stretch_;
  DistantEars ears_;
  PocketInsertion insertion_;
  KeptVector<Corner> waiting_;  // corners to be looked at
  std::size_t inserted_ = 0;
};

// Back to the stretch before where that has got another neighbour.
std::size_t Pockets::take(FaceBoundary& boundary) {
  ears_.begin(boundary.size());
  const auto is_over = [this] { return context_.deadline_passed() || ears_.is_hopeless(); };
  for (std::size_t last = 0; last < boundary.size() && !is_over(); last += size_) {
    std::size_t from = last;
    while (take_stretch(boundary, from) && from > 0 && !is_over()) from -= size_;
  }
  return inserted_;
}

// Whether the first corner of the stretch that was left is gone or has another neighbour now. Ears grow along a
// boundary, and those at the end of a stretch wait for its neighbour: 40 corners back, they have doubled often enough.
bool Pockets::take_stretch(FaceBoundary& boundary, std::size_t from) {
  const std::size_t to = std::min(from + size_, boundary.size());
  const Corner first = boundary.back_from(static_cast<Corner>(from), kOverlap, size_);
  const Corner last = boundary.on_from(static_cast<Corner>(to), kOverlap, size_);
  stretch_.enter(boundary, first, last);
  Corner start = first;
  while (start + 1 < last && boundary.is_cut(start)) ++start;
  const Corner second = boundary.next(start);
  cut_ears(first, last);
  for (Corner c = first; c < last; ++c) {
    if (!boundary.is_cut(c) && stretch_.room(c).apex != BoundaryStretch::kNone) insertion_.insert(c);
  }
  return boundary.is_cut(start) || boundary.next(start) != second;
}

// First come, first served, so that the short ears of a long boundary come before the long ones.
void Pockets::cut_ears(Corner first, Corner last) {
  FaceBoundary& boundary = stretch_.boundary();
  waiting_.clear();
  for (Corner c = first; c < last; ++c) {
    if (!boundary.is_cut(c)) wait(c);
  }
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const Corner c = waiting_[i];
    stretch_.room(c).is_waiting = false;
    if (boundary.is_cut(c) || boundary.is_of_triangle(c)) continue;
    DistantEar ear{boundary.next(c), boundary.previous(c), c};
    if (!ears_.is_certain(ear)) continue;
    stretch_.cut(c, ear.at_a, ear.at_b, ear.hidden);
    inserted_ += ear.is_in_mesh ? 0 : 1;
    for (const Corner near : {boundary.previous(ear.b), ear.b, ear.a, boundary.next(ear.a)}) wait(near);
  }
}

void Pockets::wait(Corner c) {
  if (!stretch_.is_inside(c) || stretch_.room(c).is_waiting) return;
  stretch_.room(c).is_waiting = true;
  waiting_.push_back(c);
}

}  // namespace

bool are_pockets_promising(const GreedyParts& parts, FaceBoundary& boundary) {
  BoundaryStretch stretch(parts.mesh);
  return DistantEars(parts.mesh, parts.order, stretch).is_promising(boundary);
}

std::size_t take_pockets(const GreedyParts& parts, FaceBoundary& boundary, std::size_t stretch) {
  return Pockets(parts, stretch).take(boundary);
}

}  // namespace mwt
