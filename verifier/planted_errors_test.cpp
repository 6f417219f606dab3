// Damaged proofs, and proofs of solvers that are wrong: none may be believed.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "base/error.h"
#include "base/testing/test_folder.h"
#include "verifier/refused.h"
#include "verifier/testing/damage.h"
#include "verifier/testing/naive_prover.h"
#include "verifier/verify.h"

namespace mwt::verifier {
namespace {

using namespace testing;

enum class Outcome { verified, refused, no_proof };

struct Trial {
  Outcome outcome = Outcome::refused;
  Verdict verdict;
  std::string message;  // of a refusal
};

// What the verifier says of these bytes. Anything but a verdict, Refused or InputError fails the test that asks.
class Court {
 public:
  Trial judge(const std::vector<Point>& points, const std::vector<std::uint8_t>& file) const {
    write_file(folder_.path("proof"), file);
    try {
      return {Outcome::verified, verify(points, folder_.path("proof")), ""};
    } catch (const Refused& refused) {
      return {Outcome::refused, {}, refused.what()};
    } catch (const InputError&) {
      return {Outcome::no_proof, {}, ""};
    }
  }
  Trial judge(const std::vector<Point>& points, const Proof& proof) const {
    return judge(points, file_of(encode(proof)));
  }

 private:
  test::TestFolder folder_;
};

struct Instance {
  std::vector<Point> points;
  Proof proof;
  Verdict verdict;
};

void add_instance(const Court& court, const std::vector<Point>& points, std::vector<Instance>& instances) {
  const auto proof = NaiveProver(points).prove();
  if (!proof) return;
  const Trial trial = court.judge(points, *proof);
  EXPECT_EQ(trial.outcome, Outcome::verified);
  instances.push_back({points, *proof, trial.verdict});
}

// Every third on a lattice, where ties and collinear triples abound; the others have one optimum.
std::vector<Instance> instances(const Court& court, unsigned seeds, bool lattices = true) {
  std::vector<Instance> result;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const bool is_lattice = seed % 3 == 0;
    if (is_lattice && !lattices) continue;
    add_instance(court, random_points(6 + seed % 17, seed, is_lattice ? 6 : 0), result);
  }
  return result;
}

// About half of the 25 points of a lattice.
std::vector<Instance> dense_lattices(const Court& court) {
  std::vector<Instance> result;
  for (unsigned seed = 1; seed <= 1500; ++seed) add_instance(court, random_points(7 + seed % 14, seed, 5), result);
  return result;
}

struct Count {
  int tried = 0, refused = 0, harmless = 0;
};

void print(const std::string& kind, const Count& count) {
  std::cout << "| " << kind << " | " << count.tried << " | " << count.refused << " | " << count.harmless << " |\n";
}

TEST(PlantedErrors, DamagedProofsAreRefusedOrStillTrue) {
  const Court court;
  const std::vector<Instance> all = instances(court, 60, /*lattices=*/false);
  ASSERT_GT(all.size(), 20U);
  unsigned seed = 1;
  for (const Damage& damage : damages()) {
    Count count;
    for (const Instance& instance : all) {
      Patient patient{instance.proof, instance.points};
      Dice dice(seed++);
      if (!damage.apply(patient, dice)) continue;
      ++count.tried;
      SCOPED_TRACE(damage.name + ", seed " + std::to_string(seed - 1));
      const Trial trial = court.judge(instance.points, patient.proof);
      if (trial.outcome != Outcome::verified) {
        ++count.refused;
        continue;
      }
      ++count.harmless;
      EXPECT_EQ(damage.harm, Harm::possible);
      EXPECT_LE(trial.verdict.lower, instance.verdict.upper);
      EXPECT_GE(trial.verdict.upper, instance.verdict.lower);
    }
    EXPECT_GE(count.tried, 5) << damage.name;
    print(damage.name, count);
  }
}

// The optimum claimed is wrong in some instances; of the others, the proof may be in order by chance.
void expect_refused(const std::string& kind, const std::vector<Instance>& all, int min_wrong,
                    const std::function<std::optional<Proof>(const Instance&)>& broken) {
  const Court court;
  Count count;
  int wrong = 0;
  for (const Instance& instance : all) {
    const std::optional<Proof> proof = broken(instance);
    if (!proof) continue;
    ++count.tried;
    const Trial trial = court.judge(instance.points, *proof);
    const bool is_wrong = proof->claimed_lower > instance.verdict.upper;
    wrong += is_wrong ? 1 : 0;
    if (trial.outcome != Outcome::verified) {
      ++count.refused;
      continue;
    }
    ++count.harmless;
    EXPECT_FALSE(is_wrong) << kind;
    EXPECT_LE(trial.verdict.lower, instance.verdict.upper);
    EXPECT_GE(trial.verdict.upper, instance.verdict.lower);
  }
  EXPECT_GE(wrong, min_wrong) << kind << ": too few instances on which this error matters";
  print(kind + " (" + std::to_string(wrong) + " wrong optima)", count);
}

TEST(PlantedErrors, WrongSolversAreRefused) {
  const Court court;
  const std::vector<Instance> all = instances(court, 500);
  const auto with_fault = [](Fault fault) {
    return [fault](const Instance& instance) { return NaiveProver(instance.points, fault).prove(); };
  };
  expect_refused("solver: diamonds of base angle 60 degrees", all, 3, with_fault(Fault::diamond_too_large));
  expect_refused("solver: LMT deletes ties", dense_lattices(court), 3, with_fault(Fault::deletes_ties));
  expect_refused("solver: triangles occupied if their boxes are", all, 3, with_fault(Fault::occupied_too_early));
  expect_refused("solver: some crossing edges overlooked", all, 3, with_fault(Fault::forgets_to_check_sides));
  expect_refused("solver: a point forgotten", all, 20,
                 [](const Instance& instance) { return prove_without_a_point(instance.points); });
  expect_refused("solver: a candidate of a face forgotten", all, 20,
                 [](const Instance& instance) { return NaiveProver(instance.points).prove_without_an_edge(); });
}

TEST(PlantedErrors, DamagedFilesAreRefused) {
  const Court court;
  const std::vector<Instance> all = instances(court, 3);
  Count cut, extended, flipped, version;
  for (const Instance& instance : all) {
    const std::vector<std::uint8_t> plain = encode(instance.proof), file = file_of(plain);
    for (std::size_t size = 0; size < file.size(); ++size) {
      ++cut.tried;
      cut.refused +=
          court.judge(instance.points, {file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)}).outcome !=
          Outcome::verified;
    }
    for (std::size_t size = 0; size < plain.size(); ++size) {
      ++cut.tried;
      cut.refused +=
          court.judge(instance.points, file_of({plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(size)}))
              .outcome != Outcome::verified;
    }
    for (const auto& [front, back] : {std::pair{plain, std::vector<std::uint8_t>{0}}, {plain, plain}}) {
      ++extended.tried;
      std::vector<std::uint8_t> longer = front;
      longer.insert(longer.end(), back.begin(), back.end());
      extended.refused += court.judge(instance.points, file_of(longer)).outcome != Outcome::verified;
      ++extended.tried;
      longer = file;
      longer.insert(longer.end(), back.begin(), back.end());
      extended.refused += court.judge(instance.points, longer).outcome != Outcome::verified;
    }
    for (const std::uint32_t other : {0U, 1U, 256U, 0x80000002U}) {
      ++version.tried;
      version.refused += court.judge(instance.points, file_of(plain, other)).outcome == Outcome::no_proof;
    }
    for (std::size_t byte = 0; byte < 12; ++byte) {
      ++flipped.tried;
      std::vector<std::uint8_t> changed = file;
      changed[byte] ^= 0x10;
      flipped.refused += court.judge(instance.points, changed).outcome == Outcome::no_proof;
    }
  }
  for (const Count& count : {cut, extended, flipped, version}) {
    EXPECT_GT(count.tried, 0);
    EXPECT_EQ(count.refused, count.tried);
  }
  print("file cut", cut);
  print("file with something after its end", extended);
  print("byte of the file's header changed", flipped);
  print("other version", version);
}

// Bytes of the body changed at random, so that every number meets values it is not made for.
void fuzz(unsigned seeds, int rounds) {
  const Court court;
  Count count;
  Dice dice(1);
  for (const Instance& instance : instances(court, seeds)) {
    const std::vector<std::uint8_t> plain = encode(instance.proof);
    for (int round = 0; round < rounds; ++round) {
      std::vector<std::uint8_t> changed = plain;
      for (std::size_t changes = 1 + dice.below(3); changes > 0; --changes) {
        static constexpr std::uint8_t kSpecial[] = {0, 1, 2, 0x7F, 0x80, 0xFF};
        const std::size_t place = dice.below(changed.size());
        switch (dice.below(4)) {
          case 0: changed[place] = kSpecial[dice.below(6)]; break;
          case 1: changed[place] ^= static_cast<std::uint8_t>(1U << dice.below(8)); break;
          case 2: changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(place)); break;
          default: changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(place), kSpecial[dice.below(6)]); break;
        }
      }
      if (changed == plain) continue;
      ++count.tried;
      const Trial trial = court.judge(instance.points, file_of(changed));
      if (trial.outcome != Outcome::verified) {
        ++count.refused;
        continue;
      }
      ++count.harmless;
      ASSERT_LE(trial.verdict.lower, instance.verdict.upper);
      ASSERT_GE(trial.verdict.upper, instance.verdict.lower);
    }
  }
  EXPECT_GT(count.tried, rounds);
  print("bytes of the body changed, removed, inserted", count);
}

TEST(PlantedErrors, RandomBytesAreRefusedOrStillTrue) { fuzz(12, 150); }
TEST(PlantedErrorsSlow, RandomBytesAreRefusedOrStillTrue) { fuzz(60, 5000); }

TEST(PlantedErrors, BombsAreRefused) {
  const Court court;
  const std::vector<Point> points = random_points(10, 1);
  std::vector<std::uint8_t> plain = encode(*NaiveProver(points).prove());
  plain.pop_back();  // without its end
  // Megabytes of empty lists in a few hundred bytes.
  std::vector<std::uint8_t> bomb = plain;
  for (std::size_t i = 0; i < (std::size_t{1} << 23); ++i) bomb.insert(bomb.end(), {1, 0});
  EXPECT_EQ(court.judge(points, file_of(bomb)).outcome, Outcome::refused);
  // A region with more places than anybody has memory for.
  Encoder region;
  region.number(5);
  region.signed_number(0);
  region.number(1);
  region.number(~std::uint64_t{0});
  std::vector<std::uint8_t> huge = plain;
  huge.insert(huge.end(), region.bytes().begin(), region.bytes().end());
  EXPECT_EQ(court.judge(points, file_of(huge)).outcome, Outcome::refused);
}

// What a file of kilobytes may make the verifier store must depend on the number of points, not on how long its lists
// of zeros are.
TEST(PlantedErrors, RegionsHaveNoMorePartsThanPointsAllow) {
  const Court court;
  const std::vector<Point> points = random_points(10, 1);
  std::vector<std::uint8_t> plain = encode(*NaiveProver(points).prove());
  plain.pop_back();  // without its end
  const auto complaint = [&](std::initializer_list<std::uint64_t> numbers) {
    Encoder region;
    for (const std::uint64_t number : numbers) region.number(number);
    std::vector<std::uint8_t> body = plain;
    body.insert(body.end(), region.bytes().begin(), region.bytes().end());
    body.resize(body.size() + 100'000);
    return court.judge(points, file_of(body)).message;
  };
  constexpr std::uint64_t kMany = std::uint64_t{1} << 40;
  EXPECT_NE(complaint({5, 0, 0}).find("a region has no boundary"), std::string::npos);
  EXPECT_NE(complaint({5, 0, 1, kMany}).find("too many places"), std::string::npos);
  EXPECT_NE(complaint({5, 0, 1, 2, 0, 2, kMany}).find("too many places"), std::string::npos);
  EXPECT_NE(complaint({5, 0, 1, 3, 0, 2, 2, 0, kMany}).find("more edges begin at a place"), std::string::npos);
}

TEST(PlantedErrors, ProofsOfOtherPointsAreRefused) {
  const Court court;
  const std::vector<Instance> all = instances(court, 20);
  for (const Instance& instance : all) {
    std::vector<Point> moved = instance.points;
    moved.back().x = std::nextafter(moved.back().x, 9);
    EXPECT_EQ(court.judge(moved, instance.proof).outcome, Outcome::refused);
    std::vector<Point> exchanged = instance.points;
    std::swap(exchanged.front(), exchanged.back());
    EXPECT_EQ(court.judge(exchanged, instance.proof).outcome, Outcome::refused);
  }
}

}  // namespace
}  // namespace mwt::verifier
