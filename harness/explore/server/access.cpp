#include "harness/explore/server/access.h"

#include <fmt/core.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace mwt {

namespace {

// In the same time wherever they differ.
bool equal_secrets(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::system_error(errno, std::generic_category(), "getrandom");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool Access::is_own_host(std::string_view host) const {
  return host == "127.0.0.1:" + port_ || host == "localhost:" + port_;
}

std::optional<std::string> Access::granted(const RequestHead& head) const {
  constexpr std::string_view kScheme = "http://";
  if (!is_own_host(head.host)) return std::nullopt;
  if (head.origin && (!head.origin->starts_with(kScheme) || !is_own_host(head.origin->substr(kScheme.size()))))
    return std::nullopt;
  const std::size_t end = token_.size() + 1;
  if (head.path.size() <= end || head.path.front() != '/' || head.path[end] != '/') return std::nullopt;
  if (!equal_secrets(head.path.substr(1, token_.size()), token_)) return std::nullopt;
  return std::string(head.path.substr(end + 1));
}

}  // namespace mwt
