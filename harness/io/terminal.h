// What standard output is: a person's terminal, or a pipe or file.
#pragma once

#include <cstddef>
#include <optional>

namespace mwt {

/// How many columns text for standard output may have: the environment variable COLUMNS if it is set (a whole
/// number from 20 on); on a terminal its width, or 80 if that is unknown; nothing, for no limit, into pipes and files.
[[nodiscard]] std::optional<std::size_t> output_width();

}  // namespace mwt
