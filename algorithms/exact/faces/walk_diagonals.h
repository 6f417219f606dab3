// Where the candidates inside a face lead to, by positions in its walk.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/exact/faces/face_region.h"

namespace mwt {

using Diagonals = std::vector<std::array<std::uint32_t, 2>>;

/// Each candidate of the walk's corners by the positions of its ends, first < second, ascending; nothing if some lead
/// elsewhere: the face is no polygon then. O(L log L) for L corners and candidates.
[[nodiscard]] std::optional<Diagonals> diagonals_of_walk(const CandidateGraph& graph, const Walk& walk);

}  // namespace mwt
