// Streams of frames to many clients at once.
#include <gtest/gtest.h>

#include <optional>

#include "tests/missions/fair_stopwatch.h"
#include "tests/viewer/served_site.h"

namespace shoal::web_streams_test {

/// Publishes numbered frames, 50 per second, until it goes.
class Frames {
 public:
  /// Each frame is as long as one of a large mission.
  explicit Frames(EventHub& hub)
      : thread_([this, &hub] {
          for (int i = 0; !done_; ++i) {
            if (hub.num_readers() > 0) {
              hub.Publish("{\"n\":" + std::to_string(i) + ",\"more\":\"" +
                          std::string(20'000, 'x') + "\"}");
            }
            ++num_frames_;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
          }
        }) {}
  ~Frames() {
    done_ = true;
    thread_.join();
  }
  int number() const { return num_frames_; }

 private:
  std::atomic<bool> done_ = false;
  std::atomic<int> num_frames_ = 0;
  std::thread thread_;
};

/// The number of the last frame that has come whole; -1: none.
int LastFrame(const std::string& received) {
  const size_t end = received.rfind("\"}\n\n");
  const size_t begin = received.rfind("data: {\"n\":", end);
  if (end == std::string::npos || begin == std::string::npos) return -1;
  return std::atoi(received.c_str() + begin + 11);
}

TEST(WebStreams, StayLiveWhileOneDoesNotRead) {
  ServedSite served;
  const Frames frames(served.hub());
  TcpClient mute(served.port());
  mute.Send(GetText("/api/stream"));
  std::vector<std::unique_ptr<TcpClient>> clients;
  for (int i = 0; i < 12; ++i) {
    clients.push_back(std::make_unique<TcpClient>(served.port()));
    clients.back()->Send(GetText("/api/stream"));
  }
  ASSERT_TRUE(Await([&] { return served.hub().num_readers() == 13; }));
  // All receive frames until the client that does not read has been cut, and after that.
  ASSERT_TRUE(Await([&] {
    for (const auto& client : clients) client->Receive();
    return served.hub().num_readers() == 12;
  }));
  const int now = frames.number();
  EXPECT_TRUE(Await([&] {
    bool all = true;
    for (const auto& client : clients) {
      client->Receive();
      all = all && LastFrame(client->received()) >= now;
    }
    return all;
  }));
  for (const auto& client : clients) EXPECT_FALSE(client->has_ended());
}

TEST(WebStreams, BeginWithHeadersThatAStreamHas) {
  ServedSite served;
  TcpClient client(served.port());
  client.Send(GetText("/api/stream"));
  ASSERT_TRUE(Await([&] {
    client.Receive();
    return client.received().find("\r\n\r\nretry: 1000\n\n") != std::string::npos;
  })) << client.received();
  EXPECT_EQ(StatusOf(client.received()), 200);
  EXPECT_NE(client.received().find("Content-Type: text/event-stream\r\n"), std::string::npos);
  EXPECT_NE(client.received().find("Cache-Control: no-store\r\n"), std::string::npos);
}

TEST(WebStreams, SendHeartbeatsWhereThereIsNoNews) {
  ServedSite served;
  TcpClient client(served.port());
  client.Send(GetText("/api/stream"));
  EXPECT_TRUE(Await([&] {
    client.Receive();
    return client.received().find(":\n\n:\n\n:\n\n") != std::string::npos;
  })) << client.received();
}

TEST(WebStreams, EndWhenTheirClientsLeave) {
  ServedSite served;
  const Frames frames(served.hub());
  std::vector<std::unique_ptr<TcpClient>> clients;
  for (int i = 0; i < 6; ++i) {
    clients.push_back(std::make_unique<TcpClient>(served.port()));
    clients.back()->Send(GetText("/api/stream"));
  }
  ASSERT_TRUE(Await([&] { return served.hub().num_readers() == 6; }));
  clients[0]->Close();
  clients[1]->Reset();
  clients[2]->CloseOwnSide();
  EXPECT_TRUE(Await([&] { return served.hub().num_readers() == 3; }));
}

TEST(WebStreams, EndWhereAnotherMissionBegins) {
  ServedSite served;
  TcpClient client(served.port());
  client.Send(GetText("/api/stream"));
  ASSERT_TRUE(Await([&] { return served.hub().num_readers() == 1; }));
  served.hub().EndStreams();
  EXPECT_TRUE(Await([&] {
    client.Receive();
    return client.has_ended();
  }));
  TcpClient again(served.port());
  again.Send(GetText("/api/stream"));
  EXPECT_TRUE(Await([&] { return served.hub().num_readers() == 1; }));
}

TEST(WebStreams, AreLimitedSoThatRequestsFindRoom) {
  WebServerOptions options = ServedSite::Hasty();
  options.most_streams = 3;
  ServedSite served({}, options);
  std::vector<std::unique_ptr<TcpClient>> clients;
  for (int i = 0; i < 3; ++i) {
    clients.push_back(std::make_unique<TcpClient>(served.port()));
    clients.back()->Send(GetText("/api/stream"));
  }
  ASSERT_TRUE(Await([&] { return served.hub().num_readers() == 3; }));
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/stream")), 503);
  EXPECT_EQ(StatusOf(Ask(served.port(), "/api/frame")), 200);
}

TEST(WebStreams, EndAtOnceWhenTheServerStops) {
  std::optional<FairStopwatch> since_stop;
  std::vector<std::unique_ptr<TcpClient>> clients;
  {
    ServedSite served;
    const Frames frames(served.hub());
    for (int i = 0; i < 10; ++i) {
      clients.push_back(std::make_unique<TcpClient>(served.port()));
      clients.back()->Send(GetText("/api/stream"));
    }
    ASSERT_TRUE(Await([&] { return served.hub().num_readers() == 10; }));
    since_stop.emplace();
  }
  EXPECT_LT(since_stop->Seconds(), 1);
}

TEST(WebStreams, OfAHeadRequestLeaveNoReader) {
  ServedSite served;
  const std::string answer =
      Exchange(served.port(), "HEAD /api/stream HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(StatusOf(answer), 200);
  EXPECT_TRUE(Await([&] { return served.hub().num_readers() == 0; }));
}

}  // namespace shoal::web_streams_test
