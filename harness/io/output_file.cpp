#include "harness/io/output_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 20;
constexpr std::string_view kTemporaryBegin = ".mwt-";
constexpr std::string_view kTemporaryEnd = ".tmp";

// Endings that promise a certain format.
constexpr std::array<std::string_view, 16> kKnownEndings = {".csv", ".tsv",  ".json", ".tsp",  ".svg", ".png",
                                                            ".jpg", ".jpeg", ".gif",  ".webp", ".pdf", ".eps",
                                                            ".gz",  ".zip",  ".xlsx", ".html"};

// The file to be replaced: links followed, so that the link itself survives.
std::string resolved(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::path target = std::filesystem::canonical(path, ignored);
  return target.empty() ? path : target.string();
}

// A name in the same folder (a rename cannot cross file systems), unlike any other run's or thread's.
std::string temporary_name(const std::string& target) {
  static std::atomic<unsigned> counter{0};
  std::string name(kTemporaryBegin);
  name += fmt::format("{}-{}", ::getpid(), counter++);
  name += kTemporaryEnd;
  return std::filesystem::path(target).replace_filename(name).string();
}

// Makes the rename itself survive a power failure. Some file systems cannot; the data is safe either way.
void sync_folder_of(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (path_.empty()) throw InputError("the output file has an empty name; give it one, or - for standard output");
  if (is_standard_output(path_)) {
    std::cout.flush();
    std::fflush(stdout);
    descriptor_ = STDOUT_FILENO;
    return;
  }
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && ::faccessat(AT_FDCWD, path_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  target_ = resolved(path_);
  open_temporary();
  // A file system without modes may refuse this; the content matters more.
  if (exists) static_cast<void>(::fchmod(descriptor_, status.st_mode & 0777));
}

OutputFile::~OutputFile() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::open_temporary() {
  do {
    const std::string name = temporary_name(target_);
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) temporary_ = name;
  } while (descriptor_ < 0 && errno == EEXIST);  // left by a killed process of the same number
  if (descriptor_ < 0) fail(errno);
}

void OutputFile::append(std::string_view text) {
  if (buffer_.size() + text.size() < kBufferSize) {
    buffer_ += text;
    return;
  }
  write_all(buffer_);
  buffer_.clear();
  write_all(text);
}

void OutputFile::write_all(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::close_file() {
  if (descriptor_ <= STDERR_FILENO) return;
  const int closed = ::close(std::exchange(descriptor_, -1));
  if (closed != 0) fail(errno);
}

void OutputFile::commit() {
  write_all(buffer_);
  buffer_.clear();
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail(errno);
  close_file();
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  sync_folder_of(target_);
}

void OutputFile::fail(int error) const {
  const std::string place = path_ == "-" ? "standard output" : path_;
  switch (error) {
    case ENOENT: throw InputError(place + ": cannot be written: its folder does not exist; create that first");
    case ENOTDIR: throw InputError(place + ": cannot be written: its folder is a file; choose another place");
    case EISDIR: throw InputError(place + ": cannot be written: it is a folder; name a file in it");
    case EACCES:
    case EPERM:
    case EROFS: throw InputError(place + ": cannot be written: no permission; choose another place");
    case ENOSPC:
    case EDQUOT: throw InputError(place + ": cannot be written: the disk is full; free some space and run again");
    default: throw InputError(place + ": cannot be written: " + std::generic_category().message(error));
  }
}

bool is_standard_output(const std::string& path) { return path == "-" || path == "/dev/stdout"; }

bool is_same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(a, error);
  if (fs::exists(status)) return fs::is_regular_file(status) && fs::equivalent(a, b, error);
  return fs::weakly_canonical(fs::absolute(a, error), error) == fs::weakly_canonical(fs::absolute(b, error), error);
}

void require_fitting_ending(const std::string& path, std::initializer_list<std::string_view> endings,
                            const std::string& content) {
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  const bool is_known = std::find(kKnownEndings.begin(), kKnownEndings.end(), ending) != kKnownEndings.end();
  if (!is_known || std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
  throw InputError(fmt::format("{}: {}; give it a name that ends in {}", path, content, *endings.begin()));
}

void require_writable(const std::string& path) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  // To open and close a pipe would look like the end of its data.
  if (is_standard_output(path) || (exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode))) return;
  const OutputFile probe(path);
}

bool is_temporary_name(std::string_view file_name) {
  return file_name.starts_with(kTemporaryBegin) && file_name.ends_with(kTemporaryEnd);
}

void write_file_atomically(const std::string& path, std::string_view content) {
  write_file_atomically(path, [&](OutputFile& file) { file.append(content); });
}

void write_file_atomically(const std::string& path, const std::function<void(OutputFile&)>& write) {
  OutputFile file(path);
  write(file);
  file.commit();
}

}  // namespace mwt
