// Runs two builds of `mwt` in turn on this machine: what disturbs the machine then disturbs both.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "harness/catalogue.h"
#include "harness/study/study.h"

namespace mwt {

struct InterleavedOptions {
  std::string build_a;  ///< a folder with the program `mwt`, or the program itself
  std::string build_b;
  std::string folder;                   ///< gets the results: FOLDER/base and FOLDER/new
  std::vector<std::string> algorithms;  ///< only these of the study; empty: all
  int repetitions = 20;
  std::uint64_t seed = 1;  ///< of the order
  bool is_terminal = false;
};

/// In each repetition every cell of the study, in a new random order, is run once by both builds, one right after the
/// other; which one begins is drawn anew each time. Every run is a `mwt run` of a study of one cell, so that the two
/// builds need to agree on study files and the names of records' columns only. Optima are not sought: the
/// instance being the same, weights say as much. Instances from files are left out.
///
/// Leaves two folders of results, as if each build had run the study with so many repetitions. Progress goes to `out`.
/// False if interrupted: the results are then those of the complete repetitions and a part of the next.
///
/// Throws InputError: no such program; it fails (with the end of what it said); the folder holds something already; the
/// study has not all of `algorithms`, or no family.
[[nodiscard]] bool run_interleaved(const Study& study, const Catalogue& catalogue, const InterleavedOptions& options,
                                   std::ostream& out);

}  // namespace mwt
