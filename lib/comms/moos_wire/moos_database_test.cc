// The MOOSDB that shoal plays, by what it sends.
#include "lib/comms/moos_wire/moos_database.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "lib/comms/moos_wire/moos_session.h"
#include "tests/golden/read_golden.h"

namespace shoal::moos_database_test {

constexpr int64_t kSecond_us = 1'000'000;
constexpr double kStart_s = 7.18e9;  // At warp 4.

/// A database and what it has sent to each client.
struct Server {
  MoosNow NowAt(double wall_s) const {
    return {.wall_us = static_cast<int64_t>(wall_s * 1e6), .time_s = kStart_s + 4 * wall_s};
  }
  void Settle(double wall_s) {
    for (const MoosOutput& each : database.TakeOutput()) {
      sent[each.client] += each.bytes;
      if (!each.closes) continue;
      closed[each.client] = true;
      database.OnClose(each.client, NowAt(wall_s));
    }
    for (const std::string& each : database.TakeEvents()) events += each + "\n";
  }
  void Bytes(MoosClientId id, std::string_view bytes, double wall_s = 0) {
    database.OnBytes(id, bytes, NowAt(wall_s));
    Settle(wall_s);
  }
  void Send(MoosClientId id, const std::vector<MoosMessage>& messages, double wall_s = 0) {
    std::string bytes;
    AppendMoosPacket(messages, &bytes);
    Bytes(id, bytes, wall_s);
  }
  void Join(MoosClientId id, const std::string& name, double wall_s = 0) {
    database.OnConnect(id, NowAt(wall_s));
    Bytes(id, MoosGreeting(), wall_s);
    Send(id,
         {{.type = 'i', .data_type = 'S', .key = "asynchronous", .time_s = kStart_s, .text = name}},
         wall_s);
  }
  void Advance(double wall_s) {
    database.Advance(NowAt(wall_s));
    Settle(wall_s);
  }
  std::vector<MoosMessage> Received(MoosClientId id) {
    std::vector<MoosMessage> read;
    MoosPacketReader reader;
    reader.Take(sent[id], [&](auto all) { read.insert(read.end(), all.begin(), all.end()); });
    EXPECT_EQ(reader.problem(), "");
    sent[id].clear();
    return read;
  }
  MoosDatabase database{{.community = "gold", .host = "lab", .own_name = "shoal"}};
  std::map<MoosClientId, std::string> sent;
  std::map<MoosClientId, bool> closed;
  std::string events;
};

MoosMessage RegisterFor(const std::string& key) {
  return {.type = 'R', .source = "x", .key = key, .value = 0};
}

TEST(MoosDatabase, WelcomesAClientWithItsCommunityHostAndSkew) {
  Server server;
  server.Join(1, "uXMS", 0.5);
  const std::vector<MoosMessage> received = server.Received(1);
  ASSERT_EQ(received.size(), 1U);
  EXPECT_EQ(received[0].type, 'W');
  EXPECT_EQ(received[0].community, "gold");
  EXPECT_EQ(received[0].source_aux, "hostname=lab");
  EXPECT_EQ(received[0].text, "asynchronous");
  EXPECT_EQ(received[0].value, 2) << "the server's time less the client's";
}

TEST(MoosDatabase, RefusesANameThatIsTakenAsTheRealOneDoes) {
  Server server;
  server.Join(1, "uXMS");
  server.Join(2, "uXMS");
  server.Join(3, "shoal");
  const std::vector<MoosMessage> received = server.Received(2);
  ASSERT_EQ(received.size(), 1U);
  EXPECT_EQ(received[0].type, 'K');
  EXPECT_EQ(received[0].text, "A client of this name (\"uXMS\") already exists");
  EXPECT_TRUE(server.closed[2]);
  EXPECT_TRUE(server.closed[3]) << "its own name";
  EXPECT_EQ(server.database.counts().refused, 2);
  server.database.OnClose(1, server.NowAt(1));
  server.Join(4, "uXMS", 1);
  EXPECT_FALSE(server.closed[4]);
}

TEST(MoosDatabase, ServesOthersWhileAConnectionDoesNotIntroduceItself) {
  Server server;
  server.database.OnConnect(1, server.NowAt(0));
  server.Bytes(1, "ELKS");
  server.Join(2, "uXMS");
  EXPECT_EQ(server.Received(2).size(), 1U);
  server.Advance(4.9);
  EXPECT_FALSE(server.closed[1]);
  server.Advance(5);
  EXPECT_TRUE(server.closed[1]);
  EXPECT_EQ(server.database.counts().silent, 2) << "uXMS, too, was silent for 5 s";
}

TEST(MoosDatabase, ClosesWhatIsNotMoos) {
  Server server;
  server.database.OnConnect(1, server.NowAt(0));
  server.Bytes(1, "GET / HTTP/1.1\r\nHost: 127.0.0.1:9001\r\n\r\n");
  EXPECT_TRUE(server.closed[1]);
  server.Join(2, "x\x1b[2J");
  server.Bytes(2, std::string("\xff\xff\xff\x7f\1\0\0\0\0", 9));
  EXPECT_TRUE(server.closed[2]);
  EXPECT_EQ(server.database.counts().broken, 2);
  EXPECT_EQ(server.events.find('\x1b'), std::string::npos);
  EXPECT_NE(
      server.events.find("client 'x?[2J' was closed: a packet states a length of 2147483647 "),
      std::string::npos)
      << server.events;
}

TEST(MoosDatabase, AnswersTimingFirstInThePacketAndEachRegistrationWithThePresentValue) {
  Server server;
  server.Join(1, "uXMS");
  server.database.Write("NAV_X", 3.5, server.NowAt(0));
  (void)server.Received(1);
  server.Send(1, {RegisterFor("NAV_X"),
                  RegisterFor("NONE"),
                  {.type = 'T', .key = "_async_timing", .time_s = kStart_s, .value = 0}});
  const std::vector<MoosMessage> received = server.Received(1);
  ASSERT_EQ(received.size(), 2U);
  EXPECT_EQ(received[0].type, 'T');
  EXPECT_EQ(received[0].time_s, kStart_s) << "as the client sent it";
  EXPECT_EQ(received[0].value, kStart_s);
  EXPECT_EQ(received[0].value2, 0);
  EXPECT_EQ(received[1].value, 3.5);
  EXPECT_EQ(received[1].id, -1);
  EXPECT_EQ(received[1].source, "shoal");
  EXPECT_EQ(received[1].community, "gold");
}

TEST(MoosDatabase, PassesOnANotifyWithTheSendersIdAndAddsItsCommunity) {
  Server server;
  server.Join(1, "writer");
  server.Join(2, "reader");
  server.Send(2, {RegisterFor("X")});
  (void)server.Received(2);
  MoosMessage notify = MoosNotify("writer", "X", std::string_view("a"));
  notify.id = 7;
  server.Send(1, {notify});
  notify.community = "elsewhere";
  server.Send(1, {notify});
  const std::vector<MoosMessage> received = server.Received(2);
  ASSERT_EQ(received.size(), 2U) << "at once: no mail is held";
  EXPECT_EQ(received[0].id, 7);
  EXPECT_EQ(received[0].community, "gold");
  EXPECT_EQ(received[1].community, "elsewhere") << "a value from another community keeps its name";
  EXPECT_EQ(server.database.TakeMail().size(), 2U);
}

TEST(MoosDatabase, WritesDbTimeUptimeAndClientsEachTwoSecondsOfMoosTime) {
  Server server;
  server.Advance(0);
  server.Join(1, "uPokeDB");
  server.Send(1, {RegisterFor("DB_UPTIME"),
                  RegisterFor("DB_CLIENTS"),
                  RegisterFor("DB_EVENT"),
                  {.type = 'T', .key = "_async_timing", .value = 0}});
  (void)server.Received(1);
  server.Advance(0.4);
  EXPECT_EQ(server.Received(1).size(), 0U) << "1.6 s of MOOS time";
  server.Join(2, "uXMS", 0.45);
  server.Advance(1);
  std::string seen;
  for (const MoosMessage& each : server.Received(1)) {
    seen += each.key + "=" + (each.IsDouble() ? std::to_string(each.value) : each.text) + " ";
  }
  EXPECT_EQ(seen,
            "DB_EVENT=connected=uXMS DB_UPTIME=1.800000 DB_CLIENTS=shoal,uPokeDB,uXMS, "
            "DB_UPTIME=4.000000 DB_CLIENTS=shoal,uPokeDB,uXMS, ");
}

TEST(MoosDatabase, ClosesAClientThatAsksForMoreThanItCanTake) {
  Server server;
  server.Join(1, "greedy");
  server.database.Write("BIG", std::string(1 << 20, 'x'), server.NowAt(0));
  server.Send(1, std::vector<MoosMessage>(1000, RegisterFor("BIG")));
  EXPECT_TRUE(server.closed[1]);
  EXPECT_EQ(server.database.counts().slow, 1);
}

TEST(MoosDatabase, TakesRegistrationsWithoutEndWithinItsBounds) {
  Server server;
  server.Join(1, "greedy");
  int number = 0;
  for (int packet = 0; packet < 10; ++packet) {
    std::vector<MoosMessage> messages;
    for (int i = 0; i < 5'000; ++i) {
      messages.push_back(RegisterFor("V" + std::to_string(number++)));
    }
    server.Send(1, messages);
  }
  EXPECT_LE(server.database.variables().num_subscriptions(), MoosLimits().max_variables);
  EXPECT_GT(server.database.variables().counts().beyond, 25'000);
  server.Join(2, "uXMS");
  EXPECT_EQ(server.Received(2).size(), 1U) << "others are served";
}

/// The types of what a recorded server sent, without timing, and of what this one sends for the
/// recorded client's bytes.
std::string KindsOf(std::string_view bytes) {
  std::string kinds;
  MoosPacketReader reader;
  reader.Take(bytes, [&](auto messages) {
    for (const MoosMessage& each : messages) kinds += each.type == 'N' ? '\0' : each.type;
  });
  std::erase(kinds, '\0');
  return kinds;
}

TEST(MoosDatabase, AnswersRecordedClientsWithTheSameKindsInTheSameOrder) {
  for (const std::string name :
       {"join", "register", "notify", "wildcard", "split", "many", "uPokeDB", "uXMS", "umm",
        "held-mail", "delay", "silence", "pNodeReporter-csp", "uSimMarine"}) {
    SCOPED_TRACE(name);
    Server server;
    server.database.OnConnect(1, server.NowAt(0));
    server.Bytes(1, ReadGoldenText("moos/" + name + ".client.bin").value());
    const std::string ours = KindsOf(server.sent[1]);
    const std::string theirs = KindsOf(ReadGoldenText("moos/" + name + ".server.bin").value());
    EXPECT_EQ(ours.substr(0, 1), "W");
    EXPECT_EQ(theirs.substr(0, 1), "W");
    const std::string client = ReadGoldenText("moos/" + name + ".client.bin").value().substr(32);
    const std::string asked = KindsOf(client);
    EXPECT_EQ(std::count(ours.begin(), ours.end(), 'T'),
              std::count(asked.begin(), asked.end(), 'T'))
        << "each timing is answered";
    EXPECT_FALSE(server.closed[1]);
  }
}

TEST(MoosDatabase, AndSessionUnderstandEachOther) {
  Server server;
  MoosSession session({.name = "shoal_beta", .warp = 4, .host = "lab"});
  const auto utc_us = static_cast<int64_t>(kStart_s / 4 * 1e6);
  session.Register("X", 0);
  server.database.OnConnect(1, server.NowAt(0));
  server.Bytes(1, session.Connect(0, utc_us));
  session.Take(server.sent[1], 0, utc_us);
  ASSERT_EQ(session.state(), MoosSession::State::kJoined);
  EXPECT_NEAR(*session.warp_of_server(), 4, 1e-6);
  session.Notify("X", 5, utc_us);
  server.sent[1].clear();
  server.Bytes(1, session.Flush(0, utc_us));
  session.Take(server.sent[1], 0, utc_us);
  const std::vector<MoosMessage> mail = session.TakeMail();
  ASSERT_EQ(mail.size(), 1U) << "a subscriber gets its own notifies back";
  EXPECT_EQ(mail[0].value, 5);
}

}  // namespace shoal::moos_database_test
