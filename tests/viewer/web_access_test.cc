// Which requests the viewer's web server allows, over real sockets.
#include <gtest/gtest.h>

#include "tests/viewer/served_site.h"

namespace shoal::web_access_test {

const std::string kCommand = R"({"target": "alpha", "words": ["deploy"]})";
const std::string kJson = "Content-Type: application/json\r\n";
const std::string kTokenHeader = std::string("X-Shoal-Token: ") + kTestToken + "\r\n";

AccessRules Commanding() { return {.allow_commands = true, .token = kTestToken}; }

TEST(WebAccess, RefusesForeignNamesSitesAndPages) {
  const ServedSite served;
  const std::string get = "GET /api/setup HTTP/1.1\r\nConnection: close\r\n";
  EXPECT_EQ(StatusOf(Exchange(served.port(), get + "Host: evil.example:8765\r\n\r\n")), 403);
  EXPECT_EQ(StatusOf(Exchange(served.port(), get + "\r\n")), 403);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/setup", "Origin: http://evil.example\r\n")), 403);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/setup", "Origin: null\r\n")), 403);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/stream", "Sec-Fetch-Site: cross-site\r\n")), 403);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/", "Sec-Fetch-Site: same-site\r\n")), 403);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/setup",
                         "Origin: http://localhost\r\nSec-Fetch-Site: same-origin\r\n")),
            200);
}

TEST(WebAccess, PassesNoCommandOnThatWasNotAllowed) {
  ServedSite served;
  const std::string answer = Exchange(served.port(), PostText(kCommand, kJson + kTokenHeader));
  EXPECT_EQ(StatusOf(answer), 403);
  EXPECT_NE(answer.find("--allow-commands"), std::string::npos) << answer;
  EXPECT_EQ(served.num_commands(), 0);
}

TEST(WebAccess, PassesOnNoCommandWithoutTheRightHeaders) {
  ServedSite served(Commanding());
  const int port = served.port();
  EXPECT_EQ(StatusOf(Exchange(port, PostText(kCommand, kJson))), 403);
  EXPECT_EQ(StatusOf(Exchange(port, PostText(kCommand, kJson + "X-Shoal-Token: wrong\r\n"))), 403);
  EXPECT_EQ(StatusOf(Exchange(port, PostText(kCommand, kTokenHeader))), 400);
  EXPECT_EQ(
      StatusOf(Exchange(port, PostText(kCommand, kTokenHeader + "Content-Type: text/plain\r\n"))),
      400);
  EXPECT_EQ(StatusOf(Exchange(port, PostText(kCommand, kJson + kTokenHeader +
                                                           "Origin: http://evil.example\r\n"))),
            403);
  EXPECT_EQ(StatusOf(Exchange(
                port, PostText(kCommand, kJson + kTokenHeader + "Sec-Fetch-Site: cross-site\r\n"))),
            403);
  EXPECT_EQ(StatusOf(Exchange(port, PostText("{}", kJson + kTokenHeader))), 400);
  EXPECT_EQ(served.num_commands(), 0);
  EXPECT_EQ(StatusOf(Exchange(port, PostText(kCommand, kJson + kTokenHeader))), 200);
  EXPECT_EQ(served.num_commands(), 1);
}

TEST(WebAccess, ShowsDataOnlyWithTheTokenWhereItMust) {
  const ServedSite served({.reading_needs_token = true, .token = kTestToken});
  EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 200);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/app.js")), 200);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/frame")), 403);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/frame", "X-Shoal-Token: x\r\n")), 403);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/frame", kTokenHeader)), 200);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/stream")), 403);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/stream?token=x")), 403);
}

}  // namespace shoal::web_access_test
