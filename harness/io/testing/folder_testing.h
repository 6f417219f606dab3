// For the harness's tests: a folder that goes away, and the text of files.
#pragma once

#include <fstream>
#include <string>

#include "base/testing/test_folder.h"

namespace mwt::testing {

using test::TestFolder;

inline void write_text(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

inline std::string read_text(const std::string& path) { return TestFolder::content(path); }

}  // namespace mwt::testing
