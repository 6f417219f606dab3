// Counts the models of the Boolean model.
#pragma once

#include <cstdint>
#include <optional>

#include "algorithms/boolean_model/crossing_model.h"
#include "algorithms/deadline.h"

namespace mwt {

/// The number of sets of edges without crossings that nothing can be added to, each found once; and whether all of them
/// have the model's size, as every triangulation has.
struct ModelCount {
  std::uint64_t count = 0;
  bool have_the_same_size = true;
};

/// By deciding edge after edge, with the consequences: what crosses a chosen edge is out; an edge that is out needs
/// one that crosses it and may still be chosen, and if that is the only one, it is in. Time grows with the number of
/// models. Nothing if the deadline passes.
[[nodiscard]] std::optional<ModelCount> count_models(const CrossingModel& model, const Deadline& deadline);

}  // namespace mwt
