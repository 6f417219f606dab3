#include "harness/archive/benchmark_set.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/compression.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/text/csv.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_lines.h"
#include "harness/rating/quality.h"
#include "harness/records/known_optima.h"
#include "harness/records/proof_folder.h"
#include "harness/run/machine/build_info.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSums = "SHA256SUMS";

std::string generating_command(const InstanceRecord& record) {
  std::string command = fmt::format("mwt generate {} --n {} --seed {}", record.generator, record.n, record.seed);
  for (const auto& [name, value] : parse_canonical(record.generator_params))
    command += " --param " + canonical_parameter(name, value);
  return command;
}

std::string points_text(const InstanceRecord& record, const std::vector<Point>& points) {
  std::string text = "# " + label_of_instance(record) + "\n# " + generating_command(record) + '\n';
  for (const Point& point : points) {
    append_number(text, point.x);
    text += ' ';
    append_number(text, point.y);
    text += '\n';
  }
  return text;
}

std::string points_name(const InstanceRecord& record) {
  return fmt::format("points/{}-{}-{}.txt", record.generator, record.n, record.instance_id.substr(0, 12));
}

CsvRow instances_header() {
  return {"file",      "instance_id",   "family",        "params",     "n",     "seed",     "distinct", "duplicates",
          "hull_size", "optimum_lower", "optimum_upper", "optimality", "proof", "verified", "command"};
}

CsvRow instances_row(const InstanceRecord& record, const std::optional<Interval>& optimum, bool has_proof) {
  return {points_name(record),
          record.instance_id,
          record.generator,
          record.generator_params,
          std::to_string(record.n),
          std::to_string(record.seed),
          std::to_string(record.distinct),
          std::to_string(record.duplicates),
          std::to_string(record.hull_size),
          optimum ? number_text(optimum->lower) : "",
          optimum ? number_text(optimum->upper) : "",
          std::string(name_of(optimality_of(optimum))),
          has_proof ? "proofs/" + record.instance_id + ".mwtproof" : "",
          has_proof && record.verified ? to_text(*record.verified) : "",
          generating_command(record)};
}

// A study of the set's points by the algorithms that ran on them, as far as the program has these itself.
std::string study_text(const std::string& name, const StudyRecords& records, const Catalogue& catalogue) {
  std::set<std::string> algorithms;
  double time_limit_s = 1;
  for (const RunRecord& run : records.runs) {
    const auto is_it = [&](const AlgorithmInfo& info) { return info.name == run.algorithm; };
    if (std::ranges::any_of(catalogue.algorithms(), is_it)) algorithms.insert('"' + run.algorithm + '"');
    time_limit_s = std::max(time_limit_s, run.time_limit_s);
  }
  return fmt::format(
      "# mwt run --instances SET runs this; another study file in front of --instances runs its own algorithms "
      "instead.\n"
      "name = \"{}-set\"\nsummary = \"The points of the benchmark set {}\"\nalgorithms = [{}]\n\n"
      "[instances]\nfolder = \".\"\nfiles = [\"points/*.txt\"]\n\n[limits]\ntime_s = {}\n",
      name, name, joined({algorithms.begin(), algorithms.end()}), number_text(time_limit_s));
}

std::string readme_text(const BenchmarkSet& set, const std::string& commit) {
  return fmt::format(
      "# Benchmark set `{0}`: points for minimum weight triangulation\n\n"
      "{1} sets of points. The weight of a minimum weight triangulation is proved for {2} of them; for {3} there is a "
      "proof that `mwt_verify` checks\n"
      "without any code of the solvers.\n\n"
      "- `instances.csv`: a row per set of points: its file, the family that made it and the command that makes it "
      "again, the certified interval\n"
      "  `optimum_lower` to `optimum_upper` of the smallest weight (the sum of the lengths of all edges), `optimality` "
      "(`proved`: the relative width is at\n"
      "  most 1e-12; `bounded`: further apart; `none`), the proof, and the verifier's verdict.\n"
      "- `points/`: `x y` per line; every number is the shortest decimal number that reads back as the same IEEE 754 "
      "double.\n"
      "- `proofs/`: checked by `mwt_verify POINTS PROOF`.\n"
      "- `SHA256SUMS`: checked by `sha256sum -c SHA256SUMS`.\n"
      "- `study.toml`: `mwt run --instances {0}.tar.zst` runs the algorithms that it names on these points.\n\n"
      "Made by the laboratory for minimum weight triangulation, version {4}, from records of commit {5}.\n\n"
      "## Licence\n\nGPL-3.0-or-later, as the laboratory that made it.\n\n"
      "## Citation\n\n"
      "A laboratory for minimum weight triangulation, version {4}, benchmark set `{0}` (CITATION.cff of the laboratory "
      "has the details). State the SHA-256\n"
      "of the archive along with it.\n",
      set.name, set.instances, set.proved, set.proofs, version(), commit);
}

// "hash  name" per line, as sha256sum writes and checks it.
std::string sums_text(const std::vector<TarEntry>& files) {
  std::string text;
  for (const TarEntry& file : files) text += sha256_of(file.content) + "  " + file.name + '\n';
  return text;
}

std::optional<std::string> proof_of(const std::string& folder, const InstanceRecord& record) {
  const std::string path = proof_file(folder, record.instance_id);
  std::error_code error;
  if (record.verified != ProofVerdict::optimal || !fs::is_regular_file(path, error)) return std::nullopt;
  return read_file(path);
}

// Adds what the set has of one instance. False: the points are not those of the records.
bool add_instance(BenchmarkSet& set, std::string& table, const InstanceRecord& record, const std::string& folder,
                  const KnownOptima& known, const Catalogue& catalogue) {
  const GeneratorInfo& family = catalogue.generator(record.generator);
  const Parameters parameters(family.name, family.parameters, parse_canonical(record.generator_params));
  const std::vector<Point> points = generate_points(family, record.n, record.seed, parameters);
  if (make_instance(points, record.generator).id != record.instance_id) return false;
  const std::optional<Interval> optimum = known.of(record.instance_id);
  std::optional<std::string> proof = proof_of(folder, record);
  set.files.push_back({points_name(record), points_text(record, points)});
  table += csv_line(instances_row(record, optimum, proof.has_value()));
  ++set.instances;
  set.proved += optimality_of(optimum) == Optimality::proved;
  set.proofs += proof.has_value();
  if (proof) set.files.push_back({"proofs/" + record.instance_id + ".mwtproof", std::move(*proof)});
  return true;
}

// The set's own name: letters, digits, and what else is safe in names of files.
std::string safe_name(const std::string& study) {
  std::string name;
  for (const char c : study) {
    const bool is_safe =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    name += is_safe ? c : '-';
  }
  return name.substr(0, 40);
}

void verify_sums(const BenchmarkSet& set, const std::string& path) {
  std::map<std::string, std::string> sums;
  const auto is_sums = [](const TarEntry& file) { return file.name == kSums; };
  const auto list = std::ranges::find_if(set.files, is_sums);
  if (list == set.files.end()) throw InputError(path + ": no benchmark set: it has no " + kSums);
  for (const std::string& line : split(list->content, '\n')) {
    if (line.empty()) continue;
    if (line.size() < 67) throw InputError(path + ": " + kSums + " has a malformed line " + shown(line));
    sums[line.substr(66)] = line.substr(0, 64);
  }
  for (const TarEntry& file : set.files) {
    if (file.name == kSums) continue;
    const auto sum = sums.find(file.name);
    if (sum == sums.end()) throw InputError(path + ": " + shown(file.name) + " has no checksum; nothing of it is used");
    if (sum->second != sha256_of(file.content))
      throw InputError(path + ": " + shown(file.name) + " does not agree with its checksum; nothing of it is used");
    sums.erase(sum);
  }
  if (!sums.empty()) throw InputError(path + ": " + shown(sums.begin()->first) + " is missing; nothing of it is used");
}

}  // namespace

BenchmarkSet benchmark_set_of(const std::string& results_folder, const Catalogue& catalogue) {
  const StudyRecords records = read_records(results_folder);
  KnownOptima known;
  for (const InstanceRecord& record : records.instances) (void)known.add(record);
  for (const RunRecord& run : records.runs) (void)known.add(run);
  BenchmarkSet set;
  if (!records.instances.empty()) set.name = safe_name(records.instances.front().study);
  std::string table = csv_line(instances_header());
  std::set<std::string> seen;
  std::size_t others = 0;
  for (const InstanceRecord& record : records.instances) {
    if (record.instance_id.empty() || !seen.insert(record.instance_id).second) continue;
    const auto is_family = [&](const GeneratorInfo& info) { return info.name == record.generator; };
    if (std::ranges::none_of(catalogue.generators(), is_family)) {
      ++others;
    } else if (!add_instance(set, table, record, results_folder, known, catalogue)) {
      set.warnings.push_back(label_of_instance(record) + ": this program makes other points; left out");
    }
  }
  if (others > 0)
    set.warnings.push_back(counted(others, "instance") + " from point files left out: they are others' work");
  if (set.instances == 0) throw InputError(results_folder + ": no instance that a family of this program makes");
  set.files.insert(
      set.files.begin(),
      {{"README.md",
        readme_text(set, records.environments.empty() ? "unknown" : records.environments.front().git_commit)},
       {"study.toml", study_text(set.name, records, catalogue)},
       {"instances.csv", table}});
  set.files.push_back({kSums, sums_text(set.files)});
  return set;
}

std::string packed(const BenchmarkSet& set) {
  std::vector<TarEntry> files = set.files;
  for (TarEntry& file : files) file.name.insert(0, set.name + '/');
  return compressed_by_zstd(tar_of(files));
}

BenchmarkSet read_benchmark_set(const std::string& path) {
  BenchmarkSet set;
  set.files = read_tar(decompressed(read_file(path), path), path);
  if (set.files.empty()) throw InputError(path + ": the archive is empty");
  set.name = set.files.front().name.substr(0, set.files.front().name.find('/'));
  for (TarEntry& file : set.files) {
    if (!file.name.starts_with(set.name + '/')) throw InputError(path + ": no benchmark set: files in several folders");
    file.name.erase(0, set.name.size() + 1);
    set.instances += file.name.starts_with("points/");
    set.proofs += file.name.starts_with("proofs/");
  }
  verify_sums(set, path);
  return set;
}

void unpack(const BenchmarkSet& set, const std::string& folder) {
  for (const TarEntry& file : set.files) {
    const fs::path path = fs::path(folder) / file.name;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) throw InputError(path.parent_path().string() + ": cannot be made: " + error.message());
    write_file_atomically(path.string(), file.content);
  }
}

bool is_benchmark_set(const std::string& path) {
  return path.ends_with(".tar.zst") || path.ends_with(".tar.gz") || path.ends_with(".tar.xz") || path.ends_with(".tar");
}

}  // namespace mwt
