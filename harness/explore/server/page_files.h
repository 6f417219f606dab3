// The page's files, compiled into the program (setup/cmake/page_files.cmake): an installed mwt needs no other file.
#pragma once

#include <span>
#include <string_view>

namespace mwt {

struct PageFile {
  std::string_view name;  ///< "index.html"
  std::string_view content;
};

/// All files of harness/explore/page/, and report.css, the style of the report's page.
[[nodiscard]] std::span<const PageFile> page_files();

}  // namespace mwt
