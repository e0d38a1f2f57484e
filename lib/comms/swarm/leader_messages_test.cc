#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/comms/swarm/any_message_testing.h"
#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/leader_message.h"
#include "tests/golden/read_golden.h"

namespace shoal::leader_messages_test {

Eigen::Vector3f VectorOf(const nlohmann::json& numbers) {
  return {numbers[0].get<float>(), numbers[1].get<float>(), numbers[2].get<float>()};
}

LeaderMotion LeaderOf(const nlohmann::json& decoded) {
  return {.position_m = VectorOf(decoded["leader_pos"]),
          .velocity_mps = VectorOf(decoded["leader_vel"]),
          .next_position_m = VectorOf(decoded["leader_next_pos"]),
          .next_velocity_mps = VectorOf(decoded["leader_next_vel"])};
}

BroadcastMessage BroadcastOf(const nlohmann::json& decoded) {
  BroadcastMessage message{.group_id = FromHex(decoded["group_id"])[0],
                           .leader = LeaderOf(decoded),
                           .response_start_s = decoded["rspn_start"],
                           .time_stamp_s = decoded["time_stamp"]};
  for (size_t i = 0; i < decoded["num_followers"]; ++i) {
    message.followers.push_back({.id = decoded["rspn_sched"][i],
                                 .position_m = VectorOf(decoded["followers_pos"][i]),
                                 .velocity_mps = VectorOf(decoded["followers_vel"][i]),
                                 .reported_s = decoded["followers_rspn"][i]});
  }
  return message;
}

template <class Decode>
int NumParsedAsMuNetDoes(const std::string& kind, const Decode& decode) {
  int num_cases = 0;
  const nlohmann::json golden = ReadGoldenJson("munet/message_encodings.json");
  for (const nlohmann::json& row : golden["parser_edge_cases"]) {
    if (row["kind"] != kind) continue;
    ++num_cases;
    EXPECT_EQ(decode(FromHex(row["hex"])).has_value(), row["result"] == "ok") << row["note"];
  }
  return num_cases;
}

TEST(LeaderMessage, HasTheBytesOfMuNet) {
  int num_messages = 0;
  const nlohmann::json golden = ReadGoldenJson("munet/message_encodings.json");
  for (const nlohmann::json& row : golden["valid"]) {
    if (row["kind"] != "LRPT") continue;
    ++num_messages;
    const std::vector<uint8_t> bytes = FromHex(row["hex"]);
    const LeaderMessage message{.group_id = FromHex(row["decoded"]["group_id"])[0],
                                .leader = LeaderOf(row["decoded"]),
                                .time_stamp_s = row["decoded"]["time_stamp"]};
    EXPECT_EQ(EncodeLeaderReport(message), bytes);
    EXPECT_EQ(DecodeLeaderReport(bytes), message);
  }
  EXPECT_GE(num_messages, 3);
}

TEST(LeaderMessage, IsParsedAsMuNetParsesIt) {
  EXPECT_GE(NumParsedAsMuNetDoes("LRPT", DecodeLeaderReport), 2);
}

TEST(BroadcastMessage, HasTheBytesOfMuNet) {
  int num_messages = 0;
  const nlohmann::json golden = ReadGoldenJson("munet/message_encodings.json");
  for (const nlohmann::json& row : golden["valid"]) {
    if (row["kind"] != "BCRQ") continue;
    ++num_messages;
    const std::vector<uint8_t> bytes = FromHex(row["hex"]);
    const BroadcastMessage message = BroadcastOf(row["decoded"]);
    EXPECT_EQ(BroadcastBytes(message.followers.size()), bytes.size());
    EXPECT_EQ(EncodeBroadcast(message), bytes);
    EXPECT_EQ(DecodeBroadcast(bytes), message);
  }
  EXPECT_GE(num_messages, 4);
}

TEST(BroadcastMessage, IsParsedAsMuNetParsesIt) {
  EXPECT_GE(NumParsedAsMuNetDoes("BCRQ", DecodeBroadcast), 3);
}

TEST(BroadcastMessage, AsksForNoMemoryThatItsBytesDoNotFill) {
  std::vector<uint8_t> bytes = EncodeBroadcast({});
  for (size_t i = 0; i < 4; ++i) bytes[kNumFollowersOffset + i] = 0xFF;
  EXPECT_EQ(DecodeBroadcast(bytes), std::nullopt);
}

TEST(AnySwarmMessage, IsTheOneThatItsFlagNames) {
  const auto is = [](const std::vector<uint8_t>& bytes) {
    const auto message = DecodeAnyMessage(bytes);
    return message ? static_cast<int>(message->index()) : -1;
  };
  EXPECT_EQ(is(EncodeReport({})), 0);
  EXPECT_EQ(is(EncodeReport({.flag = kResponseFlag})), 0);
  EXPECT_EQ(is(EncodeLeaderReport({})), 1);
  EXPECT_EQ(is(EncodeBroadcast({})), 2);
  EXPECT_EQ(is(EncodeReport({.flag = {'R', 'P', 'R', 'X'}})), -1);
  EXPECT_EQ(is({}), -1);
}

RC_GTEST_PROP(AnySwarmMessage, AnyBytesReadAreWrittenAgain, (std::vector<uint8_t> bytes)) {
  const MessageFlag flag =
      *rc::gen::element(kReportFlag, kResponseFlag, kLeaderReportFlag, kBroadcastFlag);
  const auto num_followers = *rc::gen::inRange<uint8_t>(0, 5);
  bytes.resize(*rc::gen::inRange<size_t>(0, 300));
  std::copy(flag.begin(), flag.begin() + std::min<std::ptrdiff_t>(4, std::ssize(bytes)),
            bytes.begin());
  if (bytes.size() > kNumFollowersOffset + 4) {
    std::fill_n(bytes.begin() + kNumFollowersOffset, 4, uint8_t{0});
    bytes[kNumFollowersOffset] = num_followers;
  }
  const auto message = DecodeAnyMessage(bytes);
  const size_t needed = flag == kLeaderReportFlag ? kLeaderReportBytes
                        : flag == kBroadcastFlag  ? BroadcastBytes(num_followers)
                                                  : kReportBytes;
  RC_ASSERT(message.has_value() == (bytes.size() >= needed));
  if (!message) return;
  bytes.resize(needed);
  struct Write {
    std::vector<uint8_t> operator()(const ReportMessage& m) const { return EncodeReport(m); }
    std::vector<uint8_t> operator()(const LeaderMessage& m) const { return EncodeLeaderReport(m); }
    std::vector<uint8_t> operator()(const BroadcastMessage& m) const { return EncodeBroadcast(m); }
  };
  RC_ASSERT(std::visit(Write{}, *message) == bytes);
}

}  // namespace shoal::leader_messages_test
