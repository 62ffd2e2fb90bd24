#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

/// 128 random bits from the system, in hexadecimal digits.
[[nodiscard]] std::string makeToken();

/// The host name of this machine.
[[nodiscard]] std::string machineName();

/// Decides who may make requests: whoever knows the token, from a page of this server.
///
/// Browsers send a cookie to every port of a machine (RFC 6265, section 8.5), thus to the servers
/// of other users, too. Therefore the page lies in a folder whose name is another secret, and the
/// cookie is valid for that folder only: no other server can make the browser request the folder.
class AccessCheck {
 public:
  /// @param token  opens the page, and admits a program's requests
  /// @param address  that the server listens on
  AccessCheck(std::string token, const std::string& address, std::uint16_t port);

  /// The answer to a request that is not admitted: 403, or, for the first visit with the token in
  /// the address, a redirection to the page's address without the token, with the cookie. Returns
  /// nothing if the request is admitted. Does not need the request's body.
  [[nodiscard]] std::optional<HttpResponse> answer(const HttpRequest& request) const;

  /// An admitted request, with its path relative to the page's folder.
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
