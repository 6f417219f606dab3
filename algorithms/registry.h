// The list of all algorithms. To add one: its folder, its include and its line in registry.cpp.
#pragma once

#include <span>
#include <string>

#include "algorithms/algorithm.h"

namespace mwt {

/// All algorithms, in the order in which tables show them.
[[nodiscard]] std::span<const AlgorithmInfo> algorithms();

/// The algorithm of that name; InputError lists the known names otherwise.
[[nodiscard]] const AlgorithmInfo& find_algorithm(const std::string& name);

}  // namespace mwt
