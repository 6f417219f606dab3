// Compressed files are read as what is in them.
#pragma once

#include <string>
#include <string_view>

namespace mwt {

/// The content without its compression, which its first bytes tell: gzip, bzip2, xz or zstd, several times if need be;
/// other content as it is. Throws InputError naming `source`: damaged, cut off, or more than kMaxDecompressed bytes.
[[nodiscard]] std::string decompressed(std::string content, const std::string& source);

inline constexpr std::size_t kMaxDecompressed = std::size_t{1} << 34;

/// The name without endings of compressed files: "a.tsp" for "a.tsp.gz".
[[nodiscard]] std::string_view without_compression_ending(std::string_view path);

}  // namespace mwt
