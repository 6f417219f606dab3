// Writing files so that nothing is lost: the old content stays until the new one is complete and on the disk.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace mwt {

/// A file being written. The content goes to a temporary file beside the target, which commit() brings to the disk
/// (fsync) and renames; without commit(), or after any failure, the temporary file is removed and the target is as
/// before. A symbolic link stays a link: the file that it names is replaced.
///
/// `-` and /dev/stdout are standard output; targets that exist and are no regular files (/dev/null, a fifo) are written
/// directly. A new file has mode 0666 less the umask, a replaced one keeps its mode; a write-protected one is refused.
///
/// Every member throws InputError naming the file, the reason and the remedy: no such folder, no permission, full disk.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Adds to the end; buffered.
  void append(std::string_view text);

  /// Makes the content the target's. Nothing may be appended afterwards.
  void commit();

 private:
  void open_temporary();
  void write_all(std::string_view text);
  void close_file();
  [[noreturn]] void fail(int error) const;

  std::string path_;       // as the user named it
  std::string target_;     // links resolved; empty when written directly
  std::string temporary_;  // empty when written directly, and once renamed
  std::string buffer_;
  int descriptor_ = -1;
};

/// Whether an output of that name goes to standard output.
[[nodiscard]] bool is_standard_output(const std::string& path);

/// Whether two names are of the same regular file, that need not exist yet: links followed, "./a" is "a".
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// Throws InputError if the name promises a format that is written otherwise: an ending (in either case) that is well
/// known and not among `endings`. `content` describes what is written, as in "a picture is written as SVG".
void require_fitting_ending(const std::string& path, std::initializer_list<std::string_view> endings,
                            const std::string& content);

/// Throws InputError as OutputFile would, before any work is done for a file that cannot be written. Changes nothing.
void require_writable(const std::string& path);

/// Whether a file of this name is the temporary one of a writer, or what a killed one left.
[[nodiscard]] bool is_temporary_name(std::string_view file_name);

/// The simple case: all at once.
void write_file_atomically(const std::string& path, std::string_view content);

/// Streaming: whatever `write` appends, committed when it returns; nothing changes if it throws.
void write_file_atomically(const std::string& path, const std::function<void(OutputFile&)>& write);

}  // namespace mwt
