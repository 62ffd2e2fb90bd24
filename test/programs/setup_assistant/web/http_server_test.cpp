// Without libmicrohttpd there is no server.
#if __has_include(<microhttpd.h>)
#include "programs/setup_assistant/web/http_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

/// A plain connection of a client.
class Connection {
 public:
  explicit Connection(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    is_open_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~Connection() { ::close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void send(const std::string& text) const {
    std::size_t sent = 0;
    while (sent < text.size()) {
      const ssize_t count = ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) break;
      sent += static_cast<std::size_t>(count);
    }
  }

  /// Everything received until a text has arrived or the server has closed the connection.
  [[nodiscard]] std::string readUntil(const std::string& text) const {
    std::string all;
    std::array<char, 4096> bytes{};
    while (all.find(text) == std::string::npos) {
      const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
      if (count <= 0) break;
      all.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return all;
  }

  [[nodiscard]] bool isOpen() const { return is_open_; }

 private:
  int socket_;
  bool is_open_ = false;
};

std::string answerOf(std::uint16_t port, const std::string& request) {
  const Connection connection(port);
  connection.send(request);
  return connection.readUntil("end of answer");
}

/// Answers with the request.
HttpResponse echo(const HttpRequest& request) {
  if (request.path == "/missing") throw HttpError(404, "no such thing");
  if (request.path == "/wrong") throw Error("far: found -1; it should be above 0");
  HttpResponse response;
  response.body = request.method + " " + request.path +
                  " a=" + request.parameter("a").value_or("") + " host=" + request.header("host") +
                  " body=" + request.body + " end of answer";
  return response;
}

/// Lets through everyone who does not claim to be a stranger.
std::optional<HttpResponse> requireToken(const HttpRequest& request) {
  if (request.header("i-am") != "stranger") return std::nullopt;
  HttpResponse response;
  response.status = 403;
  return response;
}

struct EchoServer {
  EchoServer() { server.serve(requireToken, echo); }
  HttpServer server{"127.0.0.1", 0};
};

TEST(HttpServer, GivesRequestsToItsHandler) {
  const EchoServer echo_server;
  const std::uint16_t port = echo_server.server.port();
  const std::string get =
      answerOf(port, "GET /a%20b?a=x%26y HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(0U, get.find("HTTP/1.1 200")) << get;
  EXPECT_NE(std::string::npos, get.find("GET /a b a=x&y host=here body= end")) << get;
  EXPECT_NE(std::string::npos, get.find("X-Frame-Options: DENY")) << get;
  const std::string post = answerOf(
      port,
      "POST /x HTTP/1.1\r\nHost: here\r\nContent-Length: 5\r\nConnection: close\r\n\r\nhello");
  EXPECT_NE(std::string::npos, post.find("POST /x a= host=here body=hello end")) << post;
}

TEST(HttpServer, AnswersWhatIsNotPossible) {
  const EchoServer echo_server;
  const std::uint16_t port = echo_server.server.port();
  const std::string rest = " HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n";
  EXPECT_EQ(0U, answerOf(port, "GET /missing" + rest).find("HTTP/1.1 404"));
  const std::string wrong = answerOf(port, "GET /wrong" + rest);
  EXPECT_EQ(0U, wrong.find("HTTP/1.1 422"));
  EXPECT_NE(std::string::npos, wrong.find(R"({"error": "far: found -1; it should be above 0"})"));
}

TEST(HttpServer, IsNotKeptFromUsersByConnectionsOfStrangers) {
  const EchoServer echo_server;
  const std::uint16_t port = echo_server.server.port();
  const Connection user(port);
  user.send("GET /a HTTP/1.1\r\nHost: here\r\n\r\n");
  EXPECT_NE(std::string::npos, user.readUntil("end of answer").find("GET /a"));
  std::vector<std::unique_ptr<Connection>> idle;
  for (int i = 0; i < 400; ++i) idle.push_back(std::make_unique<Connection>(port));
  user.send("GET /b HTTP/1.1\r\nHost: here\r\n\r\n");
  EXPECT_NE(std::string::npos, user.readUntil("end of answer").find("GET /b"));
  EXPECT_NE(std::string::npos,
            answerOf(port, "GET /c HTTP/1.1\r\nHost: here\r\n\r\n").find("GET /c"));
  EXPECT_EQ("", idle.front()->readUntil("the end"));  // it has been closed
}

TEST(HttpServer, DoesNotReadWhatStrangersSend) {
  const EchoServer echo_server;
  const std::uint16_t port = echo_server.server.port();
  const std::string head = "POST /x HTTP/1.1\r\nHost: here\r\nI-Am: stranger\r\n";
  EXPECT_EQ(0U, answerOf(port, head + "Connection: close\r\nContent-Length: 5\r\n\r\nhello")
                    .find("HTTP/1.1 403"));
  const Connection stranger(port);
  stranger.send(head + "Content-Length: 16000000\r\n\r\n" + std::string(15000000, 'x'));
  EXPECT_EQ(std::string::npos, stranger.readUntil("end of answer").find("200"));
}

TEST(HttpServer, SendsEventsAndEndsWithTheirStream) {
  EventHub hub;
  auto server = std::make_unique<HttpServer>("127.0.0.1", 0);
  server->serve(requireToken, [&](const HttpRequest&) {
    HttpResponse response;
    response.type = "text/event-stream";
    response.events = hub.subscribe();
    response.events->push("run", "{\"n\": 1}");
    return response;
  });
  const Connection page(server->port());
  page.send("GET /api/events HTTP/1.1\r\nHost: here\r\n\r\n");
  EXPECT_NE(std::string::npos, page.readUntil("\"n\": 1").find("event: run"));
  hub.close();
  server.reset();
  EXPECT_EQ(std::string::npos, page.readUntil("never").find("event:"));
}

TEST(HttpServer, TakesAPortThatIsFreeAndSaysWhenOneIsNot) {
  const EchoServer one;
  EXPECT_NE(0, one.server.port());
  EXPECT_TRUE(Connection(one.server.port()).isOpen());
  EXPECT_THROW(HttpServer("127.0.0.1", one.server.port()), Error);
  EXPECT_THROW(HttpServer("no address", 0), Error);
}

}  // namespace
}  // namespace synthetic_dataset::programs
#endif
