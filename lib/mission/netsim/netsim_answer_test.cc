#include "lib/mission/netsim/netsim_answer.h"

#include <gtest/gtest.h>

#include <set>

#include "lib/mission/netsim/netsim_testing.h"

namespace shoal::netsim_answer_test {

const std::string kFront = "NETSIM|netsim.protobuf.NetSimManagerResponse|";

NetsimReply Answered(const std::vector<uint8_t>& message) {
  return AnswerLine(LineOf(message), "127.0.0.1", TwoNetsimVehicles());
}

/// A request with id 7 for this port, from the middle of the bay.
std::vector<uint8_t> Request(uint8_t low_byte_of_port) {
  // clang-format off
  return {8, 7, 18, 58,
          8, low_byte_of_port, 0xE4, 3,
          0x11, 0, 0, 0, 0, 0, 0, 0, 0,            // time 0
          0x19, 0, 0, 0, 0, 0, 0xC0, 0x44, 0x40,   // lat 41.5
          0x21, 0, 0, 0, 0, 0, 0xA0, 0x51, 0xC0,   // lon -70.5
          0x29, 0, 0, 0, 0, 0, 0, 0, 0,            // depth 0
          0x31, 0, 0, 0, 0, 0, 0, 0, 0,            // speed 0
          0x39, 0, 0, 0, 0, 0, 0x80, 0x56, 0x40};  // heading 90
  // clang-format on
}

TEST(AnswerLine, AcceptsAPosition) {
  const NetsimReply reply = Answered(Request(0xB0));
  EXPECT_EQ(reply.answer, kFront + "CAcQAQ==\n");
  EXPECT_EQ(reply.outcome, NetsimOutcome::kAccepted);
  EXPECT_EQ(reply.problem, "");
  ASSERT_EQ(reply.positions.size(), 1U);
  EXPECT_EQ(reply.positions[0].vehicle, "alice");
  EXPECT_EQ(reply.positions[0].nav.lat_deg, 41.5);
  EXPECT_EQ(reply.positions[0].nav.lon_deg, -70.5);
}

TEST(AnswerLine, StatesTheReason) {
  const NetsimReply reply = Answered(Request(0xB1));
  EXPECT_EQ(reply.answer, kFront + "CAcQBA==\n");
  EXPECT_EQ(reply.outcome, NetsimOutcome::kOutOfDefinedRegion);
  EXPECT_EQ(reply.problem, "bruce: lat 41.5 is not from -10 to 10 (environment 'date line')");
  EXPECT_EQ(Answered(Request(0xB2)).outcome, NetsimOutcome::kInvalidModemTcpPort);
  EXPECT_EQ(AnswerLine(LineOf(Request(0xB0)), "10.0.0.1", TwoNetsimVehicles()).outcome,
            NetsimOutcome::kInvalidSourceAddress);
}

TEST(AnswerLine, HasNoAnswerForWhatIsNoRequest) {
  const std::pair<std::string, NetsimOutcome> lines[] = {
      {"", NetsimOutcome::kBlank},
      {"hello", NetsimOutcome::kNoMessage},
      {LineOf({8, 5}, "some.Other"), NetsimOutcome::kUnknownMessage},
      {LineOf({8, 5}) + "%", NetsimOutcome::kUndecodable},
      {LineOf({8}), NetsimOutcome::kUndecodable},
      {LineOf({}), NetsimOutcome::kUndecodable},
  };
  for (const auto& [line, outcome] : lines) {
    const NetsimReply reply = AnswerLine(line, "127.0.0.1", TwoNetsimVehicles());
    EXPECT_EQ(reply.answer, "") << line;
    EXPECT_EQ(reply.outcome, outcome) << line;
    EXPECT_EQ(reply.problem.empty(), outcome == NetsimOutcome::kBlank) << line;
  }
}

TEST(AnswerLine, AnswersWhatIsIncompleteWhereAStatusFits) {
  EXPECT_EQ(Answered({8, 7, 18, 0}).answer, kFront + "CAcQAg==\n");
  EXPECT_EQ(Answered({8, 7, 18, 4, 8, 0xB0, 0xE4, 3}).answer, kFront + "CAcQBA==\n");
  EXPECT_EQ(Answered({8, 7, 26, 0}).answer, "");
  for (const auto& request : {std::vector<uint8_t>{8, 7, 18, 0}, {8, 7, 26, 0}}) {
    EXPECT_EQ(Answered(request).outcome, NetsimOutcome::kIncomplete);
    EXPECT_TRUE(Answered(request).positions.empty());
    EXPECT_TRUE(Answered(request).stats.empty());
    EXPECT_NE(Answered(request).problem, "");
  }
}

TEST(NetsimOutcome, HasAWordEach) {
  std::set<std::string_view> words;
  for (size_t i = 0; i < kNumNetsimOutcomes; ++i) {
    words.insert(Word(static_cast<NetsimOutcome>(i)));
  }
  EXPECT_EQ(words.size(), kNumNetsimOutcomes);
  EXPECT_EQ(Word(NetsimOutcome::kAccepted), "accepted");
}

TEST(NetsimCounts, CountEachOutcome) {
  NetsimCounts counts;
  counts.Add(NetsimOutcome::kAccepted);
  counts.Add(NetsimOutcome::kAccepted);
  counts.Add(NetsimOutcome::kBlank);
  EXPECT_EQ(counts.Of(NetsimOutcome::kAccepted), 2);
  EXPECT_EQ(counts.Of(NetsimOutcome::kBlank), 1);
  EXPECT_EQ(counts.Of(NetsimOutcome::kUndecodable), 0);
}

}  // namespace shoal::netsim_answer_test
