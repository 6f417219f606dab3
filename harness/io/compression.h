// Compressed files are read as what is in them.
#pragma once

#include <string>
#include <string_view>

namespace mwt {

/// The content without its compression, which its first bytes tell: gzip, bzip2, xz or zstd, several times if need be;
/// other content as it is. Throws InputError naming `source`: damaged, cut off, or more than max_decompressed() bytes.
[[nodiscard]] std::string decompressed(std::string content, const std::string& source);

/// 256 MiB, or 100 times the compressed size if that is more, but at most 16 GiB: a small file does not fill the
/// memory.
[[nodiscard]] std::size_t max_decompressed(std::size_t compressed_size);

/// The content as one zstd frame with a checksum. Deterministic for one version of the library.
[[nodiscard]] std::string compressed_by_zstd(std::string_view content);

/// The name without endings of compressed files: "a.tsp" for "a.tsp.gz".
[[nodiscard]] std::string_view without_compression_ending(std::string_view path);

}  // namespace mwt
