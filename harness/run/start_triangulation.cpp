#include "harness/run/start_triangulation.h"

#include <algorithm>

namespace mwt {

std::optional<std::string> start_file_of(const AlgorithmInfo& algorithm, const Parameters& parameters) {
  for (const ParameterInfo& info : algorithm.parameters) {
    if (info.name != "start" || info.type != ParameterType::text) continue;
    const std::string& value = parameters.text(info.name);
    const bool is_named_start = std::find(info.choices.begin(), info.choices.end(), value) != info.choices.end();
    if (!is_named_start) return value;
  }
  return std::nullopt;
}

}  // namespace mwt
