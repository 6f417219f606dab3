// Benchmark sets as users make, check and run them: mwt archive, mwt run --instances.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "base/number_text.h"
#include "harness/archive/benchmark_set.h"
#include "harness/cli/testing/commands_testing.h"
#include "harness/io/points/point_file.h"
#include "harness/io/text/csv.h"

namespace mwt {
namespace {

class ArchiveCommand : public testing::CommandTest {
 protected:
  void make_set() const {
    write("s.toml",
          "name = \"small\"\nsummary = \"x\"\nfamilies = [\"uniform\"]\nsizes = [8, 20]\nseeds = [1, 2]\n"
          "algorithms = [\"greedy\"]\n[optimum]\nsources = [\"exact\"]\nproofs = { max_n = 100 }\n");
    static_cast<void>(run("run s.toml --out r --quiet"));
    EXPECT_EQ(run("archive r -o small.tar.zst"), "written: small.tar.zst: 4 instances, 4 proved optima, 4 proofs\n");
  }
};

TEST_F(ArchiveCommand, ASetIsRunAgain) {
  make_set();
  static_cast<void>(run("run --instances small.tar.zst --out again --quiet"));
  EXPECT_EQ(parse_csv(read("again/runs.csv")).size(), 1u + 4);
  write("own.toml",
        "name = \"own\"\nsummary = \"x\"\nfamilies = [\"lattice\"]\nsizes = [9]\nalgorithms = [\"flip\", "
        "\"delaunay\"]\n");
  static_cast<void>(run("run own.toml --instances small.tar.zst --out own --quiet"));
  const std::vector<CsvRow> rows = parse_csv(read("own/runs.csv"));
  EXPECT_EQ(rows.size(), 1u + 8) << "its points take the place of the study's";
  EXPECT_NE(read("own/study.toml").find("# Run on the points of the benchmark set with SHA-256 "), std::string::npos);
}

TEST_F(ArchiveCommand, OtherProgramsReadASet) {
  make_set();
  EXPECT_EQ(shell("zstd -dq small.tar.zst && tar xf small.tar && cd small && sha256sum -c --quiet SHA256SUMS"), 0);
  EXPECT_TRUE(exists("small/README.md"));
}

TEST_F(ArchiveCommand, TheSameRecordsGiveTheSameBytes) {
  make_set();
  static_cast<void>(run("archive r -o again.tar.zst"));
  EXPECT_EQ(shell("cmp small.tar.zst again.tar.zst"), 0);
}

TEST_F(ArchiveCommand, DamagedSetsAreRefused) {
  make_set();
  EXPECT_EQ(shell("head -c 2000 small.tar.zst > cut.tar.zst"), 0);
  expect_mistake("run --instances cut.tar.zst", "cut off");
  EXPECT_EQ(
      shell("zstd -dq small.tar.zst && tar xf small.tar && echo '1 1' >> small/README.md && tar cf other.tar small"),
      0);
  expect_mistake("run --instances other.tar", "does not agree with its checksum");
  EXPECT_EQ(shell("tar xf small.tar && touch small/points/more.txt && tar cf more.tar small"), 0);
  expect_mistake("run --instances more.tar", "has no checksum");
  EXPECT_EQ(shell("rm small/points/more.txt small/study.toml && tar cf less.tar small"), 0);
  expect_mistake("run --instances less.tar", "is missing");
  EXPECT_EQ(shell("tar xf small.tar && mkdir away && tar cPf out.tar small/../away small"), 0);
  EXPECT_EQ(shell("cd small && tar cPf ../out.tar ../s.toml"), 0);
  expect_mistake("run --instances out.tar", "leads out of the folder");
  EXPECT_FALSE(exists("results"));
}

TEST_F(ArchiveCommand, MistakesAreNamed) {
  expect_mistake("run", "name a study");
  expect_mistake("archive missing -o a.tar.zst", "missing");
  make_set();
  expect_mistake("archive r -o a.zip", "a.zip");
}

// The published set: every instance is what its family makes, and the verifier accepts every proof.
TEST_F(ArchiveCommand, TheReferenceSetIsVerified) {
  const BenchmarkSet set = read_benchmark_set(MWT_SOURCE_DIR "/results/reference/benchmark_set.tar.zst");
  unpack(set, path("set"));
  const std::vector<CsvRow> rows = parse_csv(read("set/instances.csv"));
  ASSERT_GT(rows.size(), 200u);
  const Catalogue catalogue = Catalogue::built_in();
  std::ostringstream commands;
  std::vector<std::pair<double, double>> optima;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    EXPECT_EQ(make_instance(read_points(path("set/" + row[0])), row[0]).id, row[1]);
    const GeneratorInfo& family = catalogue.generator(row[2]);
    const Parameters parameters(family.name, family.parameters, parse_canonical(row[3]));
    const auto n = static_cast<Index>(std::stoul(row[4]));
    EXPECT_EQ(make_instance(generate_points(family, n, std::stoull(row[5]), parameters), row[0]).id, row[1]) << row[14];
    EXPECT_EQ(row[11], "proved");
    EXPECT_EQ(row[13], "optimal");
    commands << MWT_VERIFY_EXECUTABLE << " set/" << row[0] << " set/" << row[12] << '\n';
    optima.emplace_back(std::stod(row[9]), std::stod(row[10]));
  }
  write("verify.sh", commands.str());
  EXPECT_EQ(shell("sh verify.sh > verdicts"), 0);
  std::istringstream verdicts(read("verdicts"));
  std::string line;
  std::size_t count = 0;
  while (std::getline(verdicts, line)) {
    if (!line.starts_with("VERIFIED weight in [")) continue;  // what else it prints
    ASSERT_LT(count, optima.size());
    ASSERT_TRUE(line.ends_with("], optimal")) << line;
    const std::size_t comma = line.find(',');
    const double lower = std::stod(line.substr(20, comma - 20)), upper = std::stod(line.substr(comma + 1));
    EXPECT_LE(lower, optima[count].second) << line;
    EXPECT_GE(upper, optima[count].first) << line;
    ++count;
  }
  EXPECT_EQ(count, rows.size() - 1);
}

}  // namespace
}  // namespace mwt
