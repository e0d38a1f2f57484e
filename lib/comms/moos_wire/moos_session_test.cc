// What a client of a MOOSDB must do, and what the captures in tests/golden/moos teach.
#include "lib/comms/moos_wire/moos_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace shoal::moos_session_test {

constexpr int64_t kUtc_us = 1'795'645'000'000'000;
constexpr int64_t kSecond_us = 1'000'000;
using State = MoosSession::State;

std::vector<MoosMessage> Read(std::string_view bytes) {
  std::vector<MoosMessage> read;
  MoosPacketReader reader;
  reader.Take(bytes, [&](auto packet) { read.insert(read.end(), packet.begin(), packet.end()); });
  EXPECT_EQ(reader.problem(), "");
  return read;
}

std::string PacketOf(const MoosMessage& message) {
  std::string bytes;
  AppendMoosPacket({&message, 1}, &bytes);
  return bytes;
}

std::string WelcomeOf(double skew_s, const std::string& host = "lab") {
  return PacketOf({.type = moos_type::kWelcome,
                   .source_aux = "hostname=" + host,
                   .community = "gold",
                   .value = skew_s,
                   .text = "asynchronous"});
}

std::string AnswerTo(const MoosMessage& timing, double server_s, double pause_s = 0) {
  MoosMessage answer = timing;
  answer.value = server_s;
  answer.value2 = pause_s;
  return PacketOf(answer);
}

std::vector<char> TypesOf(const std::vector<MoosMessage>& messages) {
  std::vector<char> types;
  for (const MoosMessage& each : messages) types.push_back(each.type);
  return types;
}

/// A session that has joined at 0, with its first timing sent and answered.
struct Joined {
  explicit Joined(double warp = 1, double skew_s = 0, const std::string& host = "lab")
      : session({.name = "shoal_alpha", .warp = warp, .host = "lab"}) {
    (void)session.Connect(0, kUtc_us);
    session.Take(WelcomeOf(skew_s, host), 0, kUtc_us);
  }
  std::vector<MoosMessage> FlushAt(int64_t wall_us) {
    std::vector<MoosMessage> sent = Read(session.Flush(wall_us, kUtc_us + wall_us));
    if (is_answering && !sent.empty() && sent[0].type == moos_type::kTiming) {
      session.Take(AnswerTo(sent[0], sent[0].time_s + offset_s, pause_s), wall_us,
                   kUtc_us + wall_us);
    }
    return sent;
  }
  MoosSession session;
  bool is_answering = true;
  double offset_s = 0;
  double pause_s = 0;
};

TEST(MoosSession, SendsTheNameOfTheProtocolAndItsOwnAtOnce) {
  MoosSession session({.name = "shoal_alpha", .warp = 4, .host = "lab"});
  const std::string bytes = session.Connect(0, kUtc_us);
  EXPECT_EQ(bytes.substr(0, 32), MoosGreeting()) << "a connection without keeps all others waiting";
  const std::vector<MoosMessage> messages = Read(std::string_view(bytes).substr(32));
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].type, 'i');
  EXPECT_EQ(messages[0].key, "asynchronous");
  EXPECT_EQ(messages[0].text, "shoal_alpha");
  EXPECT_EQ(messages[0].time_s, 4 * 1'795'645'000.0) << "the whole Unix time is warped";
  EXPECT_EQ(session.Flush(kSecond_us, kUtc_us), "") << "nothing before the welcome";
}

TEST(MoosSession, SubscribesInEachConnectionAnew) {
  MoosSession session({.name = "shoal_alpha", .warp = 1, .host = "lab"});
  session.Register("NAV_X", 0.5);
  session.RegisterPattern("VIEW_*", 0);
  for (int round = 0; round < 2; ++round) {
    (void)session.Connect(0, kUtc_us);
    session.Take(WelcomeOf(0), 0, kUtc_us);
    const std::vector<MoosMessage> sent = Read(session.Flush(0, kUtc_us));
    ASSERT_EQ(TypesOf(sent), (std::vector<char>{'T', 'R', '*'}));
    EXPECT_EQ(sent[1].key, "NAV_X");
    EXPECT_EQ(sent[1].value, 0.5);
    EXPECT_EQ(sent[1].source, "shoal_alpha") << "the MOOSDB enters it for the source";
    EXPECT_EQ(sent[2].key, "shoal_alpha");
    EXPECT_EQ(sent[2].text, "AppPattern=*,VarPattern=VIEW_*,Interval=0");
    EXPECT_EQ(sent[1].id, 2 * round) << "ids go on after a loss";
    session.Disconnect();
  }
  EXPECT_EQ(session.counts().joined, 2);
}

TEST(MoosSession, SendsTimingEachSecondSoThatFiveSecondsOfSilenceNeverCome) {
  Joined joined;
  int num_timings = 0;
  for (int64_t wall_us = 0; wall_us <= 10 * kSecond_us; wall_us += 50'000) {
    for (const MoosMessage& each : joined.FlushAt(wall_us)) {
      num_timings += each.type == moos_type::kTiming ? 1 : 0;
    }
  }
  EXPECT_EQ(num_timings, 11);
}

TEST(MoosSession, FetchesHeldMailWithANullMessageWhereItHasNothingElseToSend) {
  Joined joined;
  (void)joined.FlushAt(0);
  EXPECT_EQ(TypesOf(joined.FlushAt(50'000)), std::vector<char>());
  EXPECT_EQ(TypesOf(joined.FlushAt(100'000)), std::vector<char>({'.'}));
  joined.session.Notify("X", 1, kUtc_us);
  EXPECT_EQ(TypesOf(joined.FlushAt(200'000)), std::vector<char>({'N'})) << "a notify fetches, too";
  EXPECT_EQ(TypesOf(joined.FlushAt(250'000)), std::vector<char>());
}

TEST(MoosSession, IsDeafWithoutAnAnswerToTimingForThreeSeconds) {
  Joined joined;
  joined.is_answering = false;
  (void)joined.FlushAt(0);
  joined.session.Take(PacketOf(MoosNotify("other", "X", 1)), 2 * kSecond_us, kUtc_us);
  EXPECT_FALSE(joined.session.IsDeaf(3 * kSecond_us));
  EXPECT_TRUE(joined.session.IsDeaf(3 * kSecond_us + 1)) << "mail alone is no answer";
  joined.session.Disconnect();
  EXPECT_FALSE(joined.session.IsDeaf(9 * kSecond_us));
}

TEST(MoosSession, IsNotDeafWhereItWasItselfStoppedAndTheAnswerWaits) {
  Joined joined;
  joined.is_answering = false;
  const std::vector<MoosMessage> sent = joined.FlushAt(0);
  joined.session.Take(AnswerTo(sent[0], sent[0].time_s), 60 * kSecond_us, kUtc_us);
  EXPECT_FALSE(joined.session.IsDeaf(60 * kSecond_us));
}

TEST(MoosSession, IsDeafWhereNoWelcomeComes) {
  MoosSession session({.name = "shoal_alpha", .warp = 1, .host = "lab"});
  (void)session.Connect(0, kUtc_us);
  EXPECT_FALSE(session.IsDeaf(10 * kSecond_us));
  EXPECT_TRUE(session.IsDeaf(10 * kSecond_us + 1));
}

TEST(MoosSession, KeepsItsClockOnTheHostOfTheMoosdbAndTakesThatOfAnother) {
  Joined same(1, 50'000, "lab");
  EXPECT_EQ(same.session.Time_s(kUtc_us), 1'795'645'000.0);
  Joined other(1, 50'000, "ship");
  EXPECT_EQ(other.session.Time_s(kUtc_us), 1'795'695'000.0);
  other.session.Notify("X", 1, kUtc_us);
  const std::vector<MoosMessage> sent = other.FlushAt(0);
  EXPECT_EQ(sent[1].time_s, 1'795'695'000.0) << "what it writes has the community's time";
  EXPECT_EQ(sent[0].time_s, 1'795'645'000.0) << "timing has the bare clock's";
}

TEST(MoosSession, FollowsTheClockOfAnotherHostByATenthOfEachMeasurementButTheFirst) {
  Joined joined(1, 100, "ship");
  joined.offset_s = 200;
  (void)joined.FlushAt(0);
  EXPECT_EQ(joined.session.skew_s(), 100) << "the first answer comes with the welcome's delay";
  (void)joined.FlushAt(kSecond_us);
  EXPECT_NEAR(joined.session.skew_s(), 0.9 * 100 + 0.1 * 200, 1e-6);
}

TEST(MoosSession, FindsTheWarpOfTheMoosdbInTheSkewOfTheWelcome) {
  EXPECT_NEAR(*Joined(4, 0.1).session.warp_of_server(), 4, 1e-6);
  EXPECT_NEAR(*Joined(4, (10 - 4) * 1'795'645'000.0).session.warp_of_server(), 10, 1e-6);
}

TEST(MoosSession, PausesAfterEachPacketAsTheMoosdbAsksFor) {
  Joined joined;
  joined.pause_s = 0.04;
  (void)joined.FlushAt(0);
  joined.session.Notify("X", 1, kUtc_us);
  EXPECT_EQ(TypesOf(joined.FlushAt(1000)), std::vector<char>({'N'})) << "known from the answer on";
  joined.session.Notify("X", 2, kUtc_us);
  EXPECT_EQ(joined.FlushAt(40'999).size(), 0U);
  EXPECT_EQ(TypesOf(joined.FlushAt(41'000)), std::vector<char>({'N'}));
}

TEST(MoosSession, StatesARefusalAndWhatIsNotMoos) {
  MoosSession session({.name = "shoal_alpha", .warp = 1, .host = "lab"});
  (void)session.Connect(0, kUtc_us);
  MoosMessage poison = MoosNotify("", "", "taken \x1b[2J");
  poison.type = moos_type::kPoison;
  session.Take(PacketOf(poison), 0, kUtc_us);
  EXPECT_EQ(session.state(), State::kRefused);
  EXPECT_EQ(session.problem(), "it refuses the name 'shoal_alpha': taken ?[2J");
  session.Disconnect();
  (void)session.Connect(0, kUtc_us);
  EXPECT_EQ(session.problem(), "");
  session.Take("HTTP/1.1 400 Bad Request", 0, kUtc_us);
  EXPECT_TRUE(session.problem().starts_with("it sent what is not MOOS's: "));
}

TEST(MoosSession, SendsNothingBeforeItHasJoinedAndCountsIt) {
  MoosSession session({.name = "shoal_alpha", .warp = 1, .host = "lab"});
  session.Notify("X", 1, kUtc_us);
  (void)session.Connect(0, kUtc_us);
  session.Notify("X", 2, kUtc_us);
  session.Take(WelcomeOf(0), 0, kUtc_us);
  EXPECT_EQ(TypesOf(Read(session.Flush(0, kUtc_us))), std::vector<char>({'T'}));
  EXPECT_EQ(session.counts().discarded, 2);
}

TEST(MoosSession, KeepsABoundedNumberOfMessages) {
  Joined joined;
  for (size_t i = 0; i < MoosSession::kMaxWaiting + 5; ++i) joined.session.Notify("X", 1, kUtc_us);
  EXPECT_EQ(joined.session.counts().discarded, 5);
  std::string flood;
  const std::vector<MoosMessage> thousand(1000, MoosNotify("other", "X", 1));
  AppendMoosPacket(thousand, &flood);
  for (size_t i = 0; i < MoosSession::kMaxWaiting / 1000 + 1; ++i) {
    joined.session.Take(flood, 0, kUtc_us);
  }
  EXPECT_EQ(joined.session.TakeMail().size(), MoosSession::kMaxWaiting);
  EXPECT_EQ(joined.session.counts().discarded, 1005);
}

}  // namespace shoal::moos_session_test
