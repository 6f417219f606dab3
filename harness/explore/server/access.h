// Who may talk to the server: a page that this server has served, or a program that has its address.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mwt {

/// 128 random bits as 32 hexadecimal digits. Throws std::system_error.
[[nodiscard]] std::string random_token();

/// What a request's head says. `origin` is empty if the request has none, as requests of programs and for pages.
struct RequestHead {
  std::string_view host;
  std::optional<std::string_view> origin;
  std::string_view path;
};

class Access {
 public:
  Access(std::string token, int port) : token_(std::move(token)), port_(std::to_string(port)) {}

  /// The path behind the token, "page.js" of "/TOKEN/page.js". Nothing unless the host is this server by number or as
  /// localhost (so that no foreign name that leads here is served), the origin, if any, is this server, too, and the
  /// path begins with the token.
  [[nodiscard]] std::optional<std::string> granted(const RequestHead& head) const;

 private:
  [[nodiscard]] bool is_own_host(std::string_view host) const;

  std::string token_;
  std::string port_;
};

}  // namespace mwt
