// What a study or a command may choose from. Tests bring catalogues of their own, with algorithms that misbehave.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "algorithms/algorithm.h"
#include "base/error.h"
#include "generators/generator.h"

namespace mwt {

class Catalogue {
 public:
  /// The registries of algorithms and generators.
  [[nodiscard]] static Catalogue built_in();

  Catalogue(std::span<const AlgorithmInfo> algorithms, std::span<const GeneratorInfo> generators)
      : algorithms_(algorithms), generators_(generators) {}

  [[nodiscard]] std::span<const AlgorithmInfo> algorithms() const { return algorithms_; }
  [[nodiscard]] std::span<const GeneratorInfo> generators() const { return generators_; }

  /// The entry of that name; InputError lists the known names otherwise.
  [[nodiscard]] const AlgorithmInfo& algorithm(const std::string& name) const;
  [[nodiscard]] const GeneratorInfo& generator(const std::string& name) const;

 private:
  std::span<const AlgorithmInfo> algorithms_;
  std::span<const GeneratorInfo> generators_;
};

/// The smaller of an entry's limit and another one, such as a study's; 0 in an entry means none.
[[nodiscard]] Index max_n_for(const AlgorithmInfo& algorithm, const std::optional<Index>& other);

/// An instance is too large for this machine.
class NotEnoughMemory : public InputError {
 public:
  using InputError::InputError;
};

/// Points of a family. Throws as generate_verified(), and NotEnoughMemory.
[[nodiscard]] std::vector<Point> generate_points(const GeneratorInfo& family, Index n, std::uint64_t seed,
                                                 const Parameters& parameters);

}  // namespace mwt
