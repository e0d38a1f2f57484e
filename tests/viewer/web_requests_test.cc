// How the viewer's web server answers requests: valid, malformed and endless.
#include <gtest/gtest.h>

#include "tests/viewer/served_site.h"

namespace shoal::web_requests_test {

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(WebRequests, AreAnsweredWithThePageAndItsSafetyHeaders) {
  const ServedSite served;
  const std::string answer = Ask(served.port(), "/");
  EXPECT_EQ(StatusOf(answer), 200);
  EXPECT_TRUE(answer.ends_with("\r\n\r\n<html>page</html>")) << answer;
  for (const char* header :
       {"Content-Type: text/html; charset=utf-8\r\n", "Content-Security-Policy: default-src 'self'",
        "X-Content-Type-Options: nosniff\r\n", "Referrer-Policy: no-referrer\r\n",
        "X-Frame-Options: DENY\r\n", "Cache-Control: no-cache\r\n", "Connection: close\r\n"}) {
    EXPECT_TRUE(Has(answer, header)) << header << answer;
  }
  EXPECT_FALSE(Has(answer, "unsafe-inline")) << answer;
  const std::string data = Ask(served.port(), "/api/setup");
  EXPECT_TRUE(Has(data, "Cache-Control: no-store\r\n")) << data;
  EXPECT_TRUE(Has(data, "Content-Type: application/json\r\n")) << data;
  EXPECT_TRUE(data.ends_with(R"({"commands":false})")) << data;
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/vehicle?name=%61lpha")), 404);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/frame?t=12.5")), 200);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/frame?t=x")), 400);
}

TEST(WebRequests, SendALongAnswerWhole) {
  const ServedSite served;
  const std::string answer = Ask(served.port(), "/api/trails");
  EXPECT_TRUE(Has(answer, "Content-Length: 3000000\r\n"));
  EXPECT_TRUE(answer.ends_with("\r\n\r\n" + std::string(3'000'000, 'x')));
}

TEST(WebRequests, FollowOneAnotherOnAConnection) {
  const ServedSite served;
  TcpClient client(served.port());
  for (size_t i = 1; i <= 20; ++i) {
    client.Send(GetText("/app.js"));
    ASSERT_TRUE(Await([&] {
      client.Receive();
      size_t number = 0;
      for (size_t at = 0; (at = client.received().find("run()", at)) != std::string::npos; ++at) {
        ++number;
      }
      return number == i;
    })) << client.received();
  }
  EXPECT_TRUE(Has(client.received(), "Keep-Alive: timeout=6")) << client.received();
  // Several at once, too.
  const std::string answers =
      Exchange(served.port(),
               GetText("/app.js") + GetText("/") + GetText("/api/events", "Connection: close\r\n"));
  EXPECT_TRUE(Has(answers, "run()"));
  EXPECT_TRUE(Has(answers, "<html>page</html>"));
  EXPECT_TRUE(answers.ends_with("{}"));
}

TEST(WebRequests, OfIdleConnectionsEndInTime) {
  const ServedSite served;
  TcpClient client(served.port());
  client.Send(GetText("/app.js"));
  EXPECT_TRUE(Await([&] {
    client.Receive();
    return client.has_ended();
  }));
  EXPECT_TRUE(client.received().ends_with("run()")) << client.received();
}

TEST(WebRequests, WithHeadGetTheHeadersOnly) {
  const ServedSite served;
  const std::string answer = Exchange(
      served.port(), "HEAD /app.js HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(StatusOf(answer), 200);
  EXPECT_TRUE(Has(answer, "Content-Length: 5\r\n")) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n")) << answer;
}

TEST(WebRequests, WithOtherMethodsGet405) {
  const ServedSite served;
  for (const std::string method :
       {"OPTIONS", "PUT", "DELETE", "TRACE", "CONNECT", "PATCH", "PRI"}) {
    const std::string answer =
        Exchange(served.port(), method + " /api/setup HTTP/1.1\r\nHost: localhost\r\n\r\n");
    EXPECT_EQ(StatusOf(answer), 405) << method;
    EXPECT_TRUE(Has(answer, "Allow: ")) << answer;
    EXPECT_FALSE(Has(answer, "Access-Control-")) << answer;
  }
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/command")), 405);
}

TEST(WebRequests, ThatAreMalformedGetAnErrorAndOthersDoNot) {
  using std::string_literals::operator""s;  // It counts the text, the zero bytes in it too.
  const ServedSite served;
  for (const std::string& text :
       {"\r\n\r\n"s, "GET\r\n\r\n"s, "GET / HTTP/9.9\r\n\r\n"s,
        "GET / HTTP/1.1\r\nno colon\r\n\r\n"s, "GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n"s,
        "GET http://localhost/ HTTP/1.1\r\nHost: localhost\r\n\r\n"s,
        "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n"s,
        "GET /\0 HTTP/1.1\r\nHost: localhost\r\n\r\n"s,
        "POST /api/command HTTP/1.1\r\nHost: localhost\r\n"
        "Transfer-Encoding: chunked\r\n\r\n5\r\nhello\r\n0\r\n\r\n"s}) {
    const std::string answer = Exchange(served.port(), text);
    EXPECT_EQ(StatusOf(answer), 400) << text;
    EXPECT_TRUE(Has(answer, R"({"error":)")) << answer;
    EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 200);
  }
}

TEST(WebRequests, LeadOutOfNoFolder) {
  const ServedSite served;
  for (const std::string path :
       {"/../../../../etc/passwd", "/..%2f..%2f..%2fetc%2fpasswd", "/%2e%2e/%2e%2e/etc/passwd",
        "/..%5c..%5cetc%5cpasswd", "//etc/passwd", "/./app.js", "/app.js/", "/app.js%00.html",
        "/%c0%ae%c0%ae/etc/passwd", "/index.html/../../etc/passwd", "/%", "/%zz", "/%u002e"}) {
    const std::string answer = Ask(served.port(), path);
    EXPECT_EQ(StatusOf(answer), 404) << path << answer;
    EXPECT_FALSE(Has(answer, "root:")) << path;
  }
}

TEST(WebRequests, MayNotHaveHugeOrEndlessHeads) {
  const ServedSite served;
  const std::string begin = "GET / HTTP/1.1\r\nHost: localhost\r\n";
  EXPECT_EQ(StatusOf(Exchange(served.port(), GetText("/" + std::string(10'000, 'a')))), 414);
  EXPECT_EQ(StatusOf(Exchange(served.port(), std::string(5'000'000, 'a'))), 414);
  EXPECT_EQ(
      StatusOf(Exchange(served.port(), begin + "A: " + std::string(100'000, 'b') + "\r\n\r\n")),
      431);
  std::string many = begin;
  for (int i = 0; i < 200; ++i) many += "A" + std::to_string(i) + ": b\r\n";
  EXPECT_EQ(StatusOf(Exchange(served.port(), many + "\r\n")), 431);
  std::string endless = begin;
  while (endless.size() < 5'000'000) endless += "Abc: def\r\n";
  EXPECT_EQ(StatusOf(Exchange(served.port(), endless)), 431);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 200);
}

TEST(WebRequests, MayNotHaveLargeBodies) {
  ServedSite served({.allow_commands = true, .token = kTestToken});
  const std::string headers =
      std::string("Content-Type: application/json\r\nX-Shoal-Token: ") + kTestToken + "\r\n";
  EXPECT_EQ(StatusOf(Exchange(served.port(), PostText(std::string(65'537, ' '), headers))), 413);
  EXPECT_EQ(StatusOf(Exchange(served.port(), PostText(std::string(5'000'000, ' '), headers))), 413);
  const std::string command = R"({"target": "alpha", "words": ["deploy"]})";
  EXPECT_EQ(served.num_commands(), 0);
  EXPECT_EQ(
      StatusOf(Exchange(served.port(), PostText(std::string(65'000, ' ') + command, headers))),
      200);
  EXPECT_EQ(served.num_commands(), 1);
}

TEST(WebRequests, WhoseBodyNeverComesAreNotWaitedForLong) {
  ServedSite served({.allow_commands = true, .token = kTestToken});
  const std::string head =
      std::string(
          "POST /api/command HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100\r\n"
          "Content-Type: application/json\r\nX-Shoal-Token: ") +
      kTestToken + "\r\n\r\n{";
  EXPECT_EQ(StatusOf(Exchange(served.port(), head)), 400);
  EXPECT_EQ(served.num_commands(), 0);
}

TEST(WebRequests, ThatDripAreCutOff) {
  const ServedSite served;
  const std::string text = GetText("/", "A: " + std::string(10'000, 'b') + "\r\n");
  TcpClient client(served.port());
  const double begin_s = SecondsNow();
  size_t sent = 0;
  EXPECT_TRUE(Await([&] {
    if (sent < text.size()) sent += client.Send(text.substr(sent, 1));
    client.Receive();
    return client.has_ended();
  }));
  EXPECT_LT(sent, text.size());
  EXPECT_GE(SecondsNow() - begin_s, 2.5);
  EXPECT_EQ(StatusOf(client.received()), 408) << client.received();
}

}  // namespace shoal::web_requests_test
