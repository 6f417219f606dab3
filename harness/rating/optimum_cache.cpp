#include "harness/rating/optimum_cache.h"

#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/text/text.h"
#include "harness/rating/quality.h"
#include "harness/run/machine/build_info.h"

namespace mwt {

namespace {

constexpr const char* kEnding = ".optimum";
constexpr const char* kProofEnding = ".mwtproof";

constexpr std::size_t kMaxFile = std::size_t{1} << 16;  // bytes; far above any that was stored

// The file: what it is of, what is known, where that comes from, and a hash of all that.
std::string head_of(const OptimumKey& key) {
  return fmt::format("mwt optimum 1\ninstance {}\nsolver {}\nversion {}\nparameters {}\n", key.instance_id, key.solver,
                     key.version, key.parameters);
}

std::string content_of(const OptimumKey& key, const CachedOptimum& optimum) {
  const std::string body =
      fmt::format("{}lower {}\nupper {}\nsolve_time_s {}\nrecorded_at {}\ngit_commit {}\n", head_of(key),
                  number_text(optimum.interval.lower), number_text(optimum.interval.upper),
                  number_text(optimum.solve_time_s), utc_now(), git_commit());
  return body + "hash " + short_hash(body) + '\n';
}

// Takes "name number\n" off the front of `text`.
std::optional<double> take_number(std::string_view& text, std::string_view name) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos || !text.starts_with(name)) return std::nullopt;
  const std::optional<double> number = parse_number(text.substr(name.size(), end - name.size()));
  text.remove_prefix(end + 1);
  return number;
}

bool is_proved(const Interval& interval) {
  return std::isfinite(interval.upper) && interval.lower <= interval.upper &&
         optimality_of(interval) == Optimality::proved;
}

// The part of a file that its hash confirms; nothing if it does not.
std::optional<std::string_view> confirmed_body(std::string_view content) {
  const std::size_t hash_at = content.rfind("hash ");
  if (hash_at == std::string_view::npos) return std::nullopt;
  const std::string_view body = content.substr(0, hash_at);
  if (content.substr(hash_at) != "hash " + short_hash(body) + '\n') return std::nullopt;
  return body;
}

// Nothing unless `content` is exactly what content_of() makes of this key and a proved optimum.
std::optional<CachedOptimum> parse(const OptimumKey& key, std::string_view content) {
  const std::optional<std::string_view> body = confirmed_body(content);
  const std::string head = head_of(key);
  if (!body || !body->starts_with(head)) return std::nullopt;
  std::string_view rest = body->substr(head.size());
  const auto lower = take_number(rest, "lower ");
  const auto upper = take_number(rest, "upper ");
  const auto time = take_number(rest, "solve_time_s ");
  if (!lower || !upper || !time || !is_proved({*lower, *upper})) return std::nullopt;
  return CachedOptimum{{*lower, *upper}, *time};
}

// The lower bound in a file of any key.
std::optional<double> lower_bound_in(std::string_view content) {
  const std::optional<std::string_view> body = confirmed_body(content);
  const std::size_t at = body ? body->find("\nlower ") : std::string_view::npos;
  if (at == std::string_view::npos) return std::nullopt;
  std::string_view rest = body->substr(at + 1);
  return take_number(rest, "lower ");
}

// Nothing if there is no such file. Anything but a small regular file is read as no content.
std::optional<std::string> read_small_file(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return std::nullopt;
  if (!std::filesystem::is_regular_file(status)) return std::string();
  std::string content(kMaxFile, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(file.gcount()));
  return content;
}

// What is in the folder, as far as it can be read.
std::vector<std::filesystem::path> files_in(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    files.push_back(entry->path());
  }
  return files;
}

// Removes what killed writers left (geometry/output_file.h). An hour is longer than any write takes, so that no living
// writer loses its file.
void sweep_stale_files(const std::string& folder) {
  namespace fs = std::filesystem;
  const auto too_old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const fs::path& file : files_in(folder)) {
    if (!is_temporary_name(file.filename().string())) continue;
    std::error_code error;
    const bool is_old = fs::last_write_time(file, error) < too_old;
    if (is_old && !error) fs::remove(file, error);
  }
}

// An entry is written in the place of whatever is there but a folder with something in it; never through a link, into a
// fifo or to a device.
void clear_the_place(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(path, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) fs::remove(path, ignored);
}

// Of an entry: its path with the other ending.
std::string proof_beside(const std::string& entry) {
  return std::filesystem::path(entry).replace_extension(kProofEnding).string();
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::string optimum_cache_folder() {
  if (const std::string own = variable("MWT_CACHE_DIR"); !own.empty()) return own;
  if (const std::string caches = variable("XDG_CACHE_HOME"); caches.starts_with('/')) return caches + "/mwt/optima";
  if (const std::string home = variable("HOME"); !home.empty()) return home + "/.cache/mwt/optima";
  return "";
}

OptimumCache::OptimumCache(std::string folder, std::function<void(const std::string&)> warn)
    : folder_(std::move(folder)), warn_(std::move(warn)), can_store_(!folder_.empty()) {
  if (folder_.empty()) warn_("optima are not cached: neither MWT_CACHE_DIR nor HOME names a folder for them");
}

std::string OptimumCache::path_of(const OptimumKey& key) const {
  return fmt::format("{}/{}-{}-{}{}", folder_, key.instance_id, key.solver, short_hash(head_of(key)), kEnding);
}

std::string OptimumCache::proof_path_of(const OptimumKey& key) const { return proof_beside(path_of(key)); }

std::optional<CachedOptimum> OptimumCache::find(const OptimumKey& key) {
  if (folder_.empty()) return std::nullopt;
  const std::string path = path_of(key);
  const std::optional<std::string> content = distrusted_.contains(path) ? std::nullopt : read_small_file(path);
  if (!content) return std::nullopt;
  const std::optional<CachedOptimum> optimum = parse(key, *content);
  if (!optimum && !std::exchange(warned_of_content_, true)) warn_(path + ": no cached optimum; ignored");
  return optimum;
}

std::vector<std::string> OptimumCache::discard_disproved(const std::string& instance_id, double weight) {
  std::vector<std::string> disproved;
  for (const std::filesystem::path& file : files_in(folder_)) {
    if (!file.filename().string().starts_with(instance_id + '-')) continue;
    const std::optional<std::string> content = read_small_file(file.string());
    const std::optional<double> lower = content ? lower_bound_in(*content) : std::nullopt;
    if (!lower || *lower <= weight) continue;
    disproved.push_back(file.string());
    std::error_code error;
    std::filesystem::remove(proof_beside(file.string()), error);
    if (std::filesystem::remove(file, error)) continue;
    distrusted_.insert(file.string());
    warn_(file.string() + ": a triangulation disproves it, but it cannot be removed: " + error.message());
  }
  return disproved;
}

void OptimumCache::store(const OptimumKey& key, const CachedOptimum& optimum) {
  if (is_proved(optimum.interval)) put(path_of(key), content_of(key, optimum));
}

bool OptimumCache::fetch_proof(const OptimumKey& key, const std::string& file) {
  const std::string path = proof_path_of(key);
  std::error_code error;
  if (!find(key) || !std::filesystem::is_regular_file(path, error)) return false;
  try {
    write_file_atomically(file, read_file(path));
    return true;
  } catch (const InputError&) {
    return false;  // then it is made anew, and whatever is wrong with the file is seen
  }
}

void OptimumCache::store_proof(const OptimumKey& key, const std::string& file) {
  if (!can_store_ || !find(key)) return;
  try {
    put(proof_path_of(key), read_file(file));
  } catch (const InputError& error) {
    warn_(std::string("a proof is not cached: ") + error.what());
  }
}

void OptimumCache::discard_proof(const OptimumKey& key) {
  std::error_code ignored;
  std::filesystem::remove(proof_path_of(key), ignored);
}

void OptimumCache::put(const std::string& path, const std::string& content) {
  if (!can_store_) return;
  std::error_code reported_by_writing;
  std::filesystem::create_directories(folder_, reported_by_writing);
  if (!std::exchange(is_swept_, true)) sweep_stale_files(folder_);
  clear_the_place(path);
  try {
    write_file_atomically(path, content);
    distrusted_.erase(path);
  } catch (const InputError& error) {
    std::error_code ignored;
    const bool concerns_one_entry = std::filesystem::is_directory(path, ignored);
    const bool is_known = concerns_one_entry && std::exchange(warned_of_content_, true);
    can_store_ = concerns_one_entry;
    if (!is_known) warn_(std::string("optima are not cached: ") + error.what());
  }
}

}  // namespace mwt
