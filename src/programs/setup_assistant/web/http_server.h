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
  /// Called in a thread for each connection, several at a time. What it throws is answered as an
  /// error.
  using Handler = std::function<HttpResponse(const HttpRequest& request)>;

  /// Called in the same threads before a request's body is read: what a request is answered that
  /// does not get through. Its body is not kept, and its connection makes room for others.
  using Gate = std::function<std::optional<HttpResponse>(const HttpRequest& request)>;

  /// Listens from now on, and answers once serve() is called.
  /// @param address  "127.0.0.1", or another one of this machine, of IPv4 or IPv6
  /// @param port  0: one that is free
  /// @throws Error when nobody can listen there
  HttpServer(const std::string& address, std::uint16_t port);

  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }

  /// @throws Error when there is no thread for it
  void serve(Gate gate, Handler handler);

  /// Waits for the answers that are under way; the handler is not called any more. Streams of
  /// events have to be closed before.
  void stop();

 private:
  struct Daemon;
  int socket_ = -1;
  std::uint16_t port_ = 0;
  std::unique_ptr<Daemon> daemon_;
};

}  // namespace synthetic_dataset::programs
