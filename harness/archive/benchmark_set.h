// A benchmark set: the instances of a study with what is proved of them, in one file that can be deposited and cited.
#pragma once

#include <string>
#include <vector>

#include "harness/archive/tar.h"
#include "harness/records/results_folder.h"
#include "harness/run/catalogue.h"

namespace mwt {

/// The files of a set, all in one folder with the set's name:
///   README.md       what it is, how it was made, licence and citation
///   study.toml      a study of these points: `mwt run --instances SET` runs it
///   instances.csv   per instance its points, the command that makes them, its certified optimum, its proof
///   points/*.txt    x y per line, shortest decimal numbers that read back as the same doubles
///   proofs/*.mwtproof   of the optima that have one (verifier/FORMAT.md)
///   SHA256SUMS      of all other files
struct BenchmarkSet {
  std::string name;
  std::vector<TarEntry> files;  ///< names without the folder
  std::size_t instances = 0;
  std::size_t proved = 0;
  std::size_t proofs = 0;
  std::vector<std::string> warnings;  ///< what was left out, for the user
};

/// The set of a results folder: every instance that was made by a family of the catalogue, once. Points are made anew,
/// and have to be those of the records. Instances from point files are left out, with a warning: they are others' work.
/// Throws InputError as read_records(), and if no instance is left.
[[nodiscard]] BenchmarkSet benchmark_set_of(const std::string& results_folder, const Catalogue& catalogue);

/// The set as tar, compressed by zstd. The same set gives the same bytes.
[[nodiscard]] std::string packed(const BenchmarkSet& set);

/// The files of a packed set, without the folder's name. Throws InputError naming the file: not readable, damaged or
/// hostile (tar.h), files in more than one folder, a file without a checksum, a checksum without a file, or one that
/// does not agree with its checksum.
[[nodiscard]] BenchmarkSet read_benchmark_set(const std::string& path);

/// Writes the files into a folder, which has to be empty or missing. Throws InputError: it cannot be written.
void unpack(const BenchmarkSet& set, const std::string& folder);

/// Whether a path is that of a packed set rather than of a folder: its ending.
[[nodiscard]] bool is_benchmark_set(const std::string& path);

}  // namespace mwt
