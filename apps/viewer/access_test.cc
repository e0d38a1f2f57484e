#include "apps/viewer/access.h"

#include <gtest/gtest.h>

#include <set>

namespace shoal::access_test {

constexpr const char* kToken = "0123456789abcdef0123456789abcdef";

WebRequest Get(const std::string& path) {
  return {.method = "GET", .path = path, .host = "127.0.0.1:8765"};
}

WebRequest Command() {
  return {.method = "POST",
          .path = "/api/command",
          .host = "localhost:8765",
          .token = kToken,
          .content_type = "application/json"};
}

AccessRules Open() { return {}; }
AccessRules Commanding() { return {.allow_commands = true, .token = kToken}; }
AccessRules Listening() { return {.reading_needs_token = true, .token = kToken}; }

/// 200, or the status of the refusal.
int StatusOf(const AccessRules& rules, const WebRequest& request) {
  const auto denial = FindDenial(rules, request);
  return denial ? denial->status : 200;
}

TEST(Access, LetsThisMachineReadWithoutAToken) {
  EXPECT_EQ(StatusOf(Open(), Get("/")), 200);
  EXPECT_EQ(StatusOf(Open(), Get("/api/setup")), 200);
  EXPECT_EQ(StatusOf(Open(), Get("/api/stream")), 200);
  WebRequest head = Get("/api/frame");
  head.method = "HEAD";
  EXPECT_EQ(StatusOf(Open(), head), 200);
}

TEST(Access, DistinguishesItsOwnHostsFromForeignNames) {
  for (const char* own : {"localhost", "LOCALHOST:1", "127.0.0.1", "127.0.0.1:8765", "[::1]:80",
                          "[::1]", "192.168.1.7:8765", "10.0.0.1"}) {
    EXPECT_TRUE(IsOwnHost(own, {})) << own;
  }
  for (const char* foreign : {"",
                              "evil.example",
                              "localhost.evil.example",
                              "127.0.0.1.evil.example:8765",
                              "localhost:",
                              "localhost:0",
                              "localhost:99999",
                              "localhost:80:80",
                              "localhost:80x",
                              "localhost:+80",
                              "[::1",
                              "[]",
                              "[",
                              "::1",
                              "[evil.example]",
                              "127.0.0.1 ",
                              "127.1",
                              "0x7f000001",
                              "[::1]evil.example",
                              "[::1].evil.example:80",
                              "user@localhost"}) {
    EXPECT_FALSE(IsOwnHost(foreign, {})) << foreign;
  }
  EXPECT_FALSE(IsOwnHost(std::string("localhost\0.evil.example", 23), {}));
  EXPECT_FALSE(IsOwnHost(std::string(100'000, 'a'), {}));
  EXPECT_TRUE(IsOwnHost("Shore:8765", {"shore"}));
  EXPECT_FALSE(IsOwnHost("offshore:8765", {"shore"}));
}

TEST(Access, RefusesANameThatPointsHere) {
  WebRequest request = Get("/api/setup");
  request.host = "rebinding.example:8765";
  EXPECT_EQ(StatusOf(Open(), request), 403);
  request.host = "";
  EXPECT_EQ(StatusOf(Open(), request), 403);
}

TEST(Access, RefusesPagesOfOtherSites) {
  for (const char* site : {"cross-site", "same-site", "SAME-ORIGIN", "x"}) {
    WebRequest request = Get("/api/setup");
    request.sec_fetch_site = site;
    EXPECT_EQ(StatusOf(Open(), request), 403) << site;
  }
  for (const char* origin : {"http://evil.example", "null", "http://127.0.0.1:3000", "file://",
                             "http://127.0.0.1:8765.evil.example"}) {
    WebRequest request = Get("/");
    request.origin = origin;
    EXPECT_EQ(StatusOf(Open(), request), 403) << origin;
  }
}

TEST(Access, KnowsItsOwnPage) {
  WebRequest request = Get("/api/setup");
  request.origin = "http://127.0.0.1:8765";
  for (const char* site : {"same-origin", "none", ""}) {
    request.sec_fetch_site = site;
    EXPECT_EQ(StatusOf(Open(), request), 200) << site;
  }
}

TEST(Access, HasOnlyTheMethodsOfTheProtocol) {
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE", "get", ""}) {
    WebRequest request = Get("/api/setup");
    request.method = method;
    const auto denial = FindDenial(Open(), request);
    ASSERT_TRUE(denial) << method;
    EXPECT_EQ(denial->status, 405);
    EXPECT_EQ(denial->allow, "GET, HEAD");
  }
  WebRequest command = Command();
  for (const char* method : {"GET", "HEAD", "OPTIONS"}) {
    command.method = method;
    EXPECT_EQ(StatusOf(Commanding(), command), 405) << method;
  }
}

TEST(Access, RefusesCommandsUnlessTheyWereAllowedAndStatesHow) {
  for (const AccessRules& rules : {Open(), Listening()}) {
    const auto denial = FindDenial(rules, Command());
    ASSERT_TRUE(denial);
    EXPECT_EQ(denial->status, 403);
    EXPECT_NE(denial->body.find("--allow-commands"), std::string::npos) << denial->body;
    EXPECT_FALSE(MaySendCommands(rules, Command()));
  }
}

TEST(Access, TakesCommandsWithTheToken) {
  EXPECT_EQ(StatusOf(Commanding(), Command()), 200);
  EXPECT_TRUE(MaySendCommands(Commanding(), Command()));
  for (const std::string token : {"", "0", "0123456789abcdef0123456789abcdeF"}) {
    WebRequest request = Command();
    request.token = token;
    EXPECT_EQ(StatusOf(Commanding(), request), 403) << token;
    EXPECT_FALSE(MaySendCommands(Commanding(), request));
    // Reading needs no token.
    request.path = "/api/setup";
    request.method = "GET";
    EXPECT_EQ(StatusOf(Commanding(), request), 200);
  }
  // Not in the query: addresses are written into histories and logs.
  WebRequest request = Command();
  request.token.clear();
  request.query = {{"token", kToken}};
  EXPECT_EQ(StatusOf(Commanding(), request), 403);
}

TEST(Access, TakesNoCommandThatAFormCouldSend) {
  for (const char* type : {"", "text/plain", "application/x-www-form-urlencoded",
                           "multipart/form-data; boundary=x", "application/jsonx", ";"}) {
    WebRequest request = Command();
    request.content_type = type;
    EXPECT_EQ(StatusOf(Commanding(), request), 400) << type;
  }
  WebRequest request = Command();
  request.content_type = "Application/JSON ; charset=utf-8";
  EXPECT_EQ(StatusOf(Commanding(), request), 200);
}

TEST(Access, NeedsTheTokenForDataBeyondLoopbackButNotForThePage) {
  WebRequest request = Get("/api/setup");
  EXPECT_EQ(StatusOf(Listening(), request), 403);
  request.token = kToken;
  EXPECT_EQ(StatusOf(Listening(), request), 200);
  EXPECT_EQ(StatusOf(Listening(), Get("/app.js")), 200);
  WebRequest stream = Get("/api/stream");
  EXPECT_EQ(StatusOf(Listening(), stream), 403);
  stream.query = {{"token", "wrong"}};
  EXPECT_EQ(StatusOf(Listening(), stream), 403);
  stream.query = {{"token", kToken}};
  EXPECT_EQ(StatusOf(Listening(), stream), 200);
}

TEST(Access, AcceptsNoEmptyToken) {
  EXPECT_FALSE(TokensMatch("", ""));
  EXPECT_EQ(StatusOf({.reading_needs_token = true}, Get("/api/setup")), 403);
  WebRequest request = Command();
  request.token.clear();
  EXPECT_EQ(StatusOf({.allow_commands = true}, request), 403);
}

TEST(Access, MakesTokensOf128BitsThatDiffer) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(NewToken());
  EXPECT_EQ(tokens.size(), 100U);
  for (const std::string& token : tokens) {
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos) << token;
  }
}

}  // namespace shoal::access_test
