// Algorithms that start from a triangulation can be given one as a file.
#pragma once

#include <optional>
#include <string>

#include "algorithms/algorithm.h"

namespace mwt {

/// The file that the parameter `start` names: its value when it is declared as text and the value is not one of the
/// declared choices.
[[nodiscard]] std::optional<std::string> start_file_of(const AlgorithmInfo& algorithm, const Parameters& parameters);

}  // namespace mwt
