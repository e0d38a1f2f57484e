#include "lib/comms/moos_wire/moos_packet.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace shoal::moos_packet_test {

std::string PacketOf(const std::vector<MoosMessage>& messages) {
  std::string bytes;
  AppendMoosPacket(messages, &bytes);
  return bytes;
}

std::string ProblemOf(std::string_view bytes) {
  MoosPacketReader reader;
  reader.Take(bytes, [](std::span<const MoosMessage>) {});
  return reader.problem();
}

void Put(int32_t number, size_t place, std::string* bytes) {
  for (size_t i = 0; i < 4; ++i) {
    (*bytes)[place + i] = static_cast<char>(static_cast<uint32_t>(number) >> (8 * i));
  }
}

/// Of a packet with one message: the places of its lengths.
constexpr size_t kCount = 4;
constexpr size_t kCompressed = 8;
constexpr size_t kMessageLength = 9;
constexpr size_t kSourceLength = 19;

TEST(MoosPacket, OfOneMessageHasTheLayoutOfTheProtocol) {
  const std::string bytes = PacketOf({MoosNotify("me", "X", 0.5)});
  EXPECT_EQ(bytes.size(), kMinMoosPacketBytes + kMinMoosMessageBytes + 3);
  EXPECT_EQ(bytes.substr(0, 13), std::string("\x42\0\0\0\1\0\0\0\0\x39\0\0\0", 13));
  EXPECT_EQ(bytes[17], 'N');
  EXPECT_EQ(bytes[18], 'D');
  EXPECT_EQ(bytes.substr(kSourceLength, 6), std::string("\2\0\0\0me", 6));
  EXPECT_EQ(ProblemOf(bytes), "");
}

TEST(MoosPacket, RefusesLengthsThatCannotBe) {
  const std::string good = PacketOf({MoosNotify("me", "X", 0.5)});
  for (const int32_t length : {-1, 0, 8, 4194305, std::numeric_limits<int32_t>::max(),
                               std::numeric_limits<int32_t>::min()}) {
    std::string bytes = good;
    Put(length, 0, &bytes);
    EXPECT_EQ(ProblemOf(bytes), "a packet states a length of " + std::to_string(length) +
                                    " bytes; allowed: 9 to 4194304");
  }
}

TEST(MoosPacket, AsksForNoMemoryForCountsThatCannotBe) {
  std::string bytes = PacketOf({MoosNotify("me", "X", 0.5)});
  for (const int32_t count : {2, -1, std::numeric_limits<int32_t>::max()}) {
    Put(count, kCount, &bytes);
    EXPECT_NE(ProblemOf(bytes).find("a packet of 66 bytes states "), std::string::npos);
  }
  Put(0, kCount, &bytes);
  EXPECT_EQ(ProblemOf(bytes), "bytes are left behind the messages of a packet");
}

TEST(MoosPacket, RefusesMessagesAndTextsWhoseLengthsWrap) {
  const std::string good = PacketOf({MoosNotify("me", "X", 0.5)});
  const std::string wrong = "a message of a packet does not have the length that it states";
  for (const int32_t length : {-1, 0, 53, 56, 58, std::numeric_limits<int32_t>::max(),
                               std::numeric_limits<int32_t>::min(), -57}) {
    std::string bytes = good;
    Put(length, kMessageLength, &bytes);
    EXPECT_EQ(ProblemOf(bytes), wrong) << length;
  }
  for (const int32_t length :
       {-1, 1, 3, 1000, std::numeric_limits<int32_t>::max(), std::numeric_limits<int32_t>::min()}) {
    std::string bytes = good;
    Put(length, kSourceLength, &bytes);
    EXPECT_EQ(ProblemOf(bytes), wrong) << length;
  }
}

TEST(MoosPacket, RefusesACompressedPacket) {
  std::string bytes = PacketOf({MoosNotify("me", "X", 0.5)});
  bytes[kCompressed] = 1;
  EXPECT_EQ(ProblemOf(bytes), "a packet is compressed, which no MOOSDB does");
}

TEST(MoosPacket, WithoutMessagesIsTakenAndNeverWritten) {
  EXPECT_EQ(ProblemOf(std::string("\x09\0\0\0\0\0\0\0\0", 9)), "");
  EXPECT_DEATH(PacketOf({}), "a packet has at least one message");
  std::string bytes;
  EXPECT_EQ(AppendMoosPackets({}, &bytes), 0U);
  EXPECT_EQ(bytes, "");
}

TEST(MoosPacketReader, ReadsNothingAfterAProblem) {
  MoosPacketReader reader;
  int num_packets = 0;
  const auto count = [&](std::span<const MoosMessage>) { ++num_packets; };
  const std::string good = PacketOf({MoosNotify("me", "X", 0.5)});
  reader.Take(good + std::string(4, '\0') + good, count);
  reader.Take(good, count);
  EXPECT_EQ(num_packets, 1);
  EXPECT_EQ(reader.num_pending_bytes(), 0U);
  EXPECT_NE(reader.problem(), "");
}

TEST(MoosPacketReader, KeepsNoMoreThanOnePacket) {
  MoosPacketReader reader;
  std::string bytes(kMaxMoosPacketBytes, 'x');
  Put(static_cast<int32_t>(kMaxMoosPacketBytes), 0, &bytes);
  reader.Take(std::string_view(bytes).substr(0, bytes.size() - 1),
              [](std::span<const MoosMessage>) {});
  EXPECT_EQ(reader.num_pending_bytes(), kMaxMoosPacketBytes - 1);
  reader.Take("x", [](std::span<const MoosMessage>) {});
  EXPECT_NE(reader.problem(), "");
  EXPECT_EQ(reader.num_pending_bytes(), 0U);
}

TEST(MoosPackets, AreAsManyAsTheirMessagesNeed) {
  const MoosMessage large = MoosNotify("me", "LARGE", std::string(kMaxMoosPacketBytes / 2, 'x'));
  const MoosMessage too_large = MoosNotify("me", "TOO", std::string(kMaxMoosPacketBytes, 'x'));
  const MoosMessage small = MoosNotify("me", "SMALL", 1);
  const std::vector<MoosMessage> messages = {small, large, too_large, large, small};
  std::string bytes;
  EXPECT_EQ(AppendMoosPackets(messages, &bytes), 1U);
  std::vector<std::string> keys;
  MoosPacketReader reader;
  reader.Take(bytes, [&](std::span<const MoosMessage> packet) {
    keys.emplace_back("|");
    for (const MoosMessage& each : packet) keys.push_back(each.key);
  });
  EXPECT_EQ(reader.problem(), "");
  EXPECT_EQ(keys, (std::vector<std::string>{"|", "SMALL", "LARGE", "|", "LARGE", "SMALL"}));
}

MoosMessage AnyMessage() {
  const auto any_text = [] { return *rc::gen::arbitrary<std::string>(); };
  return {.id = *rc::gen::arbitrary<int32_t>(),
          .type = *rc::gen::arbitrary<char>(),
          .data_type = *rc::gen::arbitrary<char>(),
          .source = any_text(),
          .source_aux = any_text(),
          .community = any_text(),
          .key = any_text(),
          .time_s = *rc::gen::arbitrary<double>(),
          .value = *rc::gen::element(0.0, -0.0, std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity(), 1e-300),
          .value2 = *rc::gen::arbitrary<double>(),
          .text = any_text()};
}

RC_GTEST_PROP(MoosPacket, IsReadAsItWasWrittenWhateverItHolds, ()) {
  std::vector<MoosMessage> messages = {AnyMessage(), AnyMessage()};
  std::string bytes = PacketOf(messages) + PacketOf({messages[1]});
  std::vector<MoosMessage> read;
  MoosPacketReader reader;
  const size_t piece = *rc::gen::inRange<size_t>(1, 200);
  for (size_t at = 0; at < bytes.size(); at += piece) {
    reader.Take(std::string_view(bytes).substr(at, piece),
                [&](auto packet) { read.insert(read.end(), packet.begin(), packet.end()); });
  }
  RC_ASSERT(reader.problem().empty());
  RC_ASSERT(read == std::vector<MoosMessage>({messages[0], messages[1], messages[1]}));
}

}  // namespace shoal::moos_packet_test
