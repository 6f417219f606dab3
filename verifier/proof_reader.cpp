#include "verifier/proof_reader.h"

#include <fmt/core.h>
#include <zstd.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <limits>

#include "base/error.h"
#include "verifier/refused.h"

namespace mwt::verifier {

namespace {

constexpr char kMagic[8] = {'M', 'W', 'T', 'P', 'R', 'O', 'O', 'F'};
constexpr std::uint32_t kVersion = 2;

// No honest proof compresses better; a hostile one must be as large as the work it makes.
constexpr std::uint64_t kMaxRatio = 1000;

// Opening anything else may wait for ever.
bool is_regular(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

}  // namespace

struct ProofReader::Decompressor {
  ZSTD_DStream* stream = ZSTD_createDStream();
  Decompressor() = default;
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;
  ~Decompressor() { ZSTD_freeDStream(stream); }
};

void ProofReader::DeleteDecompressor::operator()(Decompressor* decompressor) const { delete decompressor; }

ProofReader::ProofReader(const std::string& path)
    : file_(is_regular(path) ? std::fopen(path.c_str(), "rb") : nullptr),
      compressed_(ZSTD_DStreamInSize()),
      plain_(ZSTD_DStreamOutSize()) {
  if (!file_) throw InputError(path + ": is no file that can be read");
  std::array<std::uint8_t, 12> header{};
  const bool is_proof = std::fread(header.data(), 1, header.size(), file_.get()) == header.size() &&
                        std::memcmp(header.data(), kMagic, sizeof kMagic) == 0;
  if (!is_proof) throw InputError(path + ": is no proof; mwt solve --proof writes them");
  std::uint32_t version = 0;
  for (std::size_t i = 0; i < 4; ++i) version |= std::uint32_t{header[8 + i]} << (8 * i);
  if (version != kVersion) {
    throw InputError(
        fmt::format("{}: is a proof of version {}; this program reads version {}", path, version, kVersion));
  }
  decompressor_.reset(new Decompressor);
  ZSTD_DCtx_setParameter(decompressor_->stream, ZSTD_d_windowLogMax, 23);  // no more memory than 8 MB
}

// Decompresses some more bytes; false at the end of the frame.
bool ProofReader::refill() {
  next_ = end_ = 0;
  while (end_ == 0 && !is_complete_) {
    if (compressed_next_ == compressed_end_ && !is_pending_) {
      compressed_next_ = 0;
      compressed_end_ = std::fread(compressed_.data(), 1, compressed_.size(), file_.get());
      if (compressed_end_ == 0) throw Refused("the proof file ends too early");
      compressed_total_ += compressed_end_;
    }
    ZSTD_inBuffer in{compressed_.data(), compressed_end_, compressed_next_};
    ZSTD_outBuffer out{plain_.data(), plain_.size(), 0};
    const std::size_t rest = ZSTD_decompressStream(decompressor_->stream, &out, &in);
    if (ZSTD_isError(rest) != 0) throw Refused(std::string("the proof file is damaged: ") + ZSTD_getErrorName(rest));
    is_complete_ = rest == 0;
    is_pending_ = out.pos == out.size;
    compressed_next_ = in.pos;
    end_ = out.pos;
    plain_total_ += out.pos;
    require(plain_total_ <= kMaxRatio * (compressed_total_ + 1000), "the proof file is compressed beyond belief");
  }
  return end_ > 0;
}

std::uint8_t ProofReader::byte() {
  if (next_ == end_ && !refill()) throw Refused("the proof ends too early");
  return plain_[next_++];
}

// Seven bits a byte, the lowest first; the highest bit says that more follow.
std::uint64_t ProofReader::number() {
  std::uint64_t result = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const std::uint64_t part = byte();
    require(shift < 63 || part <= 1, "a number in the proof has more than 64 bits");
    result |= (part & 0x7F) << shift;
    if (part < 0x80) return result;
  }
  throw Refused("a number in the proof has more than 64 bits");
}

std::uint64_t ProofReader::number_below(std::uint64_t limit) {
  const std::uint64_t result = number();
  if (result >= limit) {
    throw Refused(fmt::format("the proof holds {} where at most {} values are possible", result, limit));
  }
  return result;
}

// 0, -1, 1, -2, ... are stored as 0, 1, 2, 3, ...
std::int64_t ProofReader::signed_number() {
  const std::uint64_t zigzag = number();
  return static_cast<std::int64_t>(zigzag >> 1) ^ -static_cast<std::int64_t>(zigzag & 1);
}

double ProofReader::real() {
  std::uint64_t bits = 0;
  for (int i = 0; i < 8; ++i) bits |= std::uint64_t{byte()} << (8 * i);
  return std::bit_cast<double>(bits);
}

Index ProofReader::index_near(Index previous, std::uint64_t limit) {
  constexpr std::int64_t kFar = std::int64_t{1} << 33;
  const std::int64_t difference = signed_number();
  const std::int64_t result = difference > -kFar && difference < kFar ? previous + difference : -1;
  if (result < 0 || static_cast<std::uint64_t>(result) >= limit)
    throw Refused("a position in the proof is out of range");
  return static_cast<Index>(result);
}

void ProofReader::expect_end() {
  if (next_ != end_ || refill()) throw Refused("the proof goes on after its end");
  const bool is_at_end = compressed_next_ == compressed_end_ && std::fgetc(file_.get()) == EOF;
  if (!is_at_end) throw Refused("the proof file goes on after its end");
}

}  // namespace mwt::verifier
