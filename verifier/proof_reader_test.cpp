#include "verifier/proof_reader.h"

#include <gtest/gtest.h>

#include <random>

#include "base/testing/test_folder.h"
#include "verifier/refused.h"
#include "verifier/testing/proof.h"

namespace mwt::verifier {
namespace {

using namespace testing;

// Around the sizes of the buffers and of zstd's blocks, with bytes that compress well, little, and not at all. The
// frames of file_of() end with their last block: no checksum follows.
TEST(ProofReader, ReadsBodiesOfAllSizes) {
  const test::TestFolder folder;
  std::mt19937 random(1);
  for (const std::size_t size : {1U, 1000U, 131'071U, 131'072U, 131'073U, 200'000U, 262'144U, 300'000U, 1'000'000U}) {
    for (const unsigned values : {2U, 16U, 256U}) {
      SCOPED_TRACE(std::to_string(size) + " bytes below " + std::to_string(values));
      std::vector<std::uint8_t> plain(size);
      for (std::uint8_t& byte : plain) byte = static_cast<std::uint8_t>(random() % values);
      write_file(folder.path("proof"), file_of(plain));
      ProofReader reader(folder.path("proof"));
      std::vector<std::uint8_t> read;
      ASSERT_NO_THROW(for (std::size_t i = 0; i < size; ++i) read.push_back(reader.byte()));
      EXPECT_EQ(read, plain);
      EXPECT_NO_THROW(reader.expect_end());
      EXPECT_THROW(static_cast<void>(reader.byte()), Refused);
    }
  }
}

}  // namespace
}  // namespace mwt::verifier
