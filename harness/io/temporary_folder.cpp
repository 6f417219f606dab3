#include "harness/io/temporary_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "base/error.h"

namespace mwt {

TemporaryFolder::TemporaryFolder(const std::string& prefix) {
  std::error_code error;
  const std::filesystem::path place = std::filesystem::temp_directory_path(error);
  std::string name = (place / (prefix + "-XXXXXX")).string();
  if (error || mkdtemp(name.data()) == nullptr) {
    throw InputError(place.string() + ": cannot make a folder for temporary files here: " +
                     (error ? error.message() : std::strerror(errno)) + "; set TMPDIR to one where you may");
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace mwt
