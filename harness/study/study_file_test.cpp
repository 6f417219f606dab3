#include <gtest/gtest.h>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/study/study.h"

namespace mwt {
namespace {

const std::string kMinimal = "name = \"s\"\nsummary = \"t\"\nfamilies = [\"*\"]\nalgorithms = [\"*\"]\n";

Study read(const std::string& text) {
  const testing::TestFolder folder;
  testing::write_text(folder.path("s.toml"), text);
  return read_study(folder.path("s.toml"));
}

std::string complaint(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find("s.toml"));
  }
  return "none";
}

TEST(StudyFile, DefaultsAreFilledIn) {
  const Study study = read(kMinimal + "sizes = [10]\n");
  EXPECT_EQ(study.seeds, std::vector<std::uint64_t>{1});
  EXPECT_EQ(study.repetitions, 1);
  EXPECT_TRUE(study.seeks_optimum);
  EXPECT_EQ(study.max_proof_n, 0u);
  EXPECT_FALSE(judges_claims(study.file_content));
  EXPECT_EQ(study.families.front().name, "*");
}

TEST(StudyFile, ProofsAreAskedForUpToASize) {
  const auto max_proof_n = [](const std::string& proofs) {
    return read(kMinimal + "sizes = [10]\n[optimum]\nproofs = " + proofs + "\n").max_proof_n;
  };
  EXPECT_EQ(max_proof_n("true"), std::numeric_limits<std::size_t>::max());
  EXPECT_EQ(max_proof_n("false"), 0u);
  EXPECT_EQ(max_proof_n("{ max_n = 10000 }"), 10000u);
  const auto mistake = [](const std::string& optimum) {
    return complaint(kMinimal + "sizes = [10]\n[optimum]\n" + optimum + "\n");
  };
  EXPECT_NE(mistake("proofs = 3").find("'proofs' must be"), std::string::npos) << mistake("proofs = 3");
  EXPECT_NE(mistake("proofs = {}").find("'proofs' must be true, false or { max_n = number of points }"),
            std::string::npos);
  EXPECT_NE(mistake("proofs = { max_n = -1 }").find("max_n"), std::string::npos);
  EXPECT_NE(mistake("proofs = { n = 3, max_n = 4 }").find("'n'"), std::string::npos);
  EXPECT_NE(mistake("seek = false\nproofs = true").find("does not seek"), std::string::npos);
}

TEST(StudyFile, EverythingCanBeSaid) {
  const Study study = read(R"(
name = "s"
summary = "t"
families = ["uniform", { name = "clustered", parameters = { clusters = [3, 10], sigma = 0.5 }, sizes = [100], seeds = [7] }]
sizes = [10, 20]
seeds = [1, 2]
algorithms = [{ name = "tuned", parameters = { k = [1, 2], start = ["a", "b"] }, max_n = 50, families = ["uniform"] }]
repetitions = 3
threads = 2
min_time_s = 0.5
delaunay_time = true
claims = true
[instances]
folder = "points"
files = ["*.tsp", "more/*.txt"]
[limits]
time_s = 7
grace_s = 0.5
memory_mb = 100
[optimum]
time_s = 9
sources = ["x", { name = "y", max_n = 12 }]
)");
  ASSERT_EQ(study.families.size(), 3u);
  EXPECT_EQ(study.families[2].parameters.at("clusters"), "10");
  EXPECT_EQ(study.families[2].parameters.at("sigma"), "0.5");
  EXPECT_EQ(study.families[1].sizes, std::vector<Index>{100});
  EXPECT_EQ(study.algorithms.size(), 4u);
  EXPECT_TRUE(study.measures_delaunay_time);
  EXPECT_TRUE(judges_claims(study.file_content));
  EXPECT_TRUE(study.instance_files.folder.ends_with("/points")) << study.instance_files.folder;
  EXPECT_EQ(study.instance_files.patterns, (std::vector<std::string>{"*.tsp", "more/*.txt"}));
  EXPECT_EQ(study.algorithms.front().max_n, 50u);
  EXPECT_EQ(study.algorithms.front().families, std::vector<std::string>{"uniform"});
  EXPECT_EQ(study.limits.memory_bytes, 100u << 20);
  EXPECT_EQ(study.optimum_limits.time_s, 9);
  EXPECT_EQ(study.optimum_limits.grace_s, 0.5);
  ASSERT_EQ(study.optimum_sources.size(), 2u);
  EXPECT_EQ(study.optimum_sources[1].max_n, 12u);
}

// "../evil" left results/.
TEST(StudyFile, ANameIsNoPath) {
  for (const char* name : {"../evil", "/evil", "a/b", ".", "..", ".hidden", "-option", "", "a b", "a\\n", "\xc3\xa9"}) {
    const std::string text = "name = \"" + std::string(name) + "\"\nsummary = \"t\"\n";
    EXPECT_TRUE(complaint(text).starts_with("s.toml:1: 'name' must be at most 100 letters, digits and ._+-")) << name;
  }
  EXPECT_TRUE(complaint("name = \"" + std::string(101, 'a') + "\"\n").starts_with("s.toml:1: 'name' must be"));
  EXPECT_EQ(read("name = \"My_study-2.1+\"\nsummary = \"t\"\nfamilies = [\"*\"]\nalgorithms = [\"*\"]\n").name,
            "My_study-2.1+");
}

TEST(StudyFile, AbsurdValuesAreRefused) {
  EXPECT_EQ(complaint(kMinimal + "sizes = [1000000000000]\n"), "s.toml:5: 'sizes' must be below 2^32 - 1");
  EXPECT_EQ(complaint(kMinimal + "repetitions = -1\n"), "s.toml:5: 'repetitions' must be a whole number of at least 1");
  EXPECT_EQ(complaint(kMinimal + "seeds = []\n"), "s.toml:5: 'seeds' must be a list, not empty");
  EXPECT_EQ(complaint(kMinimal + "[limits]\ntime_s = nan\n"),
            "s.toml:6: 'time_s' must be a positive number of at most 1e9");
  EXPECT_EQ(complaint(kMinimal + "min_time_s = 100\n[limits]\ntime_s = 10\n"),
            "s.toml:5: 'min_time_s' is more than a run may take, [limits] time_s + grace_s");
  EXPECT_EQ(complaint(kMinimal + "[instances]\nfiles = [\"a/../../b\"]\n"),
            "s.toml:6: 'files' are within 'folder': no .. in them");
  std::string many = "[1";
  for (int i = 2; i <= 30; ++i) many += ", " + std::to_string(i);
  many += "]";
  EXPECT_EQ(
      complaint("name = \"s\"\nsummary = \"t\"\nfamilies = [\"*\"]\nalgorithms = [{ name = \"a\", parameters = { a = " +
                many + ", b = " + many + ", c = " + many + " } }]\n"),
      "s.toml:4: the lists of parameters make more than 10000 combinations");
}

TEST(StudyFile, MistakesNameLineAndKey) {
  EXPECT_EQ(complaint("name = "),
            "s.toml:1: not valid TOML: Error while parsing key-value pair: encountered end-of-file");
  EXPECT_EQ(complaint("name = \"s\"\n"), "s.toml:1: a study needs the key 'summary'");
  EXPECT_TRUE(complaint(kMinimal + "repetition = 3\n").starts_with("s.toml:5: a study has no key 'repetition'"));
  EXPECT_EQ(complaint(kMinimal + "sizes = [10, \"x\"]\n"), "s.toml:5: 'sizes' must be a whole number of at least 3");
  EXPECT_EQ(complaint(kMinimal + "sizes = [2]\n"), "s.toml:5: 'sizes' must be a whole number of at least 3");
  EXPECT_EQ(complaint(kMinimal + "sizes = 10\n"), "s.toml:5: 'sizes' must be a list, not empty");
  EXPECT_EQ(complaint(kMinimal + "min_time_s = -1\n"),
            "s.toml:5: 'min_time_s' must be a positive number of at most 1e9");
  EXPECT_EQ(complaint(kMinimal + "min_time_s = nan\n"),
            "s.toml:5: 'min_time_s' must be a positive number of at most 1e9");
  EXPECT_TRUE(complaint(kMinimal + "[limits]\ntimes = 1\n").starts_with("s.toml:6: [limits] has no key 'times'"));
  EXPECT_EQ(complaint(kMinimal + "limits = 1\n"), "s.toml:5: 'limits' must be a table");
  EXPECT_EQ(complaint(kMinimal + "min_time_s = 1e300\n"),
            "s.toml:5: 'min_time_s' must be a positive number of at most 1e9");
  EXPECT_EQ(complaint(kMinimal + "repetitions = 4294967297\n"), "s.toml:5: 'repetitions' must be at most 1000000");
  EXPECT_EQ(complaint("name = \"s\"\nsummary = \"t\"\nfamilies = [\"*\"]\nalgorithms = [{ name = \"a\", parameters = { "
                      "k = [] } }]\n"),
            "s.toml:4: parameter 'k' must not be an empty list");
  EXPECT_EQ(complaint(kMinimal + "claims = \"C1\"\n"), "s.toml:5: 'claims' must be true or false");
  EXPECT_EQ(complaint(kMinimal + "delaunay_time = 1\n"), "s.toml:5: 'delaunay_time' must be true or false");
  EXPECT_EQ(complaint(kMinimal + "[instances]\nfolder = \"x\"\n"), "s.toml:5: [instances] needs the key 'files'");
  EXPECT_EQ(complaint(kMinimal + "[instances]\nfiles = [\"/x\"]\n"),
            "s.toml:6: 'files' are within 'folder': no leading /");
  EXPECT_EQ(complaint("name = \"s\"\nsummary = \"t\"\nfamilies = [1]\nalgorithms = [\"*\"]\n"),
            "s.toml:3: 'families' lists names or tables with a name");
}

TEST(StudyFile, AnotherFolderOfInstancesCanBeNamed) {
  const testing::TestFolder folder;
  testing::write_text(folder.path("s.toml"), kMinimal + "[instances]\nfiles = [\"*.tsp\"]\n");
  EXPECT_EQ(read_study(folder.path("s.toml"), "elsewhere").instance_files.folder, "elsewhere");
  testing::write_text(folder.path("s.toml"), kMinimal);
  EXPECT_THROW(static_cast<void>(read_study(folder.path("s.toml"), "elsewhere")), InputError);
}

TEST(ResultChoice, IsListsOfNamesAndSizes) {
  const testing::TestFolder folder;
  const std::string path = folder.path("choice.toml");
  testing::write_text(path, "families = [\"uniform\"]\nsizes = [20, 50]\n");
  const ResultChoice choice = read_result_choice(path);
  EXPECT_EQ(choice.families, std::vector<std::string>{"uniform"});
  EXPECT_EQ(choice.sizes, (std::vector<Index>{20, 50}));
  EXPECT_TRUE(choice.algorithms.empty());
  for (const char* wrong : {"", "familes = [\"uniform\"]\n", "sizes = [\"20\"]\n", "families = \"uniform\"\n", "["}) {
    testing::write_text(path, wrong);
    EXPECT_THROW(static_cast<void>(read_result_choice(path)), InputError) << wrong;
  }
}

TEST(FindStudy, KnowsTheProjectsStudiesAndTakesPaths) {
  const std::vector<std::string> names = study_names();
  EXPECT_NE(std::find(names.begin(), names.end(), "claims"), names.end());
  for (const std::string& name : names) EXPECT_EQ(read_study(find_study_file(name)).name, name);
  EXPECT_EQ(find_study_file("some/where"), "some/where");
  EXPECT_THROW(static_cast<void>(find_study_file("no_such_study")), InputError);
}

TEST(StudyFile, Counts) {
  const auto max_counted_n = [](const std::string& counts) {
    return read(counts + '\n' + kMinimal + "sizes = [10]\n").max_counted_n;
  };
  EXPECT_EQ(max_counted_n(""), 0u);
  EXPECT_EQ(max_counted_n("counts = \"callgrind\""), 1000u);
  EXPECT_EQ(max_counted_n("counts = { tool = \"callgrind\", max_n = 50 }"), 50u);
  EXPECT_NE(complaint("counts = \"perf\"\n" + kMinimal + "sizes = [10]\n")
                .find("'counts' has the tool 'callgrind' alone, not 'perf'"),
            std::string::npos)
      << complaint("counts = \"perf\"\n" + kMinimal + "sizes = [10]\n");
  EXPECT_NE(complaint("threads = 2\ncounts = \"callgrind\"\n" + kMinimal + "sizes = [10]\n")
                .find("'counts' are of one thread"),
            std::string::npos);
}

}  // namespace
}  // namespace mwt
