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
class AccessCheck {
 public:
  /// @param address  that the server listens on
  AccessCheck(std::string token, const std::string& address, std::uint16_t port);

  /// What a request is answered that does not get through: 403, or, for the first visit with the
  /// token in the address, the cookie that keeps it and the page's address without it. Nothing: it
  /// gets through.
  [[nodiscard]] std::optional<HttpResponse> answer(const HttpRequest& request) const;

 private:
  [[nodiscard]] bool isOwnHost(const std::string& host) const;
  [[nodiscard]] bool isFromOwnPage(const HttpRequest& request) const;
  [[nodiscard]] bool hasCookie(const HttpRequest& request) const;

  std::string token_;
  std::string address_;
  std::string cookie_name_;
};

}  // namespace synthetic_dataset::programs
