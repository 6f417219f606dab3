// The list of all families. To add one: its folder, its include and its line in registry.cpp.
#pragma once

#include <map>
#include <span>
#include <string>

#include "generators/generator.h"

namespace mwt {

/// All families, in the order in which tables show them.
[[nodiscard]] std::span<const GeneratorInfo> generators();

/// The family of that name; InputError lists the known names otherwise.
[[nodiscard]] const GeneratorInfo& find_generator(const std::string& name);

/// Points of a family by name, its parameters completed from their defaults. Throws as generate_verified().
[[nodiscard]] std::vector<Point> generate(const std::string& family, Index n, std::uint64_t seed,
                                          const std::map<std::string, std::string>& parameters = {});

}  // namespace mwt
