#include "harness/io/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "base/error.h"

namespace mwt {

namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;
constexpr std::size_t kMaxStream = std::size_t{1} << 32;  // a pipe may have no end

// An open file descriptor, closed at the end unless it is standard input.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : number_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ > STDIN_FILENO) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail(const std::string& path, int error) {
  const std::string name = source_name(path);
  switch (error) {
    case ENOENT: throw InputError(name + ": no such file; check the name");
    case EISDIR: throw InputError(name + ": is a folder; name a file in it");
    case EACCES: throw InputError(name + ": no permission to read it; change its mode or choose another file");
    default: throw InputError(name + ": cannot be read: " + std::generic_category().message(error));
  }
}

// /dev/zero and its like have no end. A terminal has one, and /dev/null is empty.
void require_no_device(const std::string& path, int descriptor, const struct stat& status) {
  constexpr unsigned kMemoryDevices = 1, kNull = 3;
  const bool is_null = major(status.st_rdev) == kMemoryDevices && minor(status.st_rdev) == kNull;
  const bool has_end = !S_ISBLK(status.st_mode) && (!S_ISCHR(status.st_mode) || is_null || ::isatty(descriptor) == 1);
  if (!has_end) throw InputError(source_name(path) + ": is a device; give a file, or - for standard input");
}

// Room for the file's known size and one more byte, so that the end is noticed without growing.
std::size_t expected_size(const std::string& path, int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) fail(path, errno);
  if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
  require_no_device(path, descriptor, status);
  return S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : kChunk;
}

// A regular file that grows meanwhile counts as a pipe, too.
void make_room(const std::string& path, std::string& content) {
  if (content.size() >= kMaxStream)
    throw InputError(source_name(path) + ": does not end within 4 GB; give a regular file");
  content.resize(content.size() + std::max(content.size(), kChunk));
}

}  // namespace

std::string source_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string read_file(const std::string& path) {
  const Descriptor file(path);
  if (file.number() < 0) fail(path, errno);
  std::string content(expected_size(path, file.number()), '\0');
  std::size_t used = 0;
  while (true) {
    if (used == content.size()) make_room(path, content);
    const ssize_t got = ::read(file.number(), content.data() + used, content.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, errno);
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  content.resize(used);
  return content;
}

}  // namespace mwt
