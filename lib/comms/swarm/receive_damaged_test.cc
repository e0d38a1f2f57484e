// How a vehicle's receiver handles damaged fields of whole messages.
#include <gtest/gtest.h>

#include <limits>

#include "lib/comms/swarm/group_testing.h"

namespace shoal::receive_damaged_test {

using enum RecoveryStrategy;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

TEST(Receive, RecoversAPositionBeyond100Km) {
  ReportMessage report = ReportOfTwo();
  report.position_m.x() = 3e38F;
  const Received received = ReceiveBytes(EncodeReport(report));
  EXPECT_EQ(received.reception.recoveries,
            (std::vector<FieldRecovery>{{.field = SwarmField::kReporterPos,
                                         .fault = FieldFault::kTooFar,
                                         .strategy = kPredict,
                                         .id = 2}}));
  EXPECT_EQ(received.two().report.now.position_m.x(), 205 + 5 * 1.5);
}

TEST(Receive, RecoversAPositionForTheTimeStampThatItCameWith) {
  ReportMessage report = ReportOfTwo();
  report.position_m.x() = kNaN;
  report.time_stamp_s = 14;
  const SwarmContact recovered = ReceiveBytes(EncodeReport(report)).two();
  EXPECT_EQ(recovered.report.now.position_m.x(), 205 + 4 * 1.5);
  report.time_stamp_s = kNaN;
  EXPECT_EQ(ReceiveBytes(EncodeReport(report)).two().report.now.position_m.x(), 205 + 6 * 1.5);
  BroadcastMessage request = RequestToFour();
  request.followers[0].position_m.x() = kNaN;
  request.followers[0].reported_s = 12;
  EXPECT_EQ(ReceiveBytes(EncodeBroadcast(request)).two().report.now.position_m.x(), 205 + 2 * 1.5);
}

TEST(Receive, RecoversARequestWhoseAnswersShouldHaveBegun) {
  BroadcastMessage request = RequestToFour();
  request.response_start_s = 15.5F;
  const Received received = ReceiveBytes(EncodeBroadcast(request));
  ASSERT_EQ(received.reception.recoveries.size(), 1U);
  EXPECT_EQ(received.reception.recoveries[0].fault, FieldFault::kInThePast);
  EXPECT_EQ(received.receiver.state.request->start_us, 12'000'000 + 5'000'000);

  Received lenient;
  lenient.receiver.limits.late_start_us = 1'000'000;
  lenient = ReceiveBytes(EncodeBroadcast(request), lenient);
  EXPECT_EQ(lenient.reception.result, ReceptionResult::kClean);
  EXPECT_EQ(lenient.receiver.state.request->start_us, 15'500'000);
}

TEST(Receive, RecoversATimeOfAFollowerWhateverTheTimesOfOthersAre) {
  Received received;
  received.receiver.plan.of(SwarmField::kFollowersRspn) = {kNeutral};
  BroadcastMessage request = RequestToFour();
  request.followers[2].reported_s = kNaN;
  received = ReceiveBytes(EncodeBroadcast(request), received);
  EXPECT_EQ(received.receiver.state.members[1].reported_us, kTestNow_us);
}

TEST(Receive, RecoversADamagedIdOfTheScheduleByTheOneBefore) {
  BroadcastMessage request = RequestToFour();
  request.followers[2].id = 4 + 0x10000;
  const Received received = ReceiveBytes(EncodeBroadcast(request));
  ASSERT_EQ(received.reception.recoveries.size(), 1U);
  EXPECT_EQ(received.reception.recoveries[0].strategy, kPredict);
  EXPECT_EQ(received.receiver.state.response_order, (std::vector<int64_t>{2, 3, 4, 5}));
  EXPECT_EQ(received.receiver.state.members[1].report.now.position_m.x(), 400);
}

TEST(Receive, RejectsAScheduleOfAnotherLength) {
  Received before;
  before.receiver.state.response_order = {2, 3};
  BroadcastMessage request = RequestToFour();
  request.followers[0].id = 0;
  const Received received = ReceiveBytes(EncodeBroadcast(request), before);
  EXPECT_EQ(received.reception.reason, RejectReason::kUnrecoverable);
  EXPECT_EQ(received.reception.field, SwarmField::kRspnSched);
  EXPECT_EQ(received.receiver.state, before.receiver.state);
}

TEST(Receive, RecoversTheNumberOfFollowersBeforeItReadsWhatComesBehind) {
  Received predicting;
  predicting.receiver.plan.of(SwarmField::kNumFollowers) = {kPredict};
  std::vector<uint8_t> bytes = EncodeBroadcast(RequestToFour());
  bytes[kNumFollowersOffset + 3] = 0x40;
  const Received received = ReceiveBytes(bytes, predicting);
  EXPECT_EQ(received.reception.result, ReceptionResult::kRecovered);
  EXPECT_EQ(received.receiver.state, ReceiveBytes(EncodeBroadcast(RequestToFour())).receiver.state);
}

TEST(Receive, ReportsEachRecoveredFieldWithFaultAndStrategy) {
  ReportMessage report = ReportOfTwo();
  report.flag = {'R', 'P', 'R', 'U'};
  report.group_id = 0;
  report.velocity_mps.x() = kNaN;
  report.time_stamp_s = -1;
  const Received received = ReceiveBytes(EncodeReport(report));
  EXPECT_EQ(received.reception.result, ReceptionResult::kRecovered);
  std::vector<std::string_view> listed;
  for (const FieldRecovery& recovery : received.reception.recoveries) {
    listed.insert(listed.end(),
                  {NameOf(recovery.field), TextOf(recovery.fault), NameOf(recovery.strategy)});
  }
  EXPECT_EQ(listed,
            (std::vector<std::string_view>{"type", "not a type of message", "predict",      //
                                           "group_id", "not a letter or digit", "predict",  //
                                           "time_stamp", "before time 0", "predict",        //
                                           "reporter_vel", "not a finite number", "predict"}));
  const auto& counts = received.receiver.counts.recovered_by;
  EXPECT_EQ(counts[static_cast<size_t>(SwarmField::kReporterVel)][static_cast<size_t>(kPredict)],
            1);
  EXPECT_EQ(received.two().reported_us, 15'000'000);  // 10 s and the 5 s between the two before.
}

TEST(Receive, DropsAMessageWhoseFlagIsReplacedByWhatIsNoFlag) {
  for (const RecoveryStrategy strategy : {kNeutral, kSentinel, kSkipField, kPrevious}) {
    Received received;
    received.receiver.plan.of(SwarmField::kType) = {strategy};
    std::vector<uint8_t> bytes = EncodeReport(ReportOfTwo());
    bytes[0] = 'X';
    received = ReceiveBytes(bytes, received);
    EXPECT_EQ(received.reception.reason, RejectReason::kUnrecoverable);
    EXPECT_EQ(received.reception.field, SwarmField::kType);
  }
}

TEST(Receive, DoesNotLetARecoveredTimeBeLaterThanNow) {
  Received received;
  received.receiver.state.members[0].log.entries[0].time_us =
      100'000;  // 9.9 s between its reports.
  ReportMessage report = ReportOfTwo();
  report.time_stamp_s = kNaN;
  received = ReceiveBytes(EncodeReport(report), received);
  EXPECT_EQ(received.two().reported_us, kTestNow_us);
}

TEST(SkipField, KeepsWhatWasKnownAndTakesTheRest) {
  Received received;
  received.receiver.plan.of(SwarmField::kReporterPos) = {kSkipField};
  ReportMessage report = ReportOfTwo();
  report.position_m.y() = kNaN;
  received = ReceiveBytes(EncodeReport(report), received);
  EXPECT_EQ(received.reception.result, ReceptionResult::kRecovered);
  EXPECT_EQ(received.two().report.now.position_m, Eigen::Vector3d(205, 0, 10));
  EXPECT_EQ(received.two().report.now.velocity_mps, Eigen::Vector3d(1.25, 0.5, 0));
  EXPECT_EQ(received.two().reported_us, 15'000'000);
  EXPECT_EQ(received.two().log.entries.size(), 2U);
}

TEST(SkipField, LeavesAFieldUnknownThatNeverWasKnown) {
  Received received;
  received.receiver.state.members[0] = SwarmContact{.id = 2};
  received.receiver.plan.of(SwarmField::kReporterPos) = {kSkipField};
  ReportMessage report = ReportOfTwo();
  report.position_m.y() = kNaN;
  received = ReceiveBytes(EncodeReport(report), received);
  EXPECT_FALSE(PredictContact(received.two(), kTestNow_us));
  EXPECT_TRUE(received.two().report.now.position_m.allFinite());
  received = ReceiveBytes(EncodeReport(ReportOfTwo()), received);
  EXPECT_TRUE(PredictContact(received.two(), kTestNow_us));
}

TEST(Sentinel, MakesAContactUnusableUntilItsNextReport) {
  for (const SwarmField field :
       {SwarmField::kReporterPos, SwarmField::kReporterVel, SwarmField::kTimeStamp}) {
    Received received;
    received.receiver.plan.of(field) = {kSentinel};
    ReportMessage report = ReportOfTwo();
    if (field == SwarmField::kReporterPos) report.position_m.x() = kNaN;
    if (field == SwarmField::kReporterVel) report.velocity_mps.x() = kNaN;
    if (field == SwarmField::kTimeStamp) report.time_stamp_s = kNaN;
    received = ReceiveBytes(EncodeReport(report), received);
    EXPECT_EQ(received.reception.result, ReceptionResult::kRecovered);
    EXPECT_FALSE(PredictContact(received.two(), kTestNow_us)) << NameOf(field);
    EXPECT_EQ(received.two().log.entries.size(), 2U) << NameOf(field);
    received = ReceiveBytes(EncodeReport(ReportOfTwo()), received);
    EXPECT_TRUE(PredictContact(received.two(), kTestNow_us)) << NameOf(field);
  }
}

TEST(Sentinel, InTheTimesOfAnswersAsksForNone) {
  for (const RecoveryStrategy strategy : {kSentinel, kSkipField}) {
    Received received;
    received.receiver.plan.of(SwarmField::kRspnStart) = {strategy};
    BroadcastMessage request = RequestToFour();
    request.response_start_s = kNaN;
    received = ReceiveBytes(EncodeBroadcast(request), received);
    EXPECT_EQ(received.reception.result, ReceptionResult::kRecovered);
    EXPECT_EQ(received.receiver.state.request, std::nullopt);
    EXPECT_EQ(received.receiver.state.response_start_us, 12'000'000);
  }
}

}  // namespace shoal::receive_damaged_test
