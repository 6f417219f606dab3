#include "harness/io/compression.h"

#include <gtest/gtest.h>
#include <zstd.h>

#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filter/lzma.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include "base/error.h"
#include "base/testing/test_folder.h"
#include "harness/io/points/point_file.h"

namespace mwt {
namespace {

using test::message_of;
using test::TestFolder;

std::string sample() {
  std::string text;
  for (std::int64_t i = 0; i < 10'000; ++i) text += std::to_string(i) + ' ' + std::to_string(i * i % 9973) + '\n';
  return text;
}

template <class Filter>
std::string packed(const std::string& content, const Filter& filter) {
  std::string result;
  {
    boost::iostreams::filtering_ostream stream;
    stream.push(filter);
    stream.push(boost::iostreams::back_inserter(result));
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  }
  return result;
}

std::string zstd(const std::string& content) {
  std::string result(ZSTD_compressBound(content.size()), '\0');
  result.resize(ZSTD_compress(result.data(), result.size(), content.data(), content.size(), 3));
  return result;
}

std::vector<std::pair<std::string, std::string>> all_kinds(const std::string& content) {
  return {{"gzip", packed(content, boost::iostreams::gzip_compressor())},
          {"bzip2", packed(content, boost::iostreams::bzip2_compressor())},
          {"xz", packed(content, boost::iostreams::lzma_compressor())},
          {"zstd", zstd(content)}};
}

TEST(Compression, IsTakenOff) {
  const std::string content = sample();
  EXPECT_EQ(decompressed(content, "p"), content);
  for (const auto& [name, file] : all_kinds(content)) {
    ASSERT_LT(file.size(), content.size() / 2) << name;
    EXPECT_EQ(decompressed(file, "p"), content) << name;
    EXPECT_EQ(decompressed(file + file, "p"), content + content) << name << ", two members";
    for (const auto& [outer, twice] : all_kinds(file))
      EXPECT_EQ(decompressed(twice, "p"), content) << name << ' ' << outer;
  }
}

TEST(Compression, OfFilesCutAnywhereIsNoticed) {
  for (const auto& [name, file] : all_kinds(sample())) {
    for (std::size_t size = 6; size < file.size(); size += 1 + file.size() / 50) {
      EXPECT_EQ(message_of<InputError>([&] { static_cast<void>(decompressed(file.substr(0, size), "p")); }),
                "p: begins like " + name + ", but is damaged or cut off")
          << size;
    }
  }
}

TEST(Compression, HasLimits) {
  std::string file = "1 2\n";
  for (int layer = 0; layer < 5; ++layer) file = zstd(file);
  EXPECT_EQ(message_of<InputError>([&] { static_cast<void>(decompressed(file, "p")); }),
            "p: is compressed more than 4 times");
}

TEST(Compression, OfPointsDoesNotMatter) {
  const TestFolder folder;
  const std::vector<Point> points{{1, 2}, {3, 4.5}, {6, 7}};
  const std::vector<std::string> endings = {".gz", ".bz2", ".xz", ".zst"};
  std::size_t kind = 0;
  for (const auto& [name, file] : all_kinds("x,y\n1,2\n3,4.5\n6,7\n")) {
    EXPECT_EQ(read_points(folder.file("p.csv" + endings[kind++], file)), points) << name;
    EXPECT_EQ(read_points(folder.file("p.csv", file)), points) << name << ", by content";
  }
  EXPECT_EQ(without_compression_ending("a/p.TSP.GZ"), "a/p.TSP");
  EXPECT_EQ(without_compression_ending("a.gz/p.tsp"), "a.gz/p.tsp");
}

}  // namespace
}  // namespace mwt
