#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

/// An HTTP server on a port of this machine, by libmicrohttpd.
class HttpServer {
 public:
  /// Called in one thread per connection, several at a time. What it throws is sent as an error
  /// response.
  using Handler = std::function<HttpResponse(const HttpRequest& request)>;

  /// Called in the same threads before a request's body is read: returns the answer to a request
  /// that is not admitted, nothing if it is. The body of a refused request is not kept, and its
  /// connection may be closed to make room for others.
  using Gate = std::function<std::optional<HttpResponse>(const HttpRequest& request)>;

  /// Listens from now on, and answers once serve() is called.
  /// @param address  "127.0.0.1", or another IPv4 or IPv6 address of this machine
  /// @param port  0: any free port
  /// @throws Error when it cannot listen there
  HttpServer(const std::string& address, std::uint16_t port);

  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }

  /// @throws Error when the server cannot start
  void serve(Gate gate, Handler handler);

  /// Waits for answers in progress; the handler is not called any more. Event streams have to be
  /// closed before.
  void stop();

 private:
  struct Daemon;
  int socket_ = -1;
  std::uint16_t port_ = 0;
  std::unique_ptr<Daemon> daemon_;
};

}  // namespace synthetic_dataset::programs
