// A deadline of its own for a part of an algorithm.
#pragma once

#include <utility>

#include "algorithms/algorithm.h"

namespace mwt {

/// Gives the context another deadline for the lifetime of this object.
class OtherDeadline {
 public:
  OtherDeadline(Context& context, const Deadline& other)
      : context_(context), original_(std::exchange(context.deadline, other)) {}
  ~OtherDeadline() { context_.deadline = original_; }
  OtherDeadline(const OtherDeadline&) = delete;
  OtherDeadline& operator=(const OtherDeadline&) = delete;

 private:
  Context& context_;
  Deadline original_;
};

}  // namespace mwt
