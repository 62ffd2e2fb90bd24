#include "programs/setup_assistant/web/http_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <utility>

#include <microhttpd.h>

#include "programs/setup_assistant/web/connection_list.h"

namespace synthetic_dataset::programs {
namespace {

using Answer = decltype(MHD_YES);  // an enumeration since 0.9.71, int before

constexpr std::size_t kLargestBody = 16U << 20U;
constexpr std::size_t kLargestRefusedBody = 64U << 10U;  // is read, so that the 403 arrives
constexpr unsigned kIdleTime = 60;                       // after which a connection is closed [s]
constexpr unsigned kStrangerTime = 10;                   // the same before the token was seen [s]
constexpr std::chrono::seconds kEventPatience(5);

/// A request that is being received, piece by piece.
struct Incoming {
  HttpRequest request;
  std::optional<HttpResponse> refusal;  ///< the answer to a request that is not admitted
  std::size_t body_size = 0;

  /// Takes a piece of the body. @return whether more may come
  bool take(const char* data, std::size_t size) {
    body_size += size;
    if (refusal) return body_size <= kLargestRefusedBody;
    if (!isTooLarge()) request.body.append(data, size);
    return true;
  }

  [[nodiscard]] bool isTooLarge() const { return body_size > kLargestBody; }
};

int socketOf(MHD_Connection* connection) {
  const auto* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
  return info == nullptr ? -1 : info->connect_fd;
}

std::string smallLetters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

Answer addHeader(void* incoming, MHD_ValueKind /*kind*/, const char* name, const char* value) {
  static_cast<Incoming*>(incoming)->request.headers[smallLetters(name)] =
      value == nullptr ? "" : value;
  return MHD_YES;
}

Answer addParameter(void* incoming, MHD_ValueKind /*kind*/, const char* name, const char* value) {
  static_cast<Incoming*>(incoming)->request.query[name] = value == nullptr ? "" : value;
  return MHD_YES;
}

/// A stream of events, and the part of its text that has not been sent yet.
struct Outgoing {
  std::shared_ptr<EventStream> events;
  std::string text;
};

ssize_t readEvents(void* closure, std::uint64_t /*position*/, char* buffer, std::size_t most) {
  auto& outgoing = *static_cast<Outgoing*>(closure);
  if (outgoing.text.empty()) {
    const auto next = outgoing.events->next(kEventPatience);
    if (!next) return MHD_CONTENT_READER_END_OF_STREAM;
    outgoing.text = *next;
  }
  const std::size_t count = std::min(most, outgoing.text.size());
  std::memcpy(buffer, outgoing.text.data(), count);
  outgoing.text.erase(0, count);
  return static_cast<ssize_t>(count);
}

void freeEvents(void* closure) { delete static_cast<Outgoing*>(closure); }

MHD_Response* makeResponse(HttpResponse& response) {
  constexpr std::size_t kBlock = 32768;
  if (response.events != nullptr) {
    return MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, kBlock, readEvents,
                                             new Outgoing{response.events, ": here\n\n"},
                                             freeEvents);
  }
  return MHD_create_response_from_buffer(response.body.size(), response.body.data(),
                                         MHD_RESPMEM_MUST_COPY);
}

Answer send(MHD_Connection* connection, HttpResponse response) {
  MHD_Response* const made = makeResponse(response);
  if (made == nullptr) return MHD_NO;
  std::map<std::string, std::string> headers = {
      {"Content-Type", response.type},
      {"Cache-Control", "no-store"},
      {"X-Content-Type-Options", "nosniff"},
      {"X-Frame-Options", "DENY"},
      {"Referrer-Policy", "no-referrer"},
      {"Content-Security-Policy",
       "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
       "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"}};
  for (const auto& [name, value] : response.headers) headers[name] = value;
  for (const auto& [name, value] : headers) {
    MHD_add_response_header(made, name.c_str(), value.c_str());
  }
  const Answer answer =
      MHD_queue_response(connection, static_cast<unsigned>(response.status), made);
  MHD_destroy_response(made);
  return answer;
}

HttpResponse answerTo(const HttpServer::Handler& handler, const HttpRequest& request) {
  try {
    return handler(request);
  } catch (const HttpError& error) {
    return errorResponse(error.status(), error.what());
  } catch (const Error& error) {
    return errorResponse(422, error.what());
  } catch (const std::exception& error) {
    return errorResponse(500, error.what());
  }
}

[[noreturn]] void failToListen(const std::string& address, std::uint16_t port) {
  throw Error("cannot listen on " + address + " port " + std::to_string(port) + ": " +
              std::generic_category().message(errno));
}

/// The system's form of an IPv4 or IPv6 address.
sockaddr_storage socketAddress(const std::string& address, std::uint16_t port) {
  sockaddr_storage storage{};
  auto* four = reinterpret_cast<sockaddr_in*>(&storage);
  auto* six = reinterpret_cast<sockaddr_in6*>(&storage);
  if (::inet_pton(AF_INET, address.c_str(), &four->sin_addr) == 1) {
    four->sin_family = AF_INET;
    four->sin_port = htons(port);
  } else if (::inet_pton(AF_INET6, address.c_str(), &six->sin6_addr) == 1) {
    six->sin6_family = AF_INET6;
    six->sin6_port = htons(port);
  } else {
    throw Error("--address: found '" + address +
                "'; it should be an address of this machine, such as 127.0.0.1 or 0.0.0.0");
  }
  return storage;
}

}  // namespace

struct HttpServer::Daemon {
  ~Daemon() {
    if (daemon != nullptr) MHD_stop_daemon(daemon);
  }

  static Answer take(void* closure, MHD_Connection* connection, const char* url, const char* method,
                     const char* /*version*/, const char* data, std::size_t* size, void** memory) {
    auto& daemon = *static_cast<Daemon*>(closure);
    auto* incoming = static_cast<Incoming*>(*memory);
    if (incoming == nullptr) {
      incoming = new Incoming{{method, url, {}, {}, ""}, std::nullopt, 0};
      *memory = incoming;
      daemon.meet(connection, *incoming);
      return MHD_YES;
    }
    if (*size > 0) {
      const bool goes_on = incoming->take(data, *size);
      *size = 0;
      return goes_on ? MHD_YES : MHD_NO;
    }
    if (incoming->refusal) return send(connection, *incoming->refusal);
    if (incoming->isTooLarge()) {
      return send(connection, errorResponse(413, "found more than 16 MiB; it should be less"));
    }
    // An answer may take longer than a connection may be idle; setting the time again restarts it.
    MHD_set_connection_option(connection, MHD_CONNECTION_OPTION_TIMEOUT, 0U);
    const Answer answer = send(connection, answerTo(daemon.handler, incoming->request));
    MHD_set_connection_option(connection, MHD_CONNECTION_OPTION_TIMEOUT, kIdleTime);
    return answer;
  }

  static void forget(void* /*closure*/, MHD_Connection* /*connection*/, void** memory,
                     MHD_RequestTerminationCode /*code*/) {
    delete static_cast<Incoming*>(*memory);
    *memory = nullptr;
  }

  /// Reads a request's headers, and decides whether it is admitted.
  void meet(MHD_Connection* connection, Incoming& incoming) {
    MHD_get_connection_values(connection, MHD_HEADER_KIND, addHeader, &incoming);
    MHD_get_connection_values(connection, MHD_GET_ARGUMENT_KIND, addParameter, &incoming);
    incoming.refusal = gate(incoming.request);
    if (incoming.refusal) return;
    connections.admit(socketOf(connection));
    MHD_set_connection_option(connection, MHD_CONNECTION_OPTION_TIMEOUT, kIdleTime);
  }

  static void count(void* closure, MHD_Connection* connection, void** /*memory*/,
                    MHD_ConnectionNotificationCode code) {
    auto& connections = static_cast<Daemon*>(closure)->connections;
    const int socket = socketOf(connection);
    code == MHD_CONNECTION_NOTIFY_STARTED ? connections.open(socket) : connections.close(socket);
  }

  Gate gate;
  Handler handler;
  ConnectionList connections;
  MHD_Daemon* daemon = nullptr;
};

HttpServer::HttpServer(const std::string& address, std::uint16_t port) {
  sockaddr_storage wanted = socketAddress(address, port);
  auto* const name = reinterpret_cast<sockaddr*>(&wanted);
  socklen_t size = wanted.ss_family == AF_INET ? sizeof(sockaddr_in) : sizeof(sockaddr_in6);
  socket_ = ::socket(wanted.ss_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int is_on = 1;
  ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &is_on, sizeof is_on);
  if (socket_ < 0 || ::bind(socket_, name, size) != 0 || ::listen(socket_, SOMAXCONN) != 0 ||
      ::getsockname(socket_, name, &size) != 0) {
    const int reason = errno;
    if (socket_ >= 0) ::close(socket_);
    errno = reason;
    failToListen(address, port);
  }
  port_ = ntohs(wanted.ss_family == AF_INET ? reinterpret_cast<sockaddr_in*>(name)->sin_port
                                            : reinterpret_cast<sockaddr_in6*>(name)->sin6_port);
}

void HttpServer::stop() { daemon_.reset(); }

HttpServer::~HttpServer() {
  stop();
  if (socket_ >= 0) ::close(socket_);
}

void HttpServer::serve(Gate gate, Handler handler) {
  constexpr unsigned kMostConnections = 4 * ConnectionList::kMostStrangers;
  daemon_ = std::make_unique<Daemon>();
  daemon_->gate = std::move(gate);
  daemon_->handler = std::move(handler);
  daemon_->daemon = MHD_start_daemon(
      MHD_USE_THREAD_PER_CONNECTION | MHD_USE_INTERNAL_POLLING_THREAD, port_, nullptr, nullptr,
      &Daemon::take, daemon_.get(), MHD_OPTION_LISTEN_SOCKET, socket_, MHD_OPTION_CONNECTION_LIMIT,
      kMostConnections, MHD_OPTION_CONNECTION_TIMEOUT, kStrangerTime, MHD_OPTION_NOTIFY_COMPLETED,
      &Daemon::forget, nullptr, MHD_OPTION_NOTIFY_CONNECTION, &Daemon::count, daemon_.get(),
      MHD_OPTION_END);
  if (daemon_->daemon == nullptr) throw Error("the server cannot start");
  socket_ = -1;  // now owned by the daemon, which closes it
}

}  // namespace synthetic_dataset::programs
