// What clients of a line server can rely on, and what they cannot do to it or to each other.
#include "lib/mission/netsim/line_server.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <deque>

#include "lib/bus/os/wait_set.h"
#include "tests/netsim/served_clients.h"

namespace shoal::line_server_test {

constexpr int64_t kSecond_us = 1'000'000;

/// Answers "x" with "<x>\n", and "big" with 100 bytes.
class EchoServer : public testing::Test {
 protected:
  void Listen(const TcpServerOptions& options = {}, size_t max_line_bytes = 1000) {
    server_ = ListenOrFail(options, max_line_bytes, [this](const auto& address, auto line) {
      last_address_ = address;
      ++num_lines_;
      if (line == "big") return std::string(99, '.') + "\n";
      return line.empty() ? std::string() : "<" + std::string(line) + ">\n";
    });
    ASSERT_NE(server_, nullptr);
  }
  TcpClient& Connect(const std::string& address = "127.0.0.1", int source_port = 0) {
    clients_.emplace_back(server_->port(), address, source_port);
    EXPECT_TRUE(clients_.back().is_open());
    return clients_.back();
  }
  std::string All(TcpClient& client) { return ReceiveAll(server_.get(), now_us_, &client); }
  bool Until(const std::function<bool()>& is_done) {
    return ServeUntil(server_.get(), now_us_, is_done);
  }
  bool UntilClients(size_t number) {
    return Until([&] { return server_->num_clients() == number; });
  }
  bool IsAnswered(TcpClient& client, const std::string& word = "hi") {
    const std::string answer = "<" + word + ">\n";
    client.Send(word + "\n");
    return ReceiveBytes(server_.get(), now_us_, &client,
                        client.received().size() + answer.size()) &&
           client.received().ends_with(answer);
  }

  std::unique_ptr<LineServer> server_;
  std::deque<TcpClient> clients_;
  std::string last_address_;
  int num_lines_ = 0;
  int64_t now_us_ = 0;
};

TEST_F(EchoServer, AnswersInOrder) {
  Listen();
  TcpClient& client = Connect();
  client.Send("a\nb\n\nc\r\nd");
  EXPECT_EQ(All(client), "<a>\n<b>\n<c>\n");
}

TEST_F(EchoServer, AnswersALineInPieces) {
  Listen();
  TcpClient& client = Connect();
  for (const char letter : std::string("abc\nd\n")) {
    client.Send(std::string(1, letter));
    server_->Serve(now_us_);
  }
  EXPECT_EQ(All(client), "<abc>\n<d>\n");
}

TEST_F(EchoServer, AnswersAClientThatHasClosedItsSide) {
  Listen();
  TcpClient& client = Connect();
  client.Send("a\nhalf");
  EXPECT_EQ(All(client), "<a>\n");
  EXPECT_TRUE(UntilClients(0));
  EXPECT_EQ(num_lines_, 1);
}

TEST_F(EchoServer, HandlesTheLastLineOfAClientThatHasGone) {
  Listen();
  TcpClient& client = Connect();
  client.Send("a\n");
  client.Close();
  EXPECT_TRUE(Until([&] { return num_lines_ == 1; }));
  EXPECT_TRUE(UntilClients(0));
}

TEST_F(EchoServer, KnowsWhereAClientIs) {
  Listen();
  EXPECT_TRUE(IsAnswered(Connect("127.0.0.2")));
  EXPECT_EQ(last_address_, "127.0.0.2");
}

TEST_F(EchoServer, SurvivesResetsBeforeItAccepts) {
  Listen();
  for (int i = 0; i < 20; ++i) Connect().Reset();
  EXPECT_TRUE(IsAnswered(Connect()));
  EXPECT_TRUE(UntilClients(1));
}

TEST_F(EchoServer, SurvivesResetsAfterItHasAccepted) {
  Listen();
  for (int i = 0; i < 20; ++i) Connect().Send("begun");
  EXPECT_TRUE(UntilClients(20));
  for (TcpClient& client : clients_) client.Reset();
  EXPECT_TRUE(UntilClients(0));
  EXPECT_EQ(server_->counts().broken, 20);
  EXPECT_EQ(server_->num_waiting_bytes(), 0U);
}

TEST_F(EchoServer, AnswersAClientThatComesAgainFromTheSamePort) {
  Listen();
  TcpClient& first = Connect();
  const int source_port = first.source_port();
  EXPECT_TRUE(IsAnswered(first));
  for (int i = 0; i < 3; ++i) {
    clients_.back().Reset();
    EXPECT_TRUE(IsAnswered(Connect("127.0.0.1", source_port), "again"));
  }
}

TEST_F(EchoServer, RefusesMoreThanItMayHave) {
  Listen({.max_connections = 2});
  Connect();
  Connect();
  EXPECT_TRUE(UntilClients(2));
  TcpClient& third = Connect();
  EXPECT_EQ(All(third), "");
  EXPECT_EQ(server_->counts().refused, 1);
  EXPECT_TRUE(IsAnswered(clients_[0]));
  clients_[1].Close();
  EXPECT_TRUE(UntilClients(1));
  EXPECT_TRUE(IsAnswered(Connect()));
}

TEST_F(EchoServer, GivesTheLongestSilentClientsPlaceToAFurtherOne) {
  Listen({.max_connections = 3, .silence_us = 10 * kSecond_us});
  TcpClient& active = Connect();
  TcpClient& never_sent = Connect();
  TcpClient& sent_once = Connect();
  EXPECT_TRUE(UntilClients(3));
  EXPECT_TRUE(IsAnswered(active));
  EXPECT_TRUE(IsAnswered(sent_once));
  now_us_ += kSecond_us;
  TcpClient& fourth = Connect();
  EXPECT_TRUE(Until([&] {
    never_sent.Receive();
    return never_sent.has_ended();
  })) << "it has sent nothing at all";
  EXPECT_TRUE(IsAnswered(fourth));
  now_us_ += 10 * kSecond_us;
  EXPECT_TRUE(IsAnswered(active));
  TcpClient& fifth = Connect();
  EXPECT_TRUE(Until([&] {
    sent_once.Receive();
    return sent_once.has_ended();
  })) << "silent for 11 s, longer than the fourth";
  EXPECT_TRUE(IsAnswered(fifth));
  EXPECT_TRUE(IsAnswered(fourth));
  EXPECT_TRUE(IsAnswered(active));
  TcpClient& sixth = Connect();
  EXPECT_TRUE(Until([&] {
    sixth.Receive();
    return sixth.has_ended();
  })) << "no client is silent";
  EXPECT_EQ(server_->counts().displaced, 2);
  EXPECT_EQ(server_->counts().refused, 1);
}

TEST_F(EchoServer, SkipsALineThatIsTooLong) {
  Listen({}, 1000);
  TcpClient& client = Connect();
  client.Send(std::string(2'000, 'x') + "\na\n");
  EXPECT_EQ(All(client), "<a>\n");
  EXPECT_EQ(server_->num_too_long(), 1);
}

TEST_F(EchoServer, KeepsNoMoreThanALineOfAClientThatNeverEndsOne) {
  Listen({}, 1000);
  TcpClient& client = Connect();
  for (int i = 0; i < 100; ++i) {
    client.Send(std::string(10'000, 'x'));
    server_->Serve(now_us_);
    EXPECT_LE(server_->num_waiting_bytes(), 2'000U);
  }
  EXPECT_TRUE(IsAnswered(Connect()));
}

TEST_F(EchoServer, ForgetsAClientThatSendsNothing) {
  Listen({.idle_timeout_us = 10 * kSecond_us});
  TcpClient& client = Connect();
  EXPECT_TRUE(IsAnswered(client));
  now_us_ = 10 * kSecond_us;
  EXPECT_TRUE(IsAnswered(client));
  now_us_ = 20 * kSecond_us;
  server_->Serve(now_us_);
  EXPECT_EQ(server_->num_clients(), 1U);
  server_->Serve(++now_us_);
  EXPECT_EQ(server_->num_clients(), 0U);
  EXPECT_EQ(server_->counts().idle, 1);
}

TEST_F(EchoServer, HasPatienceWithoutEndIfThatIsAskedFor) {
  Listen();
  TcpClient& client = Connect();
  EXPECT_TRUE(UntilClients(1));
  now_us_ = 1'000'000 * kSecond_us;
  EXPECT_TRUE(IsAnswered(client));
}

/// Returns `line` again and again: as much as fits a send.
std::string Repeated(const std::string& line) {
  std::string lines;
  while (lines.size() < 60'000) lines += line;
  return lines;
}

/// Sends and never reads, until the server is full and nothing moves any more; returns how
/// much was sent.
size_t Stall(LineServer* server, TcpClient* client, const std::string& lines,
             size_t num_waiting_bytes) {
  size_t num_sent = 0;
  for (int num_refused = 0, turn = 0; num_refused < 20 && turn < 10'000; ++turn) {
    const size_t size = client->Send(std::string_view(lines).substr(num_sent % lines.size()));
    num_sent += size;
    const bool is_held = size == 0 && server->num_waiting_bytes() > num_waiting_bytes;
    num_refused = is_held ? num_refused + 1 : 0;
    server->Serve(0);
  }
  EXPECT_GT(server->num_waiting_bytes(), num_waiting_bytes);
  return num_sent;
}

TEST_F(EchoServer, HoldsBackAClientThatDoesNotReadThenClosesIt) {
  Listen({.max_unsent_bytes = 2 * 1024 * 1024, .stall_timeout_us = 10 * kSecond_us});
  TcpClient& client = Connect();
  Stall(server_.get(), &client, Repeated("big\n"), 1024 * 1024);
  EXPECT_EQ(server_->num_clients(), 1U);
  EXPECT_LT(server_->num_waiting_bytes(), 4U * 1024 * 1024);
  EXPECT_TRUE(IsAnswered(Connect()));
  now_us_ = 10 * kSecond_us + 1;
  server_->Serve(now_us_);
  EXPECT_EQ(server_->num_clients(), 1U);
  EXPECT_EQ(server_->counts().stalled, 1);
}

TEST_F(EchoServer, AnswersEverythingOnceAStalledClientReads) {
  Listen({.max_unsent_bytes = 256 * 1024});
  TcpClient& client = Connect();
  const std::string request = std::string(900, 'x') + "\n";
  const size_t num_sent = Stall(server_.get(), &client, Repeated(request), 128 * 1024);
  EXPECT_LT(server_->num_waiting_bytes(), 512U * 1024);
  EXPECT_GT(num_sent, 300'000U);
  EXPECT_EQ(All(client).size(), num_sent / request.size() * (request.size() + 2));
  EXPECT_EQ(server_->counts().stalled, 0);
}

TEST_F(EchoServer, OwesAClientThatHasClosedItsSideWhatTheKernelDoesNotTakeYet) {
  Listen({.max_unsent_bytes = 128 * 1024 * 1024});
  TcpClient& client = Connect();
  const std::string lines = Repeated("big\n");
  size_t num_sent = 0;
  while (server_->num_waiting_bytes() < 1024 * 1024) {
    num_sent += client.Send(std::string_view(lines).substr(num_sent % 4));
    server_->Serve(now_us_);
  }
  client.CloseOwnSide();
  EXPECT_TRUE(Until([&] { return num_lines_ == static_cast<int>(num_sent / 4); }));
  server_->Serve(now_us_);  // Now it knows that there is no more.
  EXPECT_GT(server_->num_waiting_bytes(), 0U);
  EXPECT_EQ(All(client).size(), num_sent / 4 * 100);
}

TEST_F(EchoServer, ClosesAClientThatIsOwedMoreThanMayWait) {
  Listen({.max_unsent_bytes = 5'000});
  // The kernel's own buffers take some megabytes first.
  TcpClient& client = Connect();
  const std::string lines = Repeated("big\n");
  EXPECT_TRUE(Until([&] {
    client.Send(lines);
    return server_->counts().stalled == 1;
  }));
  EXPECT_EQ(server_->num_clients(), 0U);
  EXPECT_EQ(server_->num_waiting_bytes(), 0U);
}

TEST_F(EchoServer, IsWaitedForTogetherWithOthers) {
  Listen();
  WaitSet both;
  ASSERT_TRUE(both.Add(server_->fd()));
  ASSERT_FALSE(both.Add(-1));
  pollfd waited{.fd = both.fd(), .events = POLLIN, .revents = 0};
  EXPECT_EQ(poll(&waited, 1, 0), 0);
  TcpClient& client = Connect();
  EXPECT_EQ(poll(&waited, 1, 1000), 1);
  EXPECT_TRUE(IsAnswered(client));
  EXPECT_EQ(poll(&waited, 1, 0), 0);
}

TEST_F(EchoServer, ReportsWhyItCannotListen) {
  Listen();
  const auto second = LineServer::Listen({.port = server_->port()}, 1000, {});
  ASSERT_FALSE(second.ok());
  EXPECT_NE(second.error().find("127.0.0.1:" + std::to_string(server_->port())), std::string::npos);
  EXPECT_NE(second.error().find("end it, or choose another port"), std::string::npos);
  EXPECT_FALSE(LineServer::Listen({.address = "localhost"}, 1000, {}).ok());
  EXPECT_FALSE(LineServer::Listen({.address = "192.0.2.1"}, 1000, {}).ok());
}

}  // namespace shoal::line_server_test
