// JSON for scripts.
#pragma once

#include <map>
#include <span>
#include <string>

#include "algorithms/algorithm.h"
#include "generators/generator.h"
#include "harness/cli/solve_output.h"

namespace mwt {

/// One object with the fields of DESIGN, those it lacks null; numbers read back as the same doubles.
[[nodiscard]] std::string to_json(const SolveOutput& output);

/// Arrays with one object per entry.
[[nodiscard]] std::string to_json(std::span<const AlgorithmInfo> algorithms);
[[nodiscard]] std::string to_json(std::span<const GeneratorInfo> generators);

/// An array of {"name", "summary", "file"}.
struct StudyEntry {
  std::string name;
  std::string summary;
  std::string file;
};
[[nodiscard]] std::string to_json(std::span<const StudyEntry> studies);

}  // namespace mwt
