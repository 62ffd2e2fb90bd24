#include "programs/setup_assistant/web/access_check.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace {

const std::string kToken = "0123456789abcdef0123456789abcdef";

HttpRequest requestFor(const std::string& path, const std::string& host) {
  HttpRequest request;
  request.method = "GET";
  request.path = path;
  request.headers["host"] = host;
  return request;
}

/// A server, and a browser that has opened its address with the token.
struct Visited {
  explicit Visited(const std::string& address = "127.0.0.1") : check(kToken, address, 8080) {
    HttpRequest first = requestFor("/", "localhost:8080");
    first.query["token"] = kToken;
    const auto answer = check.answer(first);
    status = answer->status;
    folder = answer->headers.at("Location");
    whole_cookie = answer->headers.at("Set-Cookie");
    cookie = whole_cookie.substr(0, whole_cookie.find(';'));
  }

  /// A request of the browser from the page.
  [[nodiscard]] HttpRequest request(const std::string& path, const std::string& host) const {
    HttpRequest request = requestFor(folder + path, host);
    request.headers["cookie"] = "other=1; " + cookie;
    return request;
  }

  /// The status of the answer; 200 for a request that gets through.
  [[nodiscard]] int statusOf(const HttpRequest& request) const {
    const auto answer = check.answer(request);
    return answer ? answer->status : 200;
  }

  [[nodiscard]] int statusFor(const std::string& host) const { return statusOf(request("", host)); }

  AccessCheck check;
  int status = 0;
  std::string folder;
  std::string whole_cookie;
  std::string cookie;
};

TEST(AccessCheck, AnswersNobodyWithoutTheToken) {
  const Visited visited;
  EXPECT_EQ(403, visited.statusOf(requestFor("/", "127.0.0.1:8080")));
  EXPECT_EQ(403, visited.statusOf(requestFor("/api/state", "127.0.0.1:8080")));
  EXPECT_EQ(403, visited.statusOf(requestFor(visited.folder, "127.0.0.1:8080")));
  HttpRequest other = visited.request("", "127.0.0.1:8080");
  other.headers["cookie"] = "synthetic_dataset_8080=wrong";
  EXPECT_EQ(403, visited.statusOf(other));
  HttpRequest wrong = requestFor("/", "127.0.0.1:8080");
  wrong.query["token"] = kToken.substr(1);
  EXPECT_EQ(403, visited.statusOf(wrong));
  EXPECT_EQ("", visited.check.answer(wrong)->body);
}

TEST(AccessCheck, GivesACookieOnTheFirstVisit) {
  const Visited visited;
  EXPECT_EQ(303, visited.status);
  EXPECT_EQ(200, visited.statusOf(visited.request("api/state", "localhost:8080")));
  EXPECT_EQ("/api/state", visited.check.inside(visited.request("api/state", "")).path);
  HttpRequest program = requestFor("/api/state", "localhost:8080");
  program.query["token"] = kToken;
  EXPECT_EQ(200, visited.statusOf(program));
  EXPECT_EQ("/api/state", visited.check.inside(program).path);
}

/// Browsers send cookies to all ports of a machine, but to no other path.
TEST(AccessCheck, KeepsTheCookieFromOtherServersOfTheMachine) {
  const Visited visited;
  EXPECT_EQ(34U, visited.folder.size());
  EXPECT_EQ(visited.cookie + "; Path=" + visited.folder + "; HttpOnly; SameSite=Strict",
            visited.whole_cookie);
  EXPECT_EQ(std::string::npos, visited.whole_cookie.find(kToken));
  EXPECT_NE(visited.folder, Visited().folder);
  HttpRequest elsewhere = visited.request("", "localhost:8080");
  elsewhere.path = "/";
  EXPECT_EQ(403, visited.statusOf(elsewhere));
}

TEST(AccessCheck, RefusesNamesThatSomebodyElsesDnsLeadsHere) {
  const Visited visited;
  EXPECT_EQ(403, visited.statusFor("evil.example:8080"));
  EXPECT_EQ(403, visited.statusFor(""));
  EXPECT_EQ(403, visited.statusFor("192.0.2.7:8080"));
  EXPECT_EQ(200, visited.statusFor("[::1]:8080"));
  EXPECT_EQ(200, visited.statusFor("localhost:9000"));  // by ssh -L
  EXPECT_EQ(200, Visited("192.0.2.7").statusFor("192.0.2.7:8080"));
  EXPECT_EQ(200, Visited("0.0.0.0").statusFor("192.0.2.7:8080"));
  EXPECT_EQ(403, Visited("0.0.0.0").statusFor("evil.example"));
}

TEST(AccessCheck, RefusesOtherPagesOnThisMachine) {
  const Visited visited;
  HttpRequest request = visited.request("api/set", "127.0.0.1:8080");
  request.headers["origin"] = "http://127.0.0.1:8080";
  EXPECT_EQ(200, visited.statusOf(request));
  request.headers["origin"] = "http://127.0.0.1:9999";
  EXPECT_EQ(403, visited.statusOf(request));
  request.headers["origin"] = "null";
  EXPECT_EQ(403, visited.statusOf(request));
  request.headers.erase("origin");
  request.headers["sec-fetch-site"] = "same-site";
  EXPECT_EQ(403, visited.statusOf(request));
}

TEST(Token, IsAnotherOneEachTime) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(makeToken());
  EXPECT_EQ(100U, tokens.size());
  EXPECT_EQ(32U, tokens.begin()->size());
}

}  // namespace
}  // namespace synthetic_dataset::programs
