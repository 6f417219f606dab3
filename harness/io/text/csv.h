// Comma-separated records (RFC 4180, lines end in \n), and a file of them that survives kill -9.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mwt {

using CsvRow = std::vector<std::string>;

/// One line, its end included. Fields with a comma, a quote or a line break are quoted. Precondition: fields not empty.
[[nodiscard]] std::string csv_line(const CsvRow& fields);

/// The rows of `text`, a byte order mark in front left out. A last line without its end is what an interrupted write
/// or an editor leaves: it counts if it has as many fields as the first row, but its last field is empty then, for it
/// may have been cut; otherwise it is torn and left out.
[[nodiscard]] std::vector<CsvRow> parse_csv(std::string_view text);

/// What a user should hear about a last line without its end that counts as a row; empty if there is none.
[[nodiscard]] std::string warning_about_last_line(const std::string& file, std::string_view text);

/// An append-only file. Every row goes out in one write() and is synced, so that whatever kills the process leaves
/// whole rows and at most one torn last line.
///
/// Opening changes nothing that is there, but makes a missing file: only begin() and append() write the header if there
/// is none, and only append() removes a torn last line, or completes one that counts as a row (see parse_csv()).
///
/// Precondition: no field contains a line break (see one_line()). Throws InputError: the file is no regular one, cannot
/// be opened or written (a full disk takes back the incomplete row), or its header is not `header`.
class CsvFile {
 public:
  CsvFile(std::string path, CsvRow header);
  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  /// Writes the header unless it is there.
  void begin();

  void append(const CsvRow& row);

  /// Makes these the rows of the file: at once, whatever happens meanwhile.
  void replace_all(const std::vector<CsvRow>& rows);

  /// The rows that were there when the file was opened, header left out.
  [[nodiscard]] const std::vector<CsvRow>& existing_rows() const { return existing_rows_; }

  /// About what was there, for the user.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void open_for_appending();
  void read_existing();
  void mend_end();
  void write_row(const CsvRow& row);

  std::string path_;
  CsvRow header_;
  int descriptor_ = -1;
  bool has_header_ = false;
  bool ends_well_ = true;       // with a line end
  std::size_t whole_size_ = 0;  // of the lines that have an end
  std::vector<CsvRow> existing_rows_;
  std::vector<std::string> warnings_;
};

/// Throws InputError, naming the difference and the remedy, unless `found` is the header `wanted`.
void require_header(const std::string& file, const std::vector<CsvRow>& rows, const CsvRow& wanted);

}  // namespace mwt
