// How much memory this process may still take.
#pragma once

#include <cstdint>
#include <optional>

namespace mwt {

/// The least of what its own limits leave (data and address space: those of a study's runs, or of `ulimit`), what its
/// control group leaves, and what the machine has available without swapping. Nothing if the system says nothing.
/// Linux; reads a few files of /proc and /sys.
[[nodiscard]] std::optional<std::uint64_t> available_memory_bytes();

}  // namespace mwt
