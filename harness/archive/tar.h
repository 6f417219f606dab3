// Files in one archive: POSIX ustar (IEEE Std 1003.1-1988), which every tar reads.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mwt {

/// A regular file within an archive.
struct TarEntry {
  std::string name;  ///< relative, parts separated by '/'
  std::string content;
};

/// The archive of these files, in their order: same files, same bytes, for owner and times are zero.
/// Throws std::invalid_argument for a name of more than 100 bytes, or one that read_tar() refuses.
[[nodiscard]] std::string tar_of(const std::vector<TarEntry>& files);

/// The regular files of an archive; entries for folders are left out. Throws InputError naming `source`: cut off or
/// damaged (headers have checksums), a link or another special file, or a name that is absolute, empty, leads out of
/// the folder (".."), or comes twice: nothing that could write where it should not.
[[nodiscard]] std::vector<TarEntry> read_tar(std::string_view archive, const std::string& source);

}  // namespace mwt
