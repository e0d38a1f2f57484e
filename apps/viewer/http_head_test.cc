#include "apps/viewer/http_head.h"

#include <gtest/gtest.h>

namespace shoal::http_head_test {

std::string Head(const std::string& line, const std::string& headers = "Host: a\r\n") {
  return line + "\r\n" + headers + "\r\n";
}

int StatusOf(const std::string& bytes) { return CheckHead(bytes).status; }

TEST(HttpHead, KeepsWhatTheViewerKnowsAndDropsTheRest) {
  const CheckedHead checked = CheckHead(
      "GET /api/frame?t=1 HTTP/1.1\r\nHost: localhost:1\r\nRange: bytes=0-,0-\r\n"
      "Accept-Encoding: gzip, br\r\nExpect: 100-continue\r\nX-Shoal-Token:  abc \r\n\r\nrest");
  EXPECT_EQ(checked.status, 200);
  EXPECT_EQ(checked.head,
            "GET /api/frame?t=1 HTTP/1.1\r\nhost: localhost:1\r\nx-shoal-token: abc\r\n"
            "connection: Keep-Alive\r\n\r\n");
  EXPECT_TRUE(checked.keeps_alive);
}

TEST(HttpHead, CountsTheBytesThatItTakes) {
  const std::string head = Head("GET / HTTP/1.1");
  EXPECT_EQ(CheckHead(head + "more").size, head.size());
}

TEST(HttpHead, WaitsForTheEndHoweverItIsCut) {
  const std::string head = Head("GET / HTTP/1.1", "Host: a\r\nOrigin: b\r\n");
  for (size_t i = 0; i < head.size(); ++i) EXPECT_EQ(StatusOf(head.substr(0, i)), 0) << i;
  EXPECT_EQ(StatusOf(head), 200);
}

TEST(HttpHead, RefusesWhatIsNoRequest) {
  for (const char* line :
       {"", " ", "GET", "GET /", "GET  HTTP/1.1", "GET / HTTP/2.0", "GET / HTTP/1.1 ", "GET a b c",
        "GET http://evil.example/ HTTP/1.1", "GET * HTTP/1.1", "G\tT / HTTP/1.1",
        "GET /\n/ HTTP/1.1", "\x16\x03\x01 / HTTP/1.1"}) {
    EXPECT_EQ(StatusOf(Head(line)), 400) << line;
  }
}

TEST(HttpHead, HasThreeMethods) {
  EXPECT_EQ(StatusOf(Head("HEAD / HTTP/1.1")), 200);
  for (const char* method : {"OPTIONS", "PUT", "DELETE", "CONNECT", "TRACE", "PRI", "get"}) {
    EXPECT_EQ(StatusOf(Head(std::string(method) + " / HTTP/1.1")), 405) << method;
  }
}

TEST(HttpHead, RefusesAmbiguousHeaders) {
  for (const char* headers :
       {"Host: a\r\nHost: b\r\n", "Host : a\r\n", " Host: a\r\n", ": a\r\n", "Host\r\n",
        "Host: a\nOrigin: b\r\n", "Host: a\r\n folded\r\n",
        "Content-Length: 1\r\ncontent-length: 2\r\n", "Content-Length: -1\r\n",
        "Content-Length: 1x\r\n", "Content-Length: \r\n", "Content-Length: +1\r\n",
        "Transfer-Encoding: chunked\r\n", "Host: a\x01\r\n"}) {
    EXPECT_EQ(StatusOf(Head("GET / HTTP/1.1", headers)), 400) << headers;
  }
  EXPECT_EQ(StatusOf(Head("GET / HTTP/1.1", std::string("Host: a\0b\r\n", 11))), 400);
}

TEST(HttpHead, BoundsTheAddressTheHeadersAndTheBody) {
  EXPECT_EQ(StatusOf(Head("GET /" + std::string(kMaxTargetBytes, 'a') + " HTTP/1.1")), 414);
  EXPECT_EQ(StatusOf(std::string(kMaxHeadBytes, 'a')), 414);
  std::string many;
  for (size_t i = 0; i <= kMaxHeaders; ++i) many += "A: b\r\n";
  EXPECT_EQ(StatusOf(Head("GET / HTTP/1.1", many)), 431);
  EXPECT_EQ(StatusOf(Head("GET / HTTP/1.1", "A: " + std::string(kMaxHeadBytes, 'b') + "\r\n")),
            431);
  EXPECT_EQ(StatusOf(Head("GET / HTTP/1.1", "Host: " + std::string(2'000, 'b') + "\r\n")), 431);
  // Without an end, too.
  EXPECT_EQ(StatusOf("GET / HTTP/1.1\r\nA: " + std::string(kMaxHeadBytes, 'b')), 431);
  EXPECT_EQ(StatusOf(Head("POST / HTTP/1.1", "Content-Length: 65536\r\n")), 200);
  EXPECT_EQ(StatusOf(Head("POST / HTTP/1.1", "Content-Length: 65537\r\n")), 413);
  EXPECT_EQ(StatusOf(Head("POST / HTTP/1.1", "Content-Length: 99999999999999999999\r\n")), 413);
  EXPECT_EQ(StatusOf(Head("POST / HTTP/1.1")), 400);
}

TEST(HttpHead, EndsTheConnectionAfterStreamsBodiesAndWhereAsked) {
  EXPECT_FALSE(CheckHead(Head("GET /api/stream?token=x HTTP/1.1")).keeps_alive);
  EXPECT_FALSE(CheckHead(Head("POST /api/command HTTP/1.1", "Content-Length: 2\r\n")).keeps_alive);
  EXPECT_FALSE(CheckHead(Head("GET / HTTP/1.1", "Content-Length: 2\r\n")).keeps_alive);
  EXPECT_FALSE(CheckHead(Head("GET / HTTP/1.1", "Connection: close\r\n")).keeps_alive);
  EXPECT_FALSE(CheckHead(Head("GET / HTTP/1.0")).keeps_alive);
  EXPECT_TRUE(CheckHead(Head("GET / HTTP/1.0", "Connection: Keep-Alive\r\n")).keeps_alive);
  EXPECT_TRUE(CheckHead(Head("GET / HTTP/1.1", "Content-Length: 0\r\n")).keeps_alive);
}

}  // namespace shoal::http_head_test
