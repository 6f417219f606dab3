#include "harness/io/text/csv.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"

namespace mwt {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  const bool is_full = errno == ENOSPC || errno == EDQUOT || errno == EFBIG;
  throw InputError(fmt::format("{}: {}: {}{}", path, what, std::strerror(errno),
                               is_full
                                   ? "; free some space and run again with --resume"
                                   : "; mend that and run again with --resume, or choose another folder with --out"));
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text.append(c == '"' ? 2 : 1, c);
  return text + '"';
}

}  // namespace

std::string csv_line(const CsvRow& fields) {
  std::string line;
  for (const std::string& field : fields) line.append(quoted(field)).append(1, ',');
  line.back() = '\n';
  return line;
}

namespace {

// The lines of a text, and the last one if it has no end.
struct Lines {
  std::vector<CsvRow> rows;
  std::size_t whole_size = 0;  // up to and including the last line end
  CsvRow rest;                 // the fields after that
  bool is_quote_open = false;  // in the rest
};

Lines lines_of(std::string_view text) {
  Lines lines;
  CsvRow row(1);
  bool in_quotes = false;
  for (std::size_t i = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool doubled_quote = in_quotes && c == '"' && i + 1 < text.size() && text[i + 1] == '"';
    if (doubled_quote) {
      row.back() += text[++i];
    } else if (c == '"') {
      in_quotes = !in_quotes;
    } else if (c == ',' && !in_quotes) {
      row.emplace_back();
    } else if (c == '\n' && !in_quotes) {
      lines.rows.push_back(std::move(row));
      row.assign(1, "");
      lines.whole_size = i + 1;
    } else if (c != '\r' || in_quotes) {
      row.back() += c;
    }
  }
  lines.rest = std::move(row);
  lines.is_quote_open = in_quotes;
  return lines;
}

// Whether the last line counts as a row although it has no end.
bool rest_is_row(const Lines& lines) {
  return !lines.rows.empty() && !lines.is_quote_open && lines.rest.size() > 1 &&
         lines.rest.size() == lines.rows.front().size();
}

CsvRow without_last_field(CsvRow row) {
  row.back().clear();
  return row;
}

}  // namespace

std::vector<CsvRow> parse_csv(std::string_view text) {
  Lines lines = lines_of(text);
  if (rest_is_row(lines)) lines.rows.push_back(without_last_field(std::move(lines.rest)));
  return std::move(lines.rows);
}

std::string warning_about_last_line(const std::string& file, std::string_view text) {
  if (!rest_is_row(lines_of(text))) return "";
  return file +
         ": its last line has no line end, by an editor or an interrupted write; the row counts, without its last"
         " field, which may be cut; end the line to keep that";
}

namespace {

std::string quoted_part(const std::string& text) {
  std::string result = "'";
  return result.append(text, 0, 40).append("'");
}

}  // namespace

void require_header(const std::string& file, const std::vector<CsvRow>& rows, const CsvRow& wanted) {
  const CsvRow found = rows.empty() ? CsvRow{} : rows.front();
  if (found == wanted) return;
  const bool names_version = rows.size() > 1 && !found.empty() && found.front() == "schema_version";
  const std::string version = names_version ? " (its rows are of schema version " + rows[1].front() + ")" : "";
  const auto [difference, other] = std::mismatch(found.begin(), found.end(), wanted.begin(), wanted.end());
  const std::string what = difference == found.end() ? "missing" : quoted_part(*difference);
  throw InputError(
      fmt::format("{}: its columns are not those of this mwt{}: column {} is {} where '{}' should be; use the mwt that "
                  "wrote it, or run the study anew with another --out",
                  file, version, difference - found.begin() + 1, what, other == wanted.end() ? "nothing" : *other));
}

CsvFile::CsvFile(std::string path, CsvRow header) : path_(std::move(path)), header_(std::move(header)) {
  open_for_appending();
  try {
    read_existing();
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

CsvFile::~CsvFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

// A fifo or a device would wait, or swallow what it gets: O_NONBLOCK, which regular files ignore, opens it at once.
void CsvFile::open_for_appending() {
  descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0644);
  if (descriptor_ < 0) fail(path_, "cannot be written");
  struct stat status {};
  const bool is_regular = fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  if (is_regular) return;
  close(std::exchange(descriptor_, -1));
  throw InputError(path_ + ": records need a regular file; move it away or choose another folder with --out");
}

// A file without a whole line must hold the beginning of the header: anything else is somebody's text.
void CsvFile::read_existing() {
  const std::string content = read_file(path_);
  const Lines lines = lines_of(content);
  has_header_ = !lines.rows.empty();
  if (has_header_) {
    require_header(path_, lines.rows, header_);
  } else if (!csv_line(header_).starts_with(content)) {
    throw InputError(path_ + ": is no file of records; move it away or choose another folder with --out");
  }
  whole_size_ = lines.whole_size;
  ends_well_ = whole_size_ == content.size();
  existing_rows_ = parse_csv(content);
  if (has_header_) existing_rows_.erase(existing_rows_.begin());
  const std::string warning = warning_about_last_line(path_, content);
  if (!warning.empty()) warnings_.push_back(warning);
}

void CsvFile::mend_end() {
  if (!std::exchange(ends_well_, true)) {
    const bool keeps_row = !warnings_.empty();
    if (ftruncate(descriptor_, static_cast<off_t>(whole_size_)) != 0) fail(path_, "cannot be written");
    if (keeps_row) write_row(existing_rows_.back());
  }
  if (!std::exchange(has_header_, true)) write_row(header_);
}

void CsvFile::begin() {
  if (!has_header_) mend_end();
}

void CsvFile::append(const CsvRow& row) {
  mend_end();
  write_row(row);
}

void CsvFile::write_row(const CsvRow& row) {
  struct stat before {};
  if (fstat(descriptor_, &before) != 0) fail(path_, "cannot be written");
  const std::string line = csv_line(row);
  const ssize_t written = write(descriptor_, line.data(), line.size());
  if (written != static_cast<ssize_t>(line.size())) {
    const int reason = written < 0 ? errno : ENOSPC;
    if (ftruncate(descriptor_, before.st_size) != 0) fail(path_, "the incomplete last row cannot be taken back");
    errno = reason;
    fail(path_, "cannot be written");
  }
  if (fdatasync(descriptor_) != 0 && errno != EINVAL) fail(path_, "cannot be synced");
}

void CsvFile::replace_all(const std::vector<CsvRow>& rows) {
  std::string content = csv_line(header_);
  for (const CsvRow& row : rows) content += csv_line(row);
  write_file_atomically(path_, content);
  close(std::exchange(descriptor_, -1));
  open_for_appending();
  has_header_ = ends_well_ = true;
}

}  // namespace mwt
