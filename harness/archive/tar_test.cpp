#include "harness/archive/tar.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/error.h"

namespace mwt {
namespace {

const std::vector<TarEntry> kFiles = {
    {"set/README.md", "text\n"}, {"set/points/a.txt", std::string(1000, 'x')}, {"set/empty", ""}};

// The archive with a byte of the first header's name changed, and its checksum made right again.
std::string renamed(const std::string& name, char type = '0') {
  std::string archive = tar_of({{"abcdefghijklmnopqrstuvwxyz", "content"}});
  for (std::size_t i = 0; i < 100; ++i) archive[i] = i < name.size() ? name[i] : '\0';
  archive[156] = type;
  for (std::size_t i = 148; i < 156; ++i) archive[i] = ' ';
  unsigned sum = 0;
  for (std::size_t i = 0; i < 512; ++i) sum += static_cast<unsigned char>(archive[i]);
  for (std::size_t i = 0; i < 6; ++i) archive[153 - i] = static_cast<char>('0' + (sum >> (3 * i)) % 8);
  archive[154] = '\0';
  return archive;
}

TEST(Tar, ReadsWhatItWrote) {
  const std::vector<TarEntry> read = read_tar(tar_of(kFiles), "a.tar");
  ASSERT_EQ(read.size(), kFiles.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].name, kFiles[i].name);
    EXPECT_EQ(read[i].content, kFiles[i].content);
  }
}

TEST(Tar, RefusesEveryPrefix) {
  const std::string archive = tar_of(kFiles);
  for (std::size_t size = 0; size + 1024 < archive.size(); size += 37)
    EXPECT_THROW((void)read_tar(archive.substr(0, size), "a.tar"), InputError) << size;
}

TEST(Tar, RefusesDamagedHeaders) {
  for (const std::size_t place : {0u, 101u, 124u, 130u, 150u, 156u, 300u}) {
    std::string archive = tar_of(kFiles);
    archive[place] = static_cast<char>(archive[place] ^ 1);
    EXPECT_THROW((void)read_tar(archive, "a.tar"), InputError) << place;
  }
}

TEST(Tar, RefusesNamesThatLeadElsewhere) {
  EXPECT_EQ(read_tar(renamed("fine.txt"), "a.tar").front().name, "fine.txt");
  for (const char* name : {"../x", "a/../../x", "/etc/passwd", "", "a//b", "./a", "a\\b", "a\nb", ".."})
    EXPECT_THROW((void)read_tar(renamed(name), "a.tar"), InputError) << name;
}

TEST(Tar, RefusesLinksAndDevices) {
  for (const char type : {'1', '2', '3', '4', '6', 'x', 'L'})
    EXPECT_THROW((void)read_tar(renamed("link", type), "a.tar"), InputError) << type;
}

TEST(Tar, RefusesANameThatComesTwice) {
  EXPECT_THROW((void)read_tar(tar_of({{"a", "1"}, {"a", "2"}}), "a.tar"), InputError);
}

TEST(Tar, WritesNoNamesThatItWouldRefuse) {
  EXPECT_THROW((void)tar_of({{"../a", ""}}), std::invalid_argument);
  EXPECT_THROW((void)tar_of({{std::string(101, 'a'), ""}}), std::invalid_argument);
}

}  // namespace
}  // namespace mwt
