#include "harness/io/text/word_rows.h"

#include <fmt/core.h>

#include <cmath>

#include "base/number_text.h"
#include "geometry/point.h"
#include "harness/io/text/text.h"

namespace mwt {

bool WordRows::next() {
  while (lines_.next()) {
    split_columns(lines_.line().substr(0, lines_.line().find('#')), ' ', words_);
    if (!words_.empty()) return true;
  }
  return false;
}

void WordRows::require_next(const std::string& what) {
  if (!next()) lines_.fail_as_a_whole("ends before " + what);
}

std::string_view WordRows::word(std::size_t place) const {
  if (place < words_.size()) return words_[place];
  lines_.fail(fmt::format("{} where there should be at least {}", counted(words_.size(), "number"), place + 1));
}

double WordRows::number(std::size_t place) const {
  const std::optional<double> value = parse_number(word(place));
  if (!value) lines_.fail(shown(word(place)) + " is not a number");
  if (!std::isfinite(*value)) lines_.fail(shown(word(place)) + " is not a finite double; scale the data down");
  return *value;
}

std::size_t WordRows::count(std::size_t place) const {
  const auto value = parse_whole_number<std::size_t>(word(place));
  if (!value || *value >= kNoIndex) lines_.fail(shown(word(place)) + " is not a whole number from 0");
  return *value;
}

}  // namespace mwt
