// Tables for people: columns aligned with blanks.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mwt {

/// Collects rows and prints them with every column as wide as its widest cell. The first column and those named in
/// `left_aligned` (by position) are aligned to the left, all others to the right.
class AlignedTable {
 public:
  explicit AlignedTable(std::vector<std::string> header, const std::vector<std::size_t>& left_aligned = {});

  /// Precondition: as many cells as the header has.
  void add_row(std::vector<std::string> cells);

  [[nodiscard]] bool is_empty() const { return rows_.size() == 1; }

  /// Every line indented by `indent` and ended by a line break; no blanks at the ends of lines.
  [[nodiscard]] std::string text(const std::string& indent = "") const;

  /// The same in lines of at most `width` characters: texts of columns aligned to the left go on in the lines below,
  /// broken at blanks and hyphens, within words only where nothing else helps. Wider than that where numbers and single
  /// characters need it. Without a width the same as text().
  [[nodiscard]] std::string text_within(std::optional<std::size_t> width) const;

 private:
  [[nodiscard]] std::vector<std::size_t> natural_widths() const;
  [[nodiscard]] std::vector<std::size_t> widths_within(std::size_t width) const;
  void append_row(std::string& text, const std::vector<std::string>& cells,
                  const std::vector<std::size_t>& widths) const;

  std::vector<std::vector<std::string>> rows_;  // the header first
  std::vector<bool> is_left_aligned_;
};

}  // namespace mwt
