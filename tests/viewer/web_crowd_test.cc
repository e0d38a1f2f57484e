// Many clients that are slow, malformed or disconnected.
#include <gtest/gtest.h>

#include "tests/netsim/rude_clients.h"
#include "tests/viewer/served_site.h"

namespace shoal::web_crowd_test {

using Clients = std::vector<std::unique_ptr<TcpClient>>;

Clients Connect(int port, int number, const std::string& text) {
  Clients clients;
  for (int i = 0; i < number; ++i) {
    clients.push_back(std::make_unique<TcpClient>(port));
    EXPECT_TRUE(clients.back()->is_open()) << i;
    clients.back()->Send(text);
  }
  return clients;
}

TEST(WebCrowd, Of200ThatSendHalfARequestLeavesTheNextItsAnswer) {
  const ServedSite served;
  const Clients rude = Connect(served.port(), 200, "GET / HTTP/1.1\r\nHost: loc");
  EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 200);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/frame")), 200);
}

TEST(WebCrowd, ThatFillsAllPlacesMakesRoomForTheNext) {
  WebServerOptions options = ServedSite::Hasty();
  options.most_connections = 20;
  // No client is cut for being slow: what is tested is that room is made.
  options.patience.head = options.patience.idle = std::chrono::minutes(5);
  ServedSite served({}, options);
  const Clients rude = Connect(served.port(), 60, "GET / HTTP/1.1\r\n");
  for (int i = 0; i < 30; ++i) EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 200) << i;
  EXPECT_LE(served.server().num_connections(), 25U);
}

TEST(WebCrowd, OfStreamsThatFillsAllPlacesRefusesTheNext) {
  WebServerOptions options = ServedSite::Hasty();
  options.most_connections = 10;
  ServedSite served({}, options);
  const Clients watching = Connect(served.port(), 10, GetText("/api/stream"));
  ASSERT_TRUE(Await([&] { return served.hub().num_readers() == 10; }));
  EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 503);
  watching[0]->Close();
  EXPECT_TRUE(Await([&] { return StatusOf(Ask(served.port(), "/")) == 200; }));
}

TEST(WebCrowd, ThatReadsNothingIsCut) {
  ServedSite served;
  const Clients mute = Connect(served.port(), 20, GetText("/api/trails"));
  EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 200);
  EXPECT_TRUE(Await([&] { return served.server().num_connections() == 0; }, 60));
}

TEST(WebCrowd, OfRudeClientsLeavesNoDescriptorOpen) {
  const size_t before = NumDescriptors();
  {
    ServedSite served;
    const size_t with_server = NumDescriptors();
    {
      RudeClients crowd(served.port(), 60, 7, GetText("/api/frame"));
      for (int i = 0; i < 3'000; ++i) crowd.Act();
      EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 200);
    }
    EXPECT_TRUE(Await([&] { return NumDescriptors() == with_server; }))
        << NumDescriptors() << " of " << with_server;
    EXPECT_EQ(StatusOf(Ask(served.port(), "/")), 200);
  }
  EXPECT_EQ(NumDescriptors(), before);
}

TEST(WebPort, IsNotShared) {
  const ServedSite served;
  const auto taken = ListenOn({.port = served.port(), .last_port = served.port()});
  ASSERT_FALSE(taken.ok());
  EXPECT_NE(taken.error().find("is taken"), std::string::npos) << taken.error();
  EXPECT_NE(taken.error().find("--http"), std::string::npos) << taken.error();
  const auto next = ListenOn({.port = served.port(), .last_port = served.port() + 50});
  ASSERT_TRUE(next.ok()) << next.error();
  EXPECT_GT(next->port, served.port());
}

TEST(WebPort, IsShownAsAnAddressThatABrowserTakes) {
  EXPECT_EQ(PageUrl("127.0.0.1", 8765, "", "shore"), "http://127.0.0.1:8765/");
  EXPECT_EQ(PageUrl("0.0.0.0", 8765, "abc", "shore"), "http://shore:8765/?token=abc");
  EXPECT_EQ(PageUrl("::1", 80, "", "shore"), "http://[::1]:80/");
  EXPECT_TRUE(IsLoopback("127.0.0.2"));
  EXPECT_TRUE(IsLoopback("::1"));
  EXPECT_FALSE(IsLoopback("0.0.0.0"));
  EXPECT_FALSE(IsLoopback("192.168.1.1"));
  EXPECT_FALSE(ListenOn({.address = "no.such.host.invalid"}).ok());
  EXPECT_FALSE(ListenOn({.address = "203.0.113.1", .port = 0, .last_port = 0}).ok());
}

}  // namespace shoal::web_crowd_test
