// Peak memory of this process over a stretch of its life (Linux).
#pragma once

#include <cstdint>

namespace mwt {

/// Starts a stretch: the peak so far is discarded, unless the system does not allow it (then the peak since the
/// process began counts, which for a forked worker includes what it inherited).
void reset_peak_memory();

/// The largest resident set since the last reset, in bytes.
[[nodiscard]] std::uint64_t peak_memory_bytes();

}  // namespace mwt
