#include "algorithms/mesh/huge_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

namespace mwt {

namespace {

class HugePages : public testing::Test {
 protected:
  void SetUp() override { release_kept_huge_pages(); }
  void TearDown() override { release_kept_huge_pages(); }
};

TEST_F(HugePages, AreAlignedAndKeptWhenGivenBack) {
  void* const block = take_huge_pages(kHugePage + 1);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % kHugePage, 0U);
  EXPECT_EQ(kept_huge_page_bytes(), 0U);
  give_back_huge_pages(block, kHugePage + 1);
  EXPECT_EQ(kept_huge_page_bytes(), 2 * kHugePage);
  EXPECT_EQ(take_huge_pages(2 * kHugePage), block);
  EXPECT_EQ(kept_huge_page_bytes(), 0U);
  give_back_huge_pages(block, 2 * kHugePage);
}

TEST_F(HugePages, AreTakenFromTheSmallestKeptBlockThatIsLargeEnough) {
  char* const whole = static_cast<char*>(take_huge_pages(8 * kHugePage));
  give_back_huge_pages(whole, kHugePage);
  give_back_huge_pages(whole + 2 * kHugePage, 2 * kHugePage);
  give_back_huge_pages(whole + 5 * kHugePage, 3 * kHugePage);
  EXPECT_EQ(take_huge_pages(2 * kHugePage), whole + 2 * kHugePage);
  EXPECT_EQ(take_huge_pages(2 * kHugePage), whole + 5 * kHugePage);
  give_back_huge_pages(whole + kHugePage, 6 * kHugePage);
}

TEST_F(HugePages, GivenBackPieceByPieceAreOneBlockAgain) {
  constexpr std::size_t kPieces = 16;
  std::vector<std::size_t> order(kPieces);
  std::mt19937_64 random(1);
  for (int round = 0; round < 100; ++round) {
    char* const whole = static_cast<char*>(take_huge_pages(kPieces * kHugePage));
    for (std::size_t i = 0; i < kPieces; ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) give_back_huge_pages(whole + i * kHugePage, kHugePage);
    ASSERT_EQ(kept_huge_page_bytes(), kPieces * kHugePage);
    void* const again = take_huge_pages(kPieces * kHugePage);
    ASSERT_EQ(again, whole);
    give_back_huge_pages(again, kPieces * kHugePage);
  }
}

TEST_F(HugePages, ReturnToTheSystemWhenReleased) {
  give_back_huge_pages(take_huge_pages(8 * kHugePage), 8 * kHugePage);
  release_kept_huge_pages();
  EXPECT_EQ(kept_huge_page_bytes(), 0U);
}

// What was written before is gone where the memory is, and only there: the system gives zeros instead.
TEST_F(HugePages, LeaveTheirMemoryWhereVacated) {
  char* const block = static_cast<char*>(take_huge_pages(8 * kHugePage));
  std::memset(block, 1, 8 * kHugePage);
  give_back_huge_pages(block, 8 * kHugePage);
  vacate_kept_huge_pages(0);
  vacate_kept_huge_pages(2 * kHugePage + 1);
  EXPECT_EQ(kept_huge_page_bytes(), 8 * kHugePage);
  ASSERT_EQ(take_huge_pages(8 * kHugePage), block);
  EXPECT_EQ(std::count(block, block + 8 * kHugePage, 0), static_cast<std::ptrdiff_t>(3 * kHugePage));
  give_back_huge_pages(block, 8 * kHugePage);
}

TEST_F(HugePages, ThrowWhereTheSystemHasNoMore) {
  EXPECT_THROW(static_cast<void>(take_huge_pages(std::size_t{1} << 62)), std::bad_alloc);
  EXPECT_THROW(static_cast<void>(take_huge_pages(~std::size_t{0})), std::bad_alloc);
}

// Every vector is filled with a number of its own, which nothing but itself may change.
void use_vectors(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<HugeVector<std::uint64_t>> vectors(8);
  std::vector<std::uint64_t> content(vectors.size());
  for (int step = 0; step < 300; ++step) {
    const std::size_t i = random() % vectors.size();
    ASSERT_TRUE(std::ranges::all_of(vectors[i], [&](std::uint64_t value) { return value == content[i]; }));
    content[i] = random();
    vectors[i] = HugeVector<std::uint64_t>(random() % 1'000'000, content[i]);
    for (int more = 0; more < 1000; ++more) vectors[i].push_back(content[i]);
  }
}

TEST_F(HugePages, OfDifferentVectorsAndThreadsAreDifferent) {
  std::thread other([] { use_vectors(1); });
  use_vectors(2);
  other.join();
}

TEST_F(HugePages, HoldWhatTheirVectorsAreGiven) {
  HugeVector<int> numbers(3, 7);
  numbers.resize(5, 9);
  EXPECT_EQ(numbers, (HugeVector<int>{7, 7, 7, 9, 9}));
  HugeVector<std::vector<int>> nested(2);
  EXPECT_TRUE(nested[1].empty());
}

}  // namespace

}  // namespace mwt
