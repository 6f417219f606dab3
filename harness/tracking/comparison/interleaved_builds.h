// Runs two builds of `mwt` in turn on this machine: what disturbs the machine then disturbs both.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "harness/run/catalogue.h"
#include "harness/study/study.h"
#include "harness/tracking/cell.h"

namespace mwt {

struct InterleavedOptions {
  std::string build_a;  ///< a folder with the program `mwt`, or the program itself
  std::string build_b;
  std::string folder;                   ///< gets the results: FOLDER/base and FOLDER/new
  std::vector<std::string> algorithms;  ///< only these of the study; empty: all
  std::uint64_t seed = 1;               ///< of the order
  std::optional<double> budget_s;       ///< after so long no repetition begins except the first of each run()
  bool with_counts = false;             ///< if the study asks for counts; both builds must know them
  bool is_terminal = false;
};

/// In each repetition every chosen cell of the study, in a new random order, is run once by both builds, one right
/// after the other; which one begins is drawn anew each time. The first two repetitions are counted, too, where wanted.
/// Every run is a `mwt run` of a study of one cell, so that the two builds need to agree on study files and the names
/// of records' columns only. Optima are not sought: on the same instance, weights compare as well.
///
/// Leaves two folders of results, as if each build had run the study with so many repetitions. Progress goes to `out`.
///
/// Throws InputError: no such program; it fails (with the end of its output); the folder holds something already; the
/// study lacks one of `algorithms`, or has nothing to run.
class InterleavedBuilds {
 public:
  InterleavedBuilds(const Study& study, const Catalogue& catalogue, const InterleavedOptions& options,
                    std::ostream& out);
  ~InterleavedBuilds();
  InterleavedBuilds(const InterleavedBuilds&) = delete;
  InterleavedBuilds& operator=(const InterleavedBuilds&) = delete;

  /// All cells that can be run.
  [[nodiscard]] std::set<TrackedCell> cells() const;

  /// So many repetitions more of these cells, or as many as the budget allows. False if interrupted: the results are
  /// then those of the complete repetitions and a part of the next. Precondition: `chosen` is a part of cells().
  [[nodiscard]] bool run(const std::set<TrackedCell>& chosen, int repetitions);

  [[nodiscard]] bool is_out_of_time() const;
  [[nodiscard]] int repetitions() const;  ///< so far

  [[nodiscard]] std::string base_folder() const;
  [[nodiscard]] std::string new_folder() const;

 private:
  struct Sides;

  std::map<TrackedCell, std::string> studies_;  // a study file for each cell
  InterleavedOptions options_;
  std::ostream& out_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::unique_ptr<Sides> sides_;
};

}  // namespace mwt
