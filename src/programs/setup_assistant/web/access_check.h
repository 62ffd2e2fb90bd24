#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

/// 128 bits of the system's randomness, in hexadecimal digits.
[[nodiscard]] std::string makeToken();

/// What other machines call this one.
[[nodiscard]] std::string machineName();

/// Who may ask: whoever knows the token, from a page of this server.
///
/// Browsers send a cookie to every port of a machine (RFC 6265, section 8.5), thus to the servers
/// of other users, too. Therefore the page lies in a folder whose name is a secret of its own, and
/// the cookie is for that folder alone: no other server can have the browser ask for it.
class AccessCheck {
 public:
  /// @param token  opens the page, and answers a program's requests
  /// @param address  that the server listens on
  AccessCheck(std::string token, const std::string& address, std::uint16_t port);

  /// What a request is answered that does not get through: 403, or, for the first visit with the
  /// token in the address, the cookie and the page's address without the token. Nothing: it gets
  /// through. Needs no body.
  [[nodiscard]] std::optional<HttpResponse> answer(const HttpRequest& request) const;

  /// A request that got through, with its path inside the page's folder.
  [[nodiscard]] HttpRequest inside(HttpRequest request) const;

 private:
  [[nodiscard]] bool isOwnHost(const std::string& host) const;
  [[nodiscard]] bool isFromOwnPage(const HttpRequest& request) const;
  [[nodiscard]] bool hasCookie(const HttpRequest& request) const;

  std::string token_;
  std::string cookie_ = makeToken();
  std::string folder_ = "/" + makeToken();
  std::string address_;
  std::string cookie_name_;
};

}  // namespace synthetic_dataset::programs
