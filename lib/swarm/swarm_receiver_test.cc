#include "lib/swarm/swarm_receiver.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "lib/swarm/test_group.h"

namespace shoal {
namespace {

using enum RecoveryStrategy;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

void ExpectRejected(const Heard& heard, RejectReason reason) {
  EXPECT_EQ(heard.reception.result, ReceptionResult::kRejected);
  EXPECT_EQ(heard.reception.reason, reason) << TextOf(heard.reception.reason);
  EXPECT_EQ(heard.receiver.state, FollowerThree().state);
  EXPECT_EQ(heard.receiver.counts.rejected_for[static_cast<size_t>(reason)], 1);
}

TEST(Receive, TakesAReportWithItsTimes) {
  const Heard heard = Hear(EncodeReport(ReportOfTwo()));
  EXPECT_EQ(heard.reception.result, ReceptionResult::kClean);
  EXPECT_EQ(heard.reception.sender, 2);
  EXPECT_EQ(heard.two().report.now.position_m, Eigen::Vector3d(210, 1, 11));
  EXPECT_EQ(heard.two().report.now.velocity_mps, Eigen::Vector3d(1.25, 0.5, 0));
  EXPECT_EQ(heard.two().reported_us, 15'000'000);
  EXPECT_EQ(heard.two().arrived_us, kTestNow_us);
  EXPECT_EQ(heard.two().log.entries.size(), 3U);
  EXPECT_TRUE(heard.two().has_answered);
  EXPECT_EQ(heard.receiver.counts.clean, 1);
}

TEST(Receive, TakesTheLeadersReport) {
  const Heard heard = Hear(EncodeLeaderReport(ReportOfTheLeader()));
  EXPECT_EQ(heard.reception.result, ReceptionResult::kClean);
  const SwarmContact& target = *heard.receiver.state.target;
  EXPECT_EQ(target.report.now.position_m, Eigen::Vector3d(110, 1, 11));
  EXPECT_EQ(target.report.next.position_m, Eigen::Vector3d(500, 0, 10));
  EXPECT_EQ(target.report.next.velocity_mps, Eigen::Vector3d(0, 2, 0));
}

TEST(Receive, TakesARequestWithEverythingThatTheLeaderKnows) {
  const Heard heard = Hear(EncodeBroadcast(RequestToFour()));
  EXPECT_EQ(heard.reception.result, ReceptionResult::kClean);
  const GroupState& state = heard.receiver.state;
  EXPECT_EQ(state.request, (ResponseRequest{.start_us = 17'000'000, .slot = 1}));
  for (const SwarmContact& member : state.members) {
    EXPECT_EQ(member.report.now.position_m.y(), member.id);
    EXPECT_EQ(member.reported_us, 10'000'000 + 500'000 * member.id);
    EXPECT_FALSE(member.has_answered);
  }
}

TEST(Receive, WithdrawsTheRequestOfBeforeWhenANewOneAsksOthers) {
  BroadcastMessage request = RequestToFour();
  request.followers.erase(request.followers.begin() + 1);
  const Heard heard = Hear(EncodeBroadcast(request), Hear(EncodeBroadcast(RequestToFour())));
  EXPECT_EQ(heard.reception.result, ReceptionResult::kClean);
  EXPECT_EQ(heard.receiver.state.request, std::nullopt);
}

TEST(Receive, DoesNotLetALeaderTellOfMembersThatItNeverHeard) {
  Heard heard;
  const SwarmContact placed = PlacedContact(2, 'A', {.position_m = {7, 8, 9}});
  heard.receiver.state.members[0] = placed;
  BroadcastMessage request = RequestToFour();
  request.followers[0].reported_s = 0;
  EXPECT_EQ(Hear(EncodeBroadcast(request), heard).two(), placed);
}

TEST(Receive, KeepsWhatItHeardItselfWhereTheLeaderKnowsLess) {
  Heard heard = Hear(EncodeReport(ReportOfTwo()));
  heard = Hear(EncodeBroadcast(RequestToFour()), heard);
  EXPECT_EQ(heard.two().reported_us, 15'000'000);
  EXPECT_EQ(heard.two().report.now.position_m.x(), 210);
}

TEST(Receive, TakesTheNewestOfAMemberThatARequestNamesTwice) {
  BroadcastMessage request = RequestToFour();
  request.followers[3].id = 2;
  request.followers[0].reported_s = 14;
  const Heard heard = Hear(EncodeBroadcast(request));
  EXPECT_EQ(heard.reception.result, ReceptionResult::kClean);
  EXPECT_EQ(heard.two().reported_us, 14'000'000);
}

TEST(Receive, RejectsAReportThatSeemsToBeItsOwn) {
  ReportMessage report = ReportOfTwo();
  report.reporter_id = 3;
  ExpectRejected(Hear(EncodeReport(report)), RejectReason::kOwnReport);
}

TEST(Receive, HasNothingButItsFrameAgainstAPlausibleWrongId) {
  const std::vector<uint8_t> message = EncodeReport(ReportOfTwo());
  std::vector<uint8_t> damaged = message;
  damaged[5] = 4;  // reporter_id: 2 becomes 4.
  EXPECT_EQ(Hear(damaged).reception.result, ReceptionResult::kClean);

  Heard framed;
  framed.receiver.has_frames = true;
  std::vector<uint8_t> frame = EncodeFrame(message, 9);
  EXPECT_EQ(Hear(frame, framed).reception.result, ReceptionResult::kClean);
  frame[5] = 4;
  ExpectRejected(Hear(frame, framed), RejectReason::kBadFrame);
  ExpectRejected(Hear(message, framed), RejectReason::kBadFrame);
}

TEST(Receive, CountsLostFramesByTheirSender) {
  Heard heard;
  heard.receiver.has_frames = true;
  heard = Hear(EncodeFrame(EncodeReport(ReportOfTwo()), 3), heard);
  heard = Hear(EncodeFrame(EncodeLeaderReport(ReportOfTheLeader()), 7), heard);
  heard = Hear(EncodeFrame(EncodeReport(ReportOfTwo()), 6), heard);
  const FrameCounts& frames = heard.receiver.counts.frames;
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames.at(2).lost, 2);
  EXPECT_EQ(frames.at(2).received, 2);
  EXPECT_EQ(frames.at(1).lost, 0);
}

TEST(Receive, ChecksTheLengthBeforeTheContent) {
  std::vector<uint8_t> report = EncodeReport(ReportOfTwo());
  report.push_back(0);
  ExpectRejected(Hear(report), RejectReason::kWrongLength);
  report.resize(kReportBytes - 1);
  ExpectRejected(Hear(report), RejectReason::kWrongLength);
  std::vector<uint8_t> leader = EncodeLeaderReport(ReportOfTheLeader());
  leader.pop_back();
  ExpectRejected(Hear(leader), RejectReason::kWrongLength);
  leader.resize(kLeaderReportBytes + 1);
  ExpectRejected(Hear(leader), RejectReason::kWrongLength);
  ExpectRejected(Hear({'B', 'C', 'R', 'Q'}), RejectReason::kWrongLength);
  ExpectRejected(Hear({'R', 'P', 'R'}), RejectReason::kTooShort);
  ExpectRejected(Hear({}), RejectReason::kTooShort);
}

TEST(Receive, FindsANumberOfFollowersThatDoesNotFitTheLength) {
  for (const uint8_t number : std::vector<uint8_t>{0, 3, 5, 255}) {
    std::vector<uint8_t> bytes = EncodeBroadcast(RequestToFour());
    bytes[kNumFollowersOffset] = number;
    const Heard heard = Hear(bytes);
    ExpectRejected(heard, RejectReason::kUnrecoverable);
    EXPECT_EQ(heard.reception.field, SwarmField::kNumFollowers);
  }
}

TEST(Receive, AppliesNothingOfARequestWhoseLastFieldIsBeyondRecovery) {
  Heard strict;
  strict.receiver.plan.of(SwarmField::kFollowersPos) = {kSkip};
  BroadcastMessage request = RequestToFour();
  request.followers[3].position_m.z() = kNaN;
  const Heard heard = Hear(EncodeBroadcast(request), strict);
  ExpectRejected(heard, RejectReason::kUnrecoverable);
  EXPECT_EQ(heard.reception.field, SwarmField::kFollowersPos);
  EXPECT_EQ(heard.receiver.counts.unrecoverable[static_cast<size_t>(SwarmField::kFollowersPos)], 1);
}

TEST(Receive, RejectsWhatIsNotForIt) {
  ReportMessage other = ReportOfTwo();
  other.group_id = 'B';
  ExpectRejected(Hear(EncodeReport(other)), RejectReason::kOtherGroup);
  ReportMessage stranger = ReportOfTwo();
  stranger.reporter_id = 9;
  ExpectRejected(Hear(EncodeReport(stranger)), RejectReason::kUnknownReporter);
  SwarmReceiver leader{.state = {.own_id = 1, .is_leader = true, .members = {HeardContact(2)}}};
  const auto bytes = EncodeLeaderReport(ReportOfTheLeader());
  EXPECT_EQ(Receive(bytes, kTestNow_us, &leader).reason, RejectReason::kNoLeader);
}

TEST(Receive, RejectsWhatIsOlderThanItKnows) {
  ReportMessage old = ReportOfTwo();
  old.time_stamp_s = 9.5;
  ExpectRejected(Hear(EncodeReport(old)), RejectReason::kOutdated);
  LeaderMessage old_leader = ReportOfTheLeader();
  old_leader.time_stamp_s = 9.5;
  ExpectRejected(Hear(EncodeLeaderReport(old_leader)), RejectReason::kOutdated);
}

TEST(RejectReason, IsToldInWords) {
  std::set<std::string_view> texts;
  for (size_t i = 0; i < kNumRejectReasons; ++i) {
    texts.insert(TextOf(static_cast<RejectReason>(i)));
  }
  EXPECT_EQ(texts.size(), kNumRejectReasons);
}

}  // namespace
}  // namespace shoal
