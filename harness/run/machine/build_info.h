// What this program was built from; filled in by the build (cmake/build_info.cmake).
#pragma once

#include <string>

namespace mwt {

/// The commit of the sources at the last build, "-dirty" appended if they differed from it; "unknown" without git.
[[nodiscard]] std::string git_commit();

/// "GNU 12.2.0".
[[nodiscard]] std::string compiler();

/// The flags that all sources were compiled with, build type first.
[[nodiscard]] std::string compiler_flags();

/// The folder of the sources.
[[nodiscard]] std::string source_folder();

}  // namespace mwt
