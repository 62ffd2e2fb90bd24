#include "programs/setup_assistant/web/access_check.h"

#include <arpa/inet.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <utility>

namespace synthetic_dataset::programs {
namespace {

/// Compares in a time that does not depend on where the texts differ.
bool areEqual(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference |=
        static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  }
  return difference == 0;
}

/// A Host header's name without its port.
std::string hostName(const std::string& host) {
  if (!host.empty() && host.front() == '[') return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

bool isAddress(const std::string& name) {
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  if (::inet_pton(AF_INET, name.c_str(), bytes.data()) == 1) return true;
  return name.size() > 2 && name.front() == '[' &&
         ::inet_pton(AF_INET6, name.substr(1, name.size() - 2).c_str(), bytes.data()) == 1;
}

HttpResponse forbidden() {
  HttpResponse response;
  response.status = 403;
  response.type = "text/plain";
  return response;
}

}  // namespace

std::string machineName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string makeToken() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw Error("the system gives no random numbers for the token");
  }
  std::string token;
  for (const unsigned char byte : bytes) {
    std::array<char, 3> digits{};
    std::snprintf(digits.data(), digits.size(), "%02x", static_cast<unsigned>(byte));
    token += digits.data();
  }
  return token;
}

AccessCheck::AccessCheck(std::string token, const std::string& address, std::uint16_t port)
    : token_(std::move(token)),
      address_(address.find(':') == std::string::npos ? address : "[" + address + "]"),
      cookie_name_("synthetic_dataset_" + std::to_string(port)) {}

std::optional<HttpResponse> AccessCheck::answer(const HttpRequest& request) const {
  const std::string host = request.header("host");
  const std::string origin = request.header("origin");
  // Another server's page on this machine has another origin, as its port differs.
  if (!isOwnHost(host) || (!origin.empty() && origin != "http://" + host)) return forbidden();
  const auto given = request.parameter("token");
  if (given && areEqual(*given, token_)) {
    if (request.path != "/") return std::nullopt;
    HttpResponse response;
    response.status = 303;
    response.headers = {{"Location", folder_ + "/"},
                        {"Set-Cookie", cookie_name_ + "=" + cookie_ + "; Path=" + folder_ +
                                           "/; HttpOnly; SameSite=Strict"}};
    return response;
  }
  const std::string folder = request.path.substr(0, folder_.size() + 1);
  if (!isFromOwnPage(request) || !areEqual(folder, folder_ + "/") || !hasCookie(request)) {
    return forbidden();
  }
  return std::nullopt;
}

HttpRequest AccessCheck::inside(HttpRequest request) const {
  if (request.path.rfind(folder_ + "/", 0) == 0) request.path.erase(0, folder_.size());
  return request;
}

/// Other names could lead here through somebody else's DNS. Any port is accepted, since ssh may
/// have forwarded another one.
bool AccessCheck::isOwnHost(const std::string& host) const {
  const std::string name = hostName(host);
  if (name == "localhost" || name == "127.0.0.1" || name == "[::1]" || name == address_)
    return true;
  const bool listens_to_all = address_ == "0.0.0.0" || address_ == "[::]";
  return listens_to_all && (isAddress(name) || (!name.empty() && name == machineName()));
}

/// Browsers say where a request comes from (https://www.w3.org/TR/fetch-metadata/).
bool AccessCheck::isFromOwnPage(const HttpRequest& request) const {
  const std::string site = request.header("sec-fetch-site");
  return site.empty() || site == "same-origin" || site == "none";
}

bool AccessCheck::hasCookie(const HttpRequest& request) const {
  std::istringstream cookies(request.header("cookie"));
  bool is_there = false;
  for (std::string cookie; std::getline(cookies >> std::ws, cookie, ';');) {
    const std::size_t equals = cookie.find('=');
    if (equals == std::string::npos || cookie.substr(0, equals) != cookie_name_) continue;
    is_there = is_there || areEqual(cookie.substr(equals + 1), cookie_);
  }
  return is_there;
}

}  // namespace synthetic_dataset::programs
