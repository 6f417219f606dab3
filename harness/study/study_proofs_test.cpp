// Studies that ask for proofs of their optima.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "algorithms/exact/exact.h"
#include "algorithms/proof_trace.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/rating/optimum_cache.h"
#include "harness/records/proof_folder.h"
#include "harness/records/results_folder.h"
#include "harness/run/testing/algorithms_testing.h"
#include "harness/study/merge.h"
#include "harness/study/run_study.h"
#include "verifier/verify.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TestFolder;
using testing::write_text;

constexpr double kPatience = 60;  // s, for a busy machine

// Claims that its Delaunay triangulation is optimal, and writes a well-formed proof of that.
Solution forge(Points points, Context& context) {
  Solution solution = testing::delaunay_solution(points);
  solution.optimum = weight(points, solution.triangulation);
  if (context.proof != nullptr) *context.proof = trace_of_bound(solution.optimum->lower);
  return solution;
}

// Certifies nearly all of the optimum, and what it writes as its proof is of the hull alone.
Solution bound_by_hull(Points points, Context& context) {
  Solution solution = testing::solve_with_weak_bound(points, context);
  solution.optimum->lower = 1e-3;
  if (context.proof != nullptr) *context.proof = trace_of_bound(solution.optimum->lower);
  return solution;
}

class StudyProofs : public ::testing::Test {
 protected:
  StudyProofs() {
    study_.name = "s";
    study_.file_content = kStudyFile;
    study_.families = {{"uniform", {}, {}, {}, ""}};
    study_.sizes = {12, 30};
    study_.min_time_s = 1e-4;
    study_.limits = {kPatience, kPatience, std::uint64_t{1} << 30};
    study_.optimum_limits = study_.limits;
    study_.optimum_sources = {{"exact", {}, ""}};
    study_.algorithms = {{"well", {}, {}, ""}};
    study_.max_proof_n = 1000;
    write_text(folder_.path("s.toml"), kStudyFile);
  }

  static constexpr const char* kStudyFile = R"(name = "s"
summary = "t"
families = ["uniform"]
sizes = [12, 30]
algorithms = ["well"]
min_time_s = 1e-4
[limits]
time_s = 60
[optimum]
sources = ["exact"]
proofs = { max_n = 20 }
)";

  // What it prints.
  std::string run(const std::string& out) {
    std::ostringstream text;
    static_cast<void>(run_study(study_, catalogue(), {path(out), false, 1, false, path("optima")}, text));
    return text.str();
  }

  [[nodiscard]] std::vector<InstanceRecord> instances(const std::string& out) const {
    return read_records(path(out)).instances;
  }

  void expect_all_verified(const std::string& out) const {
    for (const InstanceRecord& record : instances(out)) {
      EXPECT_EQ(record.optimality, "proved");
      EXPECT_EQ(record.verified, ProofVerdict::optimal) << record.proof_note;
      EXPECT_EQ(record.proof_bytes, std::filesystem::file_size(proof_of(out, record)));
      EXPECT_GT(record.verify_time_s, 0);
    }
  }

  [[nodiscard]] std::string proof_of(const std::string& out, const InstanceRecord& record) const {
    return proof_file(path(out), record.instance_id);
  }

  [[nodiscard]] std::vector<std::string> cached_proofs() const {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(path("optima"))) {
      if (entry.path().extension() == ".mwtproof") files.push_back(entry.path().string());
    }
    return files;
  }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

  static Catalogue catalogue() {
    static const std::vector<AlgorithmInfo> algorithms = [] {
      std::vector<AlgorithmInfo> all = {exact_entry(), testing::entry("well", testing::solve_well),
                                        testing::entry("forges", forge, Exactness::exact),
                                        testing::entry("bounds", bound_by_hull, Exactness::exact),
                                        testing::entry("fan_exact", testing::solve_fan_exactly, Exactness::exact)};
      all[2].has_proofs = all[3].has_proofs = true;
      return all;
    }();
    return {algorithms, generators()};
  }

  TestFolder folder_;
  Study study_;
};

TEST_F(StudyProofs, AreKeptAndVerified) {
  run("out");
  expect_all_verified("out");
  ASSERT_EQ(instances("out").size(), 2u);
  for (const InstanceRecord& record : instances("out")) {
    const std::vector<Point> points =
        catalogue().generator(record.generator).function(record.n, record.seed, Parameters("", {}, {}));
    const verifier::Verdict verdict = verifier::verify(points, proof_of("out", record));
    EXPECT_TRUE(verdict.is_optimal);
    EXPECT_LE(verdict.lower, record.optimum_upper);
    EXPECT_GE(verdict.upper, record.optimum_lower);
  }
}

TEST_F(StudyProofs, ComeFromTheCacheAndAreVerifiedAgain) {
  run("first");
  EXPECT_EQ(cached_proofs().size(), 2u);
  run("second");
  expect_all_verified("second");
  for (const InstanceRecord& record : instances("second")) {
    EXPECT_EQ(record.optimum_note, kCachedNote);
    EXPECT_EQ(read_text(proof_of("first", record)), read_text(proof_of("second", record)));
  }
}

TEST_F(StudyProofs, AreMadeForCachedOptimaWithoutOne) {
  study_.max_proof_n = 0;
  run("first");
  for (const InstanceRecord& record : instances("first")) EXPECT_FALSE(record.verified);
  EXPECT_FALSE(std::filesystem::exists(path("first/proofs")));
  study_.max_proof_n = 1000;
  run("second");
  expect_all_verified("second");
  for (const InstanceRecord& record : instances("second")) {
    EXPECT_EQ(record.optimum_note, "") << "its optimum was found anew";
    EXPECT_EQ(record.optimum_source, "exact");
  }
  EXPECT_EQ(cached_proofs().size(), 2u);
}

TEST_F(StudyProofs, AreMadeAnewForDamagedOnesInTheCache) {
  run("first");
  for (const std::string& file : cached_proofs()) {
    const std::string whole = read_text(file);
    write_text(file, whole.substr(0, whole.size() / 2));
  }
  run("second");
  expect_all_verified("second");
  for (const InstanceRecord& record : instances("second"))
    EXPECT_EQ(read_text(proof_of("first", record)), read_text(proof_of("second", record)));
}

TEST_F(StudyProofs, AreAskedForUpToTheSizeOfTheStudy) {
  study_.max_proof_n = 20;
  run("out");
  const std::vector<InstanceRecord> records = instances("out");
  ASSERT_EQ(records.size(), 2u);
  for (const InstanceRecord& record : records) {
    EXPECT_EQ(record.verified.has_value(), record.n == 12);
    EXPECT_EQ(std::filesystem::exists(proof_of("out", record)), record.n == 12);
  }
}

TEST_F(StudyProofs, ThatAreForgedAreRefusedAloud) {
  study_.optimum_sources = {{"forges", {}, ""}};
  const std::string text = run("out");
  for (const InstanceRecord& record : instances("out")) {
    EXPECT_EQ(record.verified, ProofVerdict::refused);
    EXPECT_NE(record.proof_note, "");
  }
  EXPECT_NE(text.find("uniform n=12 seed=1: the verifier refuses the proof: "), std::string::npos) << text;
  EXPECT_TRUE(cached_proofs().empty());
}

TEST_F(StudyProofs, OfBoundsAreVerifiedAsSuch) {
  study_.optimum_sources = {{"bounds", {}, ""}};
  run("out");
  for (const InstanceRecord& record : instances("out")) EXPECT_EQ(record.verified, ProofVerdict::bounded);
}

TEST_F(StudyProofs, OfTheSourceThatCertifiesMostAreKept) {
  for (const auto& sources : {std::pair("bounds", "exact"), std::pair("exact", "bounds")}) {
    study_.optimum_sources = {{sources.first, {}, ""}, {sources.second, {}, ""}};
    run(sources.first);
    expect_all_verified(sources.first);
  }
}

TEST_F(StudyProofs, AreMissingWhereNoSourceWritesThem) {
  study_.families = {{"fan", {}, {}, {}, ""}};
  study_.optimum_sources = {{"fan_exact", {}, ""}};
  run("out");
  for (const InstanceRecord& record : instances("out")) {
    EXPECT_EQ(record.optimality, "proved");
    EXPECT_FALSE(record.verified);
  }
}

TEST_F(StudyProofs, GoWithTheirShards) {
  study_ = read_study(path("s.toml"));
  for (std::size_t shard = 1; shard <= 2; ++shard) {
    std::ostringstream text;
    RunOptions options;
    options.folder = path("part" + std::to_string(shard));
    options.shard = {shard, 2};
    static_cast<void>(run_study(study_, catalogue(), options, text));
  }
  MergeOptions options;
  options.folders = {path("part1"), path("part2")};
  options.target = path("merged");
  static_cast<void>(merge_results(options, catalogue()));
  std::size_t verified = 0;
  for (const InstanceRecord& record : instances("merged")) {
    EXPECT_EQ(std::filesystem::exists(proof_of("merged", record)), record.verified.has_value());
    verified += record.verified == ProofVerdict::optimal ? 1 : 0;
  }
  EXPECT_EQ(verified, 1u);
}

TEST_F(StudyProofs, OfAKilledWriterAreSweptAway) {
  prepare_proof_folder(path("out"));
  write_text(path("out/proofs/.mwt-1-0.tmp"), "x");
  write_text(path("out/proofs/a.mwtproof"), "x");
  prepare_proof_folder(path("out"));
  EXPECT_FALSE(std::filesystem::exists(path("out/proofs/.mwt-1-0.tmp")));
  EXPECT_TRUE(std::filesystem::exists(path("out/proofs/a.mwtproof")));
}

}  // namespace
}  // namespace mwt
