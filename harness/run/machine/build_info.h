// What this program was built from; the build fills it in (setup/cmake/build_info.cmake).
#pragma once

#include <string>

namespace mwt {

/// "1.0.0": the version in CMakeLists.txt.
[[nodiscard]] std::string version();

/// The commit of the sources at the last build, "-dirty" appended if they differed from it; "unknown" without git.
[[nodiscard]] std::string git_commit();

/// "GNU 12.2.0".
[[nodiscard]] std::string compiler();

/// The flags that all sources were compiled with, build type first.
[[nodiscard]] std::string compiler_flags();

/// The folder of the sources.
[[nodiscard]] std::string source_folder();

}  // namespace mwt
