// Reads the numbers of a proof file in their order. What they mean: FORMAT.md.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "geometry/point.h"

namespace mwt::verifier {

/// Throws Refused where the file ends too early, does not decompress, or holds a number that is not allowed there.
/// Holds a few hundred kilobytes, however large the file is or pretends to be.
class ProofReader {
 public:
  /// Throws InputError if the file cannot be opened, is no proof, or has a version this program does not read.
  explicit ProofReader(const std::string& path);

  [[nodiscard]] std::uint8_t byte();
  [[nodiscard]] std::uint64_t number();
  [[nodiscard]] std::uint64_t number_below(std::uint64_t limit);
  [[nodiscard]] std::int64_t signed_number();
  [[nodiscard]] double real();

  /// A number below `limit`, stored as its difference from `previous`.
  [[nodiscard]] Index index_near(Index previous, std::uint64_t limit);

  /// Refuses a file that goes on.
  void expect_end();

 private:
  bool refill();

  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  struct Decompressor;
  struct DeleteDecompressor {
    void operator()(Decompressor* decompressor) const;
  };

  std::unique_ptr<std::FILE, CloseFile> file_;
  std::unique_ptr<Decompressor, DeleteDecompressor> decompressor_;
  std::vector<std::uint8_t> compressed_, plain_;
  std::size_t compressed_next_ = 0, compressed_end_ = 0;
  std::size_t next_ = 0, end_ = 0;  // in plain_
  std::uint64_t compressed_total_ = 0, plain_total_ = 0;
  bool is_complete_ = false;  // the compressed frame has ended
  bool is_pending_ = false;   // the decompressor may hold more than plain_ had room for
};

}  // namespace mwt::verifier
