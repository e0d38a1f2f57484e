#include "lib/comms/swarm/swarm_receiver.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "lib/comms/swarm/group_testing.h"

namespace shoal::swarm_receiver_test {

using enum RecoveryStrategy;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

void ExpectRejected(const Received& received, RejectReason reason) {
  EXPECT_EQ(received.reception.result, ReceptionResult::kRejected);
  EXPECT_EQ(received.reception.reason, reason) << TextOf(received.reception.reason);
  EXPECT_EQ(received.receiver.state, FollowerThree().state);
  EXPECT_EQ(received.receiver.counts.rejected_for[static_cast<size_t>(reason)], 1);
}

TEST(Receive, TakesAReportWithItsTimes) {
  const Received received = ReceiveBytes(EncodeReport(ReportOfTwo()));
  EXPECT_EQ(received.reception.result, ReceptionResult::kClean);
  EXPECT_EQ(received.reception.sender, 2);
  EXPECT_EQ(received.two().report.now.position_m, Eigen::Vector3d(210, 1, 11));
  EXPECT_EQ(received.two().report.now.velocity_mps, Eigen::Vector3d(1.25, 0.5, 0));
  EXPECT_EQ(received.two().reported_us, 15'000'000);
  EXPECT_EQ(received.two().arrived_us, kTestNow_us);
  EXPECT_EQ(received.two().log.entries.size(), 3U);
  EXPECT_TRUE(received.two().has_answered);
  EXPECT_EQ(received.receiver.counts.clean, 1);
}

TEST(Receive, TakesTheLeadersReport) {
  const Received received = ReceiveBytes(EncodeLeaderReport(ReportOfTheLeader()));
  EXPECT_EQ(received.reception.result, ReceptionResult::kClean);
  const SwarmContact& target = *received.receiver.state.target;
  EXPECT_EQ(target.report.now.position_m, Eigen::Vector3d(110, 1, 11));
  EXPECT_EQ(target.report.next.position_m, Eigen::Vector3d(500, 0, 10));
  EXPECT_EQ(target.report.next.velocity_mps, Eigen::Vector3d(0, 2, 0));
}

TEST(Receive, TakesARequestWithEverythingThatTheLeaderKnows) {
  const Received received = ReceiveBytes(EncodeBroadcast(RequestToFour()));
  EXPECT_EQ(received.reception.result, ReceptionResult::kClean);
  const GroupState& state = received.receiver.state;
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
  const Received received =
      ReceiveBytes(EncodeBroadcast(request), ReceiveBytes(EncodeBroadcast(RequestToFour())));
  EXPECT_EQ(received.reception.result, ReceptionResult::kClean);
  EXPECT_EQ(received.receiver.state.request, std::nullopt);
}

TEST(Receive, TakesNothingFromALeaderAboutMembersThatItNeverReceived) {
  Received received;
  const SwarmContact placed = PlacedContact(2, 'A', {.position_m = {7, 8, 9}});
  received.receiver.state.members[0] = placed;
  BroadcastMessage request = RequestToFour();
  request.followers[0].reported_s = 0;
  EXPECT_EQ(ReceiveBytes(EncodeBroadcast(request), received).two(), placed);
}

TEST(Receive, KeepsWhatItReceivedItselfWhereTheLeaderKnowsLess) {
  Received received = ReceiveBytes(EncodeReport(ReportOfTwo()));
  received = ReceiveBytes(EncodeBroadcast(RequestToFour()), received);
  EXPECT_EQ(received.two().reported_us, 15'000'000);
  EXPECT_EQ(received.two().report.now.position_m.x(), 210);
}

TEST(Receive, TakesTheNewestOfAMemberThatARequestNamesTwice) {
  BroadcastMessage request = RequestToFour();
  request.followers[3].id = 2;
  request.followers[0].reported_s = 14;
  const Received received = ReceiveBytes(EncodeBroadcast(request));
  EXPECT_EQ(received.reception.result, ReceptionResult::kClean);
  EXPECT_EQ(received.two().reported_us, 14'000'000);
}

TEST(Receive, RejectsAReportThatSeemsToBeItsOwn) {
  ReportMessage report = ReportOfTwo();
  report.reporter_id = 3;
  ExpectRejected(ReceiveBytes(EncodeReport(report)), RejectReason::kOwnReport);
}

TEST(Receive, HasNothingButItsFrameAgainstAPlausibleWrongId) {
  const std::vector<uint8_t> message = EncodeReport(ReportOfTwo());
  std::vector<uint8_t> damaged = message;
  damaged[5] = 4;  // reporter_id: 2 becomes 4.
  EXPECT_EQ(ReceiveBytes(damaged).reception.result, ReceptionResult::kClean);

  Received framed;
  framed.receiver.has_frames = true;
  std::vector<uint8_t> frame = EncodeFrame(message, 9);
  EXPECT_EQ(ReceiveBytes(frame, framed).reception.result, ReceptionResult::kClean);
  frame[5] = 4;
  ExpectRejected(ReceiveBytes(frame, framed), RejectReason::kBadFrame);
  ExpectRejected(ReceiveBytes(message, framed), RejectReason::kBadFrame);
}

TEST(Receive, CountsLostFramesByTheirSender) {
  Received received;
  received.receiver.has_frames = true;
  received = ReceiveBytes(EncodeFrame(EncodeReport(ReportOfTwo()), 3), received);
  received = ReceiveBytes(EncodeFrame(EncodeLeaderReport(ReportOfTheLeader()), 7), received);
  received = ReceiveBytes(EncodeFrame(EncodeReport(ReportOfTwo()), 6), received);
  const FrameCounts& frames = received.receiver.counts.frames;
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames.at(2).lost, 2);
  EXPECT_EQ(frames.at(2).received, 2);
  EXPECT_EQ(frames.at(1).lost, 0);
}

TEST(Receive, ChecksTheLengthBeforeTheContent) {
  std::vector<uint8_t> report = EncodeReport(ReportOfTwo());
  report.push_back(0);
  ExpectRejected(ReceiveBytes(report), RejectReason::kWrongLength);
  report.resize(kReportBytes - 1);
  ExpectRejected(ReceiveBytes(report), RejectReason::kWrongLength);
  std::vector<uint8_t> leader = EncodeLeaderReport(ReportOfTheLeader());
  leader.pop_back();
  ExpectRejected(ReceiveBytes(leader), RejectReason::kWrongLength);
  leader.resize(kLeaderReportBytes + 1);
  ExpectRejected(ReceiveBytes(leader), RejectReason::kWrongLength);
  ExpectRejected(ReceiveBytes({'B', 'C', 'R', 'Q'}), RejectReason::kWrongLength);
  ExpectRejected(ReceiveBytes({'R', 'P', 'R'}), RejectReason::kTooShort);
  ExpectRejected(ReceiveBytes({}), RejectReason::kTooShort);
}

TEST(Receive, FindsANumberOfFollowersThatDoesNotFitTheLength) {
  for (const uint8_t number : std::vector<uint8_t>{0, 3, 5, 255}) {
    std::vector<uint8_t> bytes = EncodeBroadcast(RequestToFour());
    bytes[kNumFollowersOffset] = number;
    const Received received = ReceiveBytes(bytes);
    ExpectRejected(received, RejectReason::kUnrecoverable);
    EXPECT_EQ(received.reception.field, SwarmField::kNumFollowers);
  }
}

TEST(Receive, AppliesNothingOfARequestWhoseLastFieldIsBeyondRecovery) {
  Received strict;
  strict.receiver.plan.of(SwarmField::kFollowersPos) = {kSkip};
  BroadcastMessage request = RequestToFour();
  request.followers[3].position_m.z() = kNaN;
  const Received received = ReceiveBytes(EncodeBroadcast(request), strict);
  ExpectRejected(received, RejectReason::kUnrecoverable);
  EXPECT_EQ(received.reception.field, SwarmField::kFollowersPos);
  EXPECT_EQ(received.receiver.counts.unrecoverable[static_cast<size_t>(SwarmField::kFollowersPos)],
            1);
}

TEST(Receive, RejectsWhatIsNotForIt) {
  ReportMessage other = ReportOfTwo();
  other.group_id = 'B';
  ExpectRejected(ReceiveBytes(EncodeReport(other)), RejectReason::kOtherGroup);
  ReportMessage unknown = ReportOfTwo();
  unknown.reporter_id = 9;
  ExpectRejected(ReceiveBytes(EncodeReport(unknown)), RejectReason::kUnknownReporter);
  SwarmReceiver leader{.state = {.own_id = 1, .is_leader = true, .members = {ReportedContact(2)}}};
  const auto bytes = EncodeLeaderReport(ReportOfTheLeader());
  EXPECT_EQ(Receive(bytes, kTestNow_us, &leader).reason, RejectReason::kNoLeader);
}

TEST(Receive, RejectsWhatIsOlderThanItKnows) {
  ReportMessage old = ReportOfTwo();
  old.time_stamp_s = 9.5;
  ExpectRejected(ReceiveBytes(EncodeReport(old)), RejectReason::kOutdated);
  LeaderMessage old_leader = ReportOfTheLeader();
  old_leader.time_stamp_s = 9.5;
  ExpectRejected(ReceiveBytes(EncodeLeaderReport(old_leader)), RejectReason::kOutdated);
}

TEST(RejectReason, HasAText) {
  std::set<std::string_view> texts;
  for (size_t i = 0; i < kNumRejectReasons; ++i) {
    texts.insert(TextOf(static_cast<RejectReason>(i)));
  }
  EXPECT_EQ(texts.size(), kNumRejectReasons);
}

}  // namespace shoal::swarm_receiver_test
