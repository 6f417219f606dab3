// Comma-separated records (RFC 4180, lines end in \n), and a file of them that survives kill -9.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mwt {

using CsvRow = std::vector<std::string>;

/// One line, its end included. Fields with a comma, a quote or a line break are quoted. Precondition: fields not empty.
[[nodiscard]] std::string csv_line(const CsvRow& fields);

/// The complete rows of `text`: a last line without its end is the torn rest of an interrupted write and is left out.
[[nodiscard]] std::vector<CsvRow> parse_csv(std::string_view text);

/// An append-only file. Every row goes out in one write() and is synced, so that whatever kills the process leaves
/// whole rows and at most one torn last line, which the next CsvFile on the same path removes.
///
/// Precondition: no field contains a line break (see one_line()). Throws InputError: the file cannot be opened or
/// written (a full disk takes back the incomplete row), or its header is not `header`.
class CsvFile {
 public:
  CsvFile(std::string path, const CsvRow& header);
  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  void append(const CsvRow& row);

  /// The rows that were there when the file was opened, header left out.
  [[nodiscard]] const std::vector<CsvRow>& existing_rows() const { return existing_rows_; }

 private:
  void open_content(const CsvRow& header);
  void adopt_existing(const std::string& content, const CsvRow& header);

  std::string path_;
  int descriptor_ = -1;
  std::vector<CsvRow> existing_rows_;
};

}  // namespace mwt
