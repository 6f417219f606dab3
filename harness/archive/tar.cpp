#include "harness/archive/tar.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>

#include "base/error.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

constexpr std::size_t kTarBlock = 512;

// Where the fields of a header begin, and how long they are.
struct Field {
  std::size_t offset;
  std::size_t size;
};
constexpr Field kName{0, 100}, kMode{100, 8}, kOwner{108, 8}, kGroup{116, 8}, kSize{124, 12}, kTime{136, 12};
constexpr Field kChecksum{148, 8}, kType{156, 1}, kMagic{257, 8}, kPrefix{345, 155};

using Header = std::array<char, kTarBlock>;

void put(Header& header, Field field, std::string_view text) {
  std::copy(text.begin(), text.end(), header.begin() + static_cast<std::ptrdiff_t>(field.offset));
}

// Octal digits, the last byte of the field being NUL.
void put_number(Header& header, Field field, std::size_t value) {
  put(header, field, fmt::format("{:0{}o}", value, field.size - 1));
}

// The sum of all bytes, those of the checksum counted as blanks.
std::size_t checksum_of(std::string_view header) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const bool is_checksum = i >= kChecksum.offset && i < kChecksum.offset + kChecksum.size;
    sum += is_checksum ? ' ' : static_cast<unsigned char>(header[i]);
  }
  return sum;
}

std::string text_at(std::string_view header, Field field) {
  const std::string_view text = header.substr(field.offset, field.size);
  return std::string(text.substr(0, text.find('\0')));
}

std::optional<std::size_t> number_at(std::string_view header, Field field) {
  std::size_t value = 0;
  bool has_digit = false;
  for (const char c : text_at(header, field)) {
    if (c == ' ' && has_digit) break;
    if (c == ' ') continue;
    if (c < '0' || c > '7') return std::nullopt;
    value = 8 * value + static_cast<std::size_t>(c - '0');
    has_digit = true;
  }
  if (!has_digit) return std::nullopt;
  return value;
}

// Why a name cannot be that of a file within a folder; empty if it can.
std::string reason_against(const std::string& name) {
  if (name.empty()) return "has an empty name";
  if (name.front() == '/') return "has an absolute name";
  if (name.find('\\') != std::string::npos || one_line(name) != name) return "has a name that is not plain text";
  for (const std::string& part : split(name, '/')) {
    if (part == "..") return "leads out of the folder";
    if (part.empty() || part == ".") return "has an empty part in its name";
  }
  return "";
}

[[noreturn]] void refuse(const std::string& source, const std::string& why) {
  throw InputError(source + ": " + why + "; nothing of it is used");
}

}  // namespace

std::string tar_of(const std::vector<TarEntry>& files) {
  std::string archive;
  for (const TarEntry& file : files) {
    if (file.name.size() > kName.size || !reason_against(file.name).empty())
      throw std::invalid_argument("a file in an archive cannot be called " + file.name);
    Header header{};
    put(header, kName, file.name);
    put_number(header, kMode, 0644);
    put_number(header, kOwner, 0);
    put_number(header, kGroup, 0);
    put_number(header, kSize, file.content.size());
    put_number(header, kTime, 0);
    put(header, kType, "0");
    put(header, kMagic, std::string_view("ustar\00000", 8));
    const std::size_t sum = checksum_of({header.data(), header.size()});
    put(header, kChecksum, fmt::format("{:06o}", sum) + std::string("\0 ", 2));
    archive.append(header.data(), header.size());
    archive += file.content;
    archive.resize((archive.size() + kTarBlock - 1) / kTarBlock * kTarBlock, '\0');
  }
  archive.resize(archive.size() + 2 * kTarBlock, '\0');
  return archive;
}

std::vector<TarEntry> read_tar(std::string_view archive, const std::string& source) {
  std::vector<TarEntry> files;
  std::set<std::string> names;
  while (true) {
    if (archive.size() < kTarBlock) refuse(source, "the archive is cut off");
    const std::string_view header = archive.substr(0, kTarBlock);
    archive.remove_prefix(kTarBlock);
    if (header.find_first_not_of('\0') == std::string_view::npos) return files;
    if (number_at(header, kChecksum) != checksum_of(header)) refuse(source, "no tar archive, or a damaged one");
    const std::string prefix = text_at(header, kPrefix);
    const std::string name = (prefix.empty() ? "" : prefix + "/") + text_at(header, kName);
    const std::optional<std::size_t> size = number_at(header, kSize);
    const char type = header[kType.offset];
    if (!size) refuse(source, "the size of " + shown(name) + " is damaged");
    if (*size > archive.size()) refuse(source, "the archive is cut off within " + shown(name));
    const std::size_t padded = std::min((*size + kTarBlock - 1) / kTarBlock * kTarBlock, archive.size());
    if (type != '5') {
      if (type != '0' && type != '\0') refuse(source, shown(name) + " is no regular file");
      const std::string why = reason_against(name);
      if (!why.empty()) refuse(source, shown(name) + ' ' + why);
      if (!names.insert(name).second) refuse(source, shown(name) + " is in the archive twice");
      files.push_back({name, std::string(archive.substr(0, *size))});
    }
    archive.remove_prefix(padded);
  }
}

}  // namespace mwt
