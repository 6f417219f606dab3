// All models of the Boolean model at once: the lightest one, and how many there are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/boolean_model/crossing_model.h"
#include "algorithms/deadline.h"
#include "algorithms/stop_reason.h"
#include "geometry/numbers/interval.h"

namespace mwt {

/// What is certain of an edge before the search.
enum class ModelEdge : std::uint8_t { open, in, out };

/// Of the models that have all edges that are in and none that are out.
struct ModelSummary {
  std::string count = "0";
  bool have_the_same_size = true;         ///< as all triangulations have
  std::vector<std::uint32_t> lightest;    ///< edges of one of least weight, ascending; none if there is no model
  Interval weight{0, 0};                  ///< contains its weight
  std::optional<StopReason> stop_reason;  ///< deadline or memory: the rest means nothing then
};

/// The models are the sets of edges without crossings to which none can be added. Edges are decided one after the
/// other, in lexicographic order of their ends: in, and what crosses it is out, or out, and then it needs an edge that
/// crosses it. What is left falls into parts that no crossing joins, each of which is searched once, however often it
/// appears. In convex position these are O(n^4) parts of polygons; in general exponentially many.
[[nodiscard]] ModelSummary search_models(Points points, const CrossingModel& model, const std::vector<ModelEdge>& known,
                                         const Deadline& deadline);

}  // namespace mwt
