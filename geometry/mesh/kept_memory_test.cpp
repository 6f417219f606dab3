#include "geometry/mesh/kept_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

namespace mwt {

namespace {

class KeptMemory : public testing::Test {
 protected:
  void SetUp() override { release_kept_blocks(); }
  void TearDown() override { release_kept_blocks(); }
};

TEST_F(KeptMemory, BlocksAreKeptWhenGivenBack) {
  void* const block = take_block(kBlock + 1);
  EXPECT_EQ(kept_bytes(), 0U);
  give_back_block(block, kBlock + 1);
  EXPECT_EQ(kept_bytes(), 2 * kBlock);
  EXPECT_EQ(take_block(2 * kBlock), block);
  EXPECT_EQ(kept_bytes(), 0U);
  give_back_block(block, 2 * kBlock);
}

TEST_F(KeptMemory, BlocksAreTakenFromTheSmallestKeptBlockThatIsLargeEnough) {
  char* const whole = static_cast<char*>(take_block(8 * kBlock));
  give_back_block(whole, kBlock);
  give_back_block(whole + 2 * kBlock, 2 * kBlock);
  give_back_block(whole + 5 * kBlock, 3 * kBlock);
  EXPECT_EQ(take_block(2 * kBlock), whole + 2 * kBlock);
  EXPECT_EQ(take_block(2 * kBlock), whole + 5 * kBlock);
  give_back_block(whole + kBlock, 6 * kBlock);
}

TEST_F(KeptMemory, BlocksGivenBackPieceByPieceAreJoined) {
  constexpr std::size_t kPieces = 16;
  std::vector<std::size_t> order(kPieces);
  std::mt19937_64 random(1);
  for (int round = 0; round < 100; ++round) {
    char* const whole = static_cast<char*>(take_block(kPieces * kBlock));
    for (std::size_t i = 0; i < kPieces; ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) give_back_block(whole + i * kBlock, kBlock);
    ASSERT_EQ(kept_bytes(), kPieces * kBlock);
    void* const again = take_block(kPieces * kBlock);
    ASSERT_EQ(again, whole);
    give_back_block(again, kPieces * kBlock);
  }
}

TEST_F(KeptMemory, ReturnsToTheSystemWhenReleased) {
  give_back_block(take_block(8 * kBlock), 8 * kBlock);
  release_kept_blocks();
  EXPECT_EQ(kept_bytes(), 0U);
}

// What was written before is gone where the memory is, and only there: the system gives zeros instead.
TEST_F(KeptMemory, IsGoneWhereVacated) {
  char* const block = static_cast<char*>(take_block(8 * kBlock));
  std::memset(block, 1, 8 * kBlock);
  give_back_block(block, 8 * kBlock);
  vacate_kept_blocks(0);
  vacate_kept_blocks(2 * kBlock + 1);
  EXPECT_EQ(kept_bytes(), 8 * kBlock);
  ASSERT_EQ(take_block(8 * kBlock), block);
  EXPECT_EQ(std::count(block, block + 8 * kBlock, 0), static_cast<std::ptrdiff_t>(3 * kBlock));
  give_back_block(block, 8 * kBlock);
}

TEST_F(KeptMemory, ThrowsWhereTheSystemHasNoMore) {
  EXPECT_THROW(static_cast<void>(take_block(std::size_t{1} << 62)), std::bad_alloc);
  EXPECT_THROW(static_cast<void>(take_block(~std::size_t{0})), std::bad_alloc);
}

// Every vector is filled with a number of its own, which nothing but itself may change.
void use_vectors(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<KeptVector<std::uint64_t>> vectors(8);
  std::vector<std::uint64_t> content(vectors.size());
  for (int step = 0; step < 300; ++step) {
    const std::size_t i = random() % vectors.size();
    ASSERT_TRUE(std::ranges::all_of(vectors[i], [&](std::uint64_t value) { return value == content[i]; }));
    content[i] = random();
    vectors[i] = KeptVector<std::uint64_t>(random() % 1'000'000, content[i]);
    for (int more = 0; more < 1000; ++more) vectors[i].push_back(content[i]);
  }
}

TEST_F(KeptMemory, IsUsedByOneVectorAtATime) {
  std::thread other([] { use_vectors(1); });
  use_vectors(2);
  other.join();
}

TEST_F(KeptMemory, HoldsWhatVectorsAreGiven) {
  KeptVector<int> numbers(3, 7);
  numbers.resize(5, 9);
  EXPECT_EQ(numbers, (KeptVector<int>{7, 7, 7, 9, 9}));
  KeptVector<std::vector<int>> nested(2);
  EXPECT_TRUE(nested[1].empty());
}

}  // namespace

}  // namespace mwt
