#include "harness/csv.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "geometry/error.h"
#include "geometry/input_file.h"

namespace mwt {

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw InputError(path + ": " + what + ": " + std::strerror(errno));
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

std::vector<CsvRow> parse_csv(std::string_view text) {
  std::vector<CsvRow> rows;
  CsvRow row(1);
  bool in_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool doubled_quote = in_quotes && c == '"' && i + 1 < text.size() && text[i + 1] == '"';
    if (doubled_quote) {
      row.back() += text[++i];
    } else if (c == '"') {
      in_quotes = !in_quotes;
    } else if (c == ',' && !in_quotes) {
      row.emplace_back();
    } else if (c == '\n' && !in_quotes) {
      rows.push_back(std::move(row));
      row.assign(1, "");
    } else if (c != '\r' || in_quotes) {
      row.back() += c;
    }
  }
  return rows;
}

CsvFile::CsvFile(std::string path, const CsvRow& header) : path_(std::move(path)) {
  descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0) fail(path_, "cannot be written");
  try {
    open_content(header);
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

CsvFile::~CsvFile() { close(descriptor_); }

void CsvFile::open_content(const CsvRow& header) {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) fail(path_, "cannot be read");
  if (!S_ISREG(status.st_mode)) throw InputError(path_ + ": records need a regular file");
  const std::string content = read_file(path_);
  if (content.find('\n') == std::string::npos) {
    if (ftruncate(descriptor_, 0) != 0) fail(path_, "cannot be written");
    append(header);
  } else {
    adopt_existing(content, header);
  }
}

void CsvFile::adopt_existing(const std::string& content, const CsvRow& header) {
  const std::size_t whole_lines = content.rfind('\n') + 1;
  if (whole_lines < content.size() && ftruncate(descriptor_, static_cast<off_t>(whole_lines)) != 0) {
    fail(path_, "cannot be written");
  }
  existing_rows_ = parse_csv(std::string_view(content).substr(0, whole_lines));
  if (existing_rows_.front() != header) {
    throw InputError(path_ + ": its columns are of another schema version; choose a new directory with --out");
  }
  existing_rows_.erase(existing_rows_.begin());
}

void CsvFile::append(const CsvRow& row) {
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

}  // namespace mwt
