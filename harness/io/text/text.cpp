#include "harness/io/text/text.h"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <cmath>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "base/unicode.h"

namespace mwt {

namespace {

using DigestContext = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;

DigestContext begin_sha256() {
  DigestContext context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 is not available");
  }
  return context;
}

std::string finish(const DigestContext& context) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (EVP_DigestFinal_ex(context.get(), digest, &size) != 1) throw std::runtime_error("SHA-256 failed");
  std::string text;
  for (unsigned int i = 0; i < size; ++i) fmt::format_to(std::back_inserter(text), "{:02x}", digest[i]);
  return text;
}

}  // namespace

std::string fixed(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }

namespace {

// 200 parts of which 60 make a whole: "3:20".
std::string in_sixtieths(long long parts) { return fmt::format("{}:{:02}", parts / 60, parts % 60); }

}  // namespace

std::string readable_duration(double seconds) {
  constexpr double kMinute = 60;
  constexpr double kHour = 60 * kMinute;
  constexpr double kDay = 24 * kHour;
  if (seconds >= 5 * kDay) return fixed(seconds / kDay, 0) + " days";
  if (seconds >= 100 * kMinute) return in_sixtieths(std::llround(seconds / kMinute)) + " h";
  if (seconds >= 100) return in_sixtieths(std::llround(seconds)) + " min";
  const auto three_digits = [](double value) { return fixed(value, value < 10 ? 2 : value < 100 ? 1 : 0); };
  if (seconds >= 1) return three_digits(seconds) + " s";
  if (seconds >= 1e-3) return three_digits(seconds * 1e3) + " ms";
  return three_digits(seconds * 1e6) + " us";
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char buffer[32];
  return {buffer, std::strftime(buffer, sizeof buffer, "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

std::string one_line(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::optional<Character> character = first_character(text.substr(i));
    const std::size_t size = character ? character->size : 1;
    const bool is_control = static_cast<unsigned char>(text[i]) < 0x20 || text[i] == 0x7f;
    if (is_control) {
      result += ' ';
    } else if (!character) {
      result += '?';
    } else {
      result.append(text, i, size);
    }
    i += size;
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text.append(i == 0 ? "" : separator).append(words[i]);
  return text;
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string name_with_parameters(const std::string& name, const std::string& parameters) {
  return parameters.empty() ? name : name + ' ' + parameters;
}

std::string short_hash(std::string_view text) { return sha256_of(text).substr(0, 16); }

std::string sha256_of(std::string_view content) {
  const DigestContext context = begin_sha256();
  EVP_DigestUpdate(context.get(), content.data(), content.size());
  return finish(context);
}

std::string sha256_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return "";
  const DigestContext context = begin_sha256();
  std::vector<char> block(1 << 16);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    EVP_DigestUpdate(context.get(), block.data(), static_cast<std::size_t>(file.gcount()));
  }
  return finish(context);
}

}  // namespace mwt
