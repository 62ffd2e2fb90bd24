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

HttpRequest withCookie(HttpRequest request, const std::string& token = kToken) {
  request.headers["cookie"] = "other=1; synthetic_dataset_8080=" + token;
  return request;
}

/// 200 for a request that gets through.
int statusOf(const HttpRequest& request, const std::string& address = "127.0.0.1") {
  const auto answer = AccessCheck(kToken, address, 8080).answer(request);
  return answer ? answer->status : 200;
}

TEST(AccessCheck, AnswersNobodyWithoutTheToken) {
  EXPECT_EQ(403, statusOf(requestFor("/", "127.0.0.1:8080")));
  EXPECT_EQ(403, statusOf(requestFor("/api/state", "127.0.0.1:8080")));
  EXPECT_EQ(403, statusOf(withCookie(requestFor("/", "127.0.0.1:8080"), "wrong")));
  HttpRequest wrong = requestFor("/", "127.0.0.1:8080");
  wrong.query["token"] = kToken.substr(1);
  EXPECT_EQ(403, statusOf(wrong));
  EXPECT_EQ("", AccessCheck(kToken, "127.0.0.1", 8080).answer(wrong)->body);
}

TEST(AccessCheck, KeepsTheTokenOfTheFirstVisitInACookie) {
  HttpRequest first = requestFor("/", "localhost:8080");
  first.query["token"] = kToken;
  const auto answer = AccessCheck(kToken, "127.0.0.1", 8080).answer(first);
  ASSERT_TRUE(answer);
  EXPECT_EQ(303, answer->status);
  EXPECT_EQ("/", answer->headers.at("Location"));
  EXPECT_EQ("synthetic_dataset_8080=" + kToken + "; Path=/; HttpOnly; SameSite=Strict",
            answer->headers.at("Set-Cookie"));
  EXPECT_EQ(200, statusOf(withCookie(requestFor("/api/state", "localhost:8080"))));
}

TEST(AccessCheck, RefusesNamesThatSomebodyElsesDnsLeadsHere) {
  EXPECT_EQ(403, statusOf(withCookie(requestFor("/", "evil.example:8080"))));
  EXPECT_EQ(403, statusOf(withCookie(requestFor("/", ""))));
  EXPECT_EQ(403, statusOf(withCookie(requestFor("/", "192.0.2.7:8080"))));
  EXPECT_EQ(200, statusOf(withCookie(requestFor("/", "[::1]:8080"))));
  EXPECT_EQ(200, statusOf(withCookie(requestFor("/", "localhost:9000"))));  // by ssh -L
  EXPECT_EQ(200, statusOf(withCookie(requestFor("/", "192.0.2.7:8080")), "192.0.2.7"));
  EXPECT_EQ(200, statusOf(withCookie(requestFor("/", "192.0.2.7:8080")), "0.0.0.0"));
  EXPECT_EQ(403, statusOf(withCookie(requestFor("/", "evil.example")), "0.0.0.0"));
}

TEST(AccessCheck, RefusesOtherPagesOnThisMachine) {
  HttpRequest request = withCookie(requestFor("/api/set", "127.0.0.1:8080"));
  request.headers["origin"] = "http://127.0.0.1:8080";
  EXPECT_EQ(200, statusOf(request));
  request.headers["origin"] = "http://127.0.0.1:9999";
  EXPECT_EQ(403, statusOf(request));
  request.headers["origin"] = "null";
  EXPECT_EQ(403, statusOf(request));
  request.headers.erase("origin");
  request.headers["sec-fetch-site"] = "same-site";
  EXPECT_EQ(403, statusOf(request));
}

TEST(Token, IsAnotherOneEachTime) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(makeToken());
  EXPECT_EQ(100U, tokens.size());
  EXPECT_EQ(32U, tokens.begin()->size());
}

}  // namespace
}  // namespace synthetic_dataset::programs
