#include "harness/io/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

#include "base/number_text.h"

namespace mwt {

namespace {

constexpr std::size_t kNarrowest = 20;
constexpr std::size_t kUsual = 80;

std::size_t width_of_terminal() {
  winsize size{};
  const bool is_told = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= kNarrowest;
  return is_told ? size.ws_col : kUsual;
}

}  // namespace

std::optional<std::size_t> output_width() {
  if (const char* columns = std::getenv("COLUMNS")) {
    const auto width = parse_whole_number<std::size_t>(columns);
    if (width && *width >= kNarrowest) return width;
  }
  if (::isatty(STDOUT_FILENO) != 1) return std::nullopt;
  return width_of_terminal();
}

}  // namespace mwt
