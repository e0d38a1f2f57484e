// Conversations of real programs of MOOS with a real MOOSDB (tests/golden/moos/README.md): the
// reader finds the messages that another reader found, and the writer gives the same bytes again.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lib/comms/moos_wire/moos_packet.h"
#include "lib/comms/moos_wire/moos_session.h"
#include "tests/golden/read_golden.h"

namespace shoal::moos_packet_golden_test {

struct Decoded {
  size_t num_packets = 0;
  std::vector<MoosMessage> messages;
  std::string again;
  std::string problem;
  size_t num_pending_bytes = 0;
};

Decoded Decode(std::string_view bytes, size_t piece) {
  Decoded decoded;
  MoosPacketReader reader;
  while (!bytes.empty()) {
    const size_t size = std::min(piece, bytes.size());
    reader.Take(bytes.substr(0, size), [&](std::span<const MoosMessage> messages) {
      ++decoded.num_packets;
      decoded.messages.insert(decoded.messages.end(), messages.begin(), messages.end());
      AppendMoosPacket(messages, &decoded.again);
    });
    bytes.remove_prefix(size);
  }
  decoded.problem = reader.problem();
  decoded.num_pending_bytes = reader.num_pending_bytes();
  return decoded;
}

/// "iS1 TD2": one message of type i with a string, two of type T with a double.
std::string KindsOf(const std::vector<MoosMessage>& messages) {
  std::string kinds;
  for (size_t i = 0; i < messages.size();) {
    size_t end = i;
    while (end < messages.size() && messages[end].type == messages[i].type &&
           messages[end].data_type == messages[i].data_type) {
      ++end;
    }
    if (!kinds.empty()) kinds += ' ';
    kinds += {messages[i].type, messages[i].data_type};
    kinds += std::to_string(end - i);
    i = end;
  }
  return kinds;
}

std::string BytesOf(const GoldenRow& row) {
  return ReadGoldenText("moos/" + row.at("name") + "." + row.at("side") + ".bin").value();
}

TEST(MoosPackets, OfRealProgramsAreReadInPiecesOfAnySize) {
  const std::vector<GoldenRow> rows = ReadGoldenCsv("moos/conversations.csv");
  ASSERT_EQ(rows.size(), 72U) << "36 conversations, both sides";
  for (const GoldenRow& row : rows) {
    SCOPED_TRACE(row.at("name") + " " + row.at("side"));
    std::string bytes = BytesOf(row);
    if (row.at("side") == "client") {
      ASSERT_TRUE(bytes.starts_with(MoosGreeting()) || row.at("name") == "wrong-protocol");
      bytes.erase(0, kMoosGreetingBytes);
    }
    for (const size_t piece : {size_t{1}, size_t{7}, bytes.size() + 1}) {
      const Decoded decoded = Decode(bytes, piece);
      EXPECT_EQ(decoded.problem, "");
      EXPECT_EQ(decoded.num_pending_bytes, 0U);
      EXPECT_EQ(std::to_string(decoded.num_packets), row.at("packets"));
      EXPECT_EQ(std::to_string(decoded.messages.size()), row.at("messages"));
      EXPECT_EQ(KindsOf(decoded.messages), row.contains("kinds") ? row.at("kinds") : "");
      EXPECT_EQ(decoded.again, bytes) << "written again";
    }
  }
}

TEST(MoosPackets, OfRealProgramsHoldTheValuesThatWereWritten) {
  const std::string bytes = ReadGoldenText("moos/notify.server.bin").value();
  const std::vector<MoosMessage> messages = Decode(bytes, bytes.size()).messages;
  ASSERT_GT(messages.size(), 7U);
  EXPECT_EQ(messages[0].type, moos_type::kWelcome);
  EXPECT_EQ(messages[0].source_aux, "hostname=db");
  EXPECT_EQ(messages[0].community, "gold");
  const MoosMessage& number = messages[2];
  EXPECT_EQ(number.key, "A_DOUBLE");
  EXPECT_EQ(number.source, "gold_reader");
  EXPECT_EQ(number.id, 5);
  EXPECT_EQ(number.value, 3.25);
  EXPECT_NEAR(number.time_s, 1795645302.767183, 1e-6);
  const auto binary = std::find_if(messages.begin(), messages.end(), [](const auto& each) {
    return each.data_type == moos_data::kBinary;
  });
  ASSERT_NE(binary, messages.end());
  ASSERT_EQ(binary->text.size(), 256U);
  for (size_t i = 0; i < 256; ++i) EXPECT_EQ(static_cast<unsigned char>(binary->text[i]), i);
}

/// What a client makes of the recorded answers of a MOOSDB, all at once.
MoosSession SessionAfter(const std::string& name, const std::string& own_name) {
  MoosSession session({.name = own_name, .warp = 1, .host = "db"});
  (void)session.Connect(0, 1'795'645'000'000'000);
  session.Take(ReadGoldenText("moos/" + name + ".server.bin").value(), 0, 1'795'645'000'000'000);
  return session;
}

TEST(MoosSession, TakesTheRecordedAnswersOfAMoosdb) {
  MoosSession session = SessionAfter("register", "gold_reader");
  EXPECT_EQ(session.state(), MoosSession::State::kJoined);
  EXPECT_EQ(session.community(), "gold");
  const std::vector<MoosMessage> mail = session.TakeMail();
  ASSERT_EQ(mail.size(), 15U);
  EXPECT_EQ(mail[0].key, "ONCE");
  EXPECT_EQ(mail[0].value, 42.5);
  EXPECT_EQ(mail[1].text, "set before");
  EXPECT_EQ(mail.back().text, "run 55");
}

TEST(MoosSession, StatesARecordedRefusalOfItsName) {
  const MoosSession session = SessionAfter("name-taken", "gold_reader");
  EXPECT_EQ(session.state(), MoosSession::State::kRefused);
  EXPECT_EQ(session.problem(),
            "it refuses the name 'gold_reader': A client of this name (\"gold_reader\") already "
            "exists");
}

}  // namespace shoal::moos_packet_golden_test
