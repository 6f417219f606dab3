#include "harness/io/compression.h"

#include <fmt/core.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filter/lzma.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>

#include "base/error.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

namespace io = boost::iostreams;

enum class Compression { gzip, bzip2, xz, zstd };

struct Kind {
  Compression compression;
  std::string_view name;
  std::string_view magic;
  std::string_view ending;
};

constexpr std::array<Kind, 4> kKinds = {{{Compression::gzip, "gzip", "\x1f\x8b", ".gz"},
                                         {Compression::bzip2, "bzip2", "BZh", ".bz2"},
                                         {Compression::xz, "xz",
                                          std::string_view("\xfd"
                                                           "7zXZ\0",
                                                           6),
                                          ".xz"},
                                         {Compression::zstd, "zstd", "\x28\xb5\x2f\xfd", ".zst"}}};

std::optional<Kind> kind_of(std::string_view content) {
  for (const Kind& kind : kKinds) {
    if (content.starts_with(kind.magic)) return kind;
  }
  return std::nullopt;
}

constexpr std::size_t kBlock = std::size_t{1} << 20;

// More than max_decompressed() bytes.
class TooLong : public std::exception {};

// A chunk is added while there is room.
void add_chunk(std::string& result, std::size_t compressed_size) {
  if (result.size() > max_decompressed(compressed_size)) throw TooLong();
  result.resize(result.size() + kBlock);
}

template <class Decompressor>
std::string without(const std::string& content, const Decompressor& decompressor) {
  io::filtering_istream stream;
  stream.push(decompressor);
  stream.push(io::array_source(content.data(), content.size()));
  stream.exceptions(std::ios::badbit);
  std::string result;
  while (stream) {
    const std::size_t size = result.size();
    add_chunk(result, content.size());
    stream.read(result.data() + size, static_cast<std::streamsize>(kBlock));
    result.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  return result;
}

// Boost's decompressor takes a file that was cut off for a whole one.
std::string without_zstd(const std::string& content) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(), &ZSTD_freeDStream);
  ZSTD_inBuffer in{content.data(), content.size(), 0};
  std::string result;
  std::size_t missing = 0;  // 0 at the end of a frame
  bool is_output_full = false;
  while (in.pos < in.size || is_output_full) {
    const std::size_t size = result.size();
    add_chunk(result, content.size());
    ZSTD_outBuffer out{result.data() + size, kBlock, 0};
    missing = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(missing) != 0) throw std::runtime_error("damaged");
    is_output_full = out.pos == out.size;
    result.resize(size + out.pos);
  }
  if (missing != 0) throw std::runtime_error("cut off");
  return result;
}

std::string without(Compression compression, const std::string& content) {
  switch (compression) {
    case Compression::gzip: return without(content, io::gzip_decompressor());
    case Compression::bzip2: return without(content, io::bzip2_decompressor());
    case Compression::xz: return without(content, io::lzma_decompressor());
    case Compression::zstd: return without_zstd(content);
  }
  throw std::logic_error("an unknown compression");
}

}  // namespace

std::size_t max_decompressed(std::size_t compressed_size) {
  constexpr std::size_t kAlways = std::size_t{1} << 28, kMost = std::size_t{1} << 34;
  constexpr std::size_t kRatio = 100;  // text of coordinates: 2 to 10
  return std::clamp(std::min(compressed_size, kMost) * kRatio, kAlways, kMost);
}

std::string compressed_by_zstd(std::string_view content) {
  constexpr int kLevel = 19;  // the best without more memory for whoever decompresses it
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), &ZSTD_freeCCtx);
  if (!context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::string result(ZSTD_compressBound(content.size()), '\0');
  const std::size_t size = ZSTD_compress2(context.get(), result.data(), result.size(), content.data(), content.size());
  if (ZSTD_isError(size) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  result.resize(size);
  return result;
}

std::string decompressed(std::string content, const std::string& source) {
  constexpr int kMaxLayers = 4;
  for (int layer = 0; layer < kMaxLayers; ++layer) {
    const std::optional<Kind> kind = kind_of(content);
    if (!kind) return content;
    try {
      content = without(kind->compression, content);
    } catch (const TooLong&) {
      const std::size_t limit = max_decompressed(content.size());
      throw InputError(fmt::format("{}: decompresses to more than {} MB; decompress it yourself", source, limit >> 20));
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {
      throw InputError(fmt::format("{}: begins like {}, but is damaged or cut off", source, kind->name));
    }
  }
  throw InputError(fmt::format("{}: is compressed more than {} times", source, kMaxLayers));
}

std::string_view without_compression_ending(std::string_view path) {
  const std::string lower = lower_case(path);
  for (const Kind& kind : kKinds) {
    if (lower.ends_with(kind.ending)) return path.substr(0, path.size() - kind.ending.size());
  }
  return path;
}

}  // namespace mwt
