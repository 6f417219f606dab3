#include "harness/explore/read_content.h"

#include <fstream>

#include "base/error.h"
#include "harness/io/points/point_file.h"
#include "harness/io/temporary_folder.h"

namespace mwt {

namespace {

// The last part of a name, whatever separates parts where it comes from. Names that are no file's get a plain one.
std::string file_name_of(const std::string& name) {
  const std::size_t separator = name.find_last_of("/\\");
  std::string last = separator == std::string::npos ? name : name.substr(separator + 1);
  constexpr std::size_t kLongestName = 200;
  const bool is_usable = !last.empty() && last != "." && last != ".." && last.size() <= kLongestName &&
                         last.find('\0') == std::string::npos;
  return is_usable ? last : "points";
}

}  // namespace

std::vector<Point> read_content(const std::string& name, const std::string& content) {
  const TemporaryFolder folder("mwt-explore");
  const std::string file_name = file_name_of(name);
  const std::string path = folder.file(file_name);
  std::ofstream(path, std::ios::binary) << content;
  try {
    return read_points(path);
  } catch (const InputError& error) {
    std::string message = error.what();
    if (message.starts_with(path)) message.replace(0, path.size(), file_name);
    throw InputError(message);
  }
}

}  // namespace mwt
