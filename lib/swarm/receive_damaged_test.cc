// What the ear of a vehicle does with damaged fields of whole messages.
#include <gtest/gtest.h>

#include <limits>

#include "lib/swarm/test_group.h"

namespace shoal {
namespace {

using enum RecoveryStrategy;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

TEST(Receive, MendsAPositionBeyond100Km) {
  ReportMessage report = ReportOfTwo();
  report.position_m.x() = 3e38F;
  const Heard heard = Hear(EncodeReport(report));
  EXPECT_EQ(heard.reception.recoveries,
            (std::vector<FieldRecovery>{{.field = SwarmField::kReporterPos,
                                         .fault = FieldFault::kTooFar,
                                         .strategy = kPredict,
                                         .id = 2}}));
  EXPECT_EQ(heard.two().report.now.position_m.x(), 205 + 5 * 1.5);
}

TEST(Receive, MendsAPositionForTheTimeStampThatItCameWith) {
  ReportMessage report = ReportOfTwo();
  report.position_m.x() = kNaN;
  report.time_stamp_s = 14;
  const SwarmContact mended = Hear(EncodeReport(report)).two();
  EXPECT_EQ(mended.report.now.position_m.x(), 205 + 4 * 1.5);
  report.time_stamp_s = kNaN;
  EXPECT_EQ(Hear(EncodeReport(report)).two().report.now.position_m.x(), 205 + 6 * 1.5);
  BroadcastMessage request = RequestToFour();
  request.followers[0].position_m.x() = kNaN;
  request.followers[0].reported_s = 12;
  EXPECT_EQ(Hear(EncodeBroadcast(request)).two().report.now.position_m.x(), 205 + 2 * 1.5);
}

TEST(Receive, MendsARequestWhoseAnswersShouldHaveBegun) {
  BroadcastMessage request = RequestToFour();
  request.response_start_s = 15.5F;
  const Heard heard = Hear(EncodeBroadcast(request));
  ASSERT_EQ(heard.reception.recoveries.size(), 1U);
  EXPECT_EQ(heard.reception.recoveries[0].fault, FieldFault::kInThePast);
  EXPECT_EQ(heard.receiver.state.request->start_us, 12'000'000 + 5'000'000);

  Heard lenient;
  lenient.receiver.limits.late_start_us = 1'000'000;
  lenient = Hear(EncodeBroadcast(request), lenient);
  EXPECT_EQ(lenient.reception.result, ReceptionResult::kClean);
  EXPECT_EQ(lenient.receiver.state.request->start_us, 15'500'000);
}

TEST(Receive, MendsATimeOfAFollowerWhateverTheTimesOfOthersAre) {
  Heard heard;
  heard.receiver.plan.of(SwarmField::kFollowersRspn) = {kNeutral};
  BroadcastMessage request = RequestToFour();
  request.followers[2].reported_s = kNaN;
  heard = Hear(EncodeBroadcast(request), heard);
  EXPECT_EQ(heard.receiver.state.members[1].reported_us, kTestNow_us);
}

TEST(Receive, MendsADamagedIdOfTheScheduleByTheOneBefore) {
  BroadcastMessage request = RequestToFour();
  request.followers[2].id = 4 + 0x10000;
  const Heard heard = Hear(EncodeBroadcast(request));
  ASSERT_EQ(heard.reception.recoveries.size(), 1U);
  EXPECT_EQ(heard.reception.recoveries[0].strategy, kPredict);
  EXPECT_EQ(heard.receiver.state.response_order, (std::vector<int64_t>{2, 3, 4, 5}));
  EXPECT_EQ(heard.receiver.state.members[1].report.now.position_m.x(), 400);
}

TEST(Receive, WillNotGuessWhoIsWhoWithAScheduleOfAnotherLength) {
  Heard before;
  before.receiver.state.response_order = {2, 3};
  BroadcastMessage request = RequestToFour();
  request.followers[0].id = 0;
  const Heard heard = Hear(EncodeBroadcast(request), before);
  EXPECT_EQ(heard.reception.reason, RejectReason::kUnrecoverable);
  EXPECT_EQ(heard.reception.field, SwarmField::kRspnSched);
  EXPECT_EQ(heard.receiver.state, before.receiver.state);
}

TEST(Receive, MendsTheNumberOfFollowersBeforeItReadsWhatComesBehind) {
  Heard predicting;
  predicting.receiver.plan.of(SwarmField::kNumFollowers) = {kPredict};
  std::vector<uint8_t> bytes = EncodeBroadcast(RequestToFour());
  bytes[kNumFollowersOffset + 3] = 0x40;
  const Heard heard = Hear(bytes, predicting);
  EXPECT_EQ(heard.reception.result, ReceptionResult::kRecovered);
  EXPECT_EQ(heard.receiver.state, Hear(EncodeBroadcast(RequestToFour())).receiver.state);
}

TEST(Receive, TellsEachFieldThatItMendedWhyAndHow) {
  ReportMessage report = ReportOfTwo();
  report.flag = {'R', 'P', 'R', 'U'};
  report.group_id = 0;
  report.velocity_mps.x() = kNaN;
  report.time_stamp_s = -1;
  const Heard heard = Hear(EncodeReport(report));
  EXPECT_EQ(heard.reception.result, ReceptionResult::kRecovered);
  std::vector<std::string_view> told;
  for (const FieldRecovery& recovery : heard.reception.recoveries) {
    told.insert(told.end(),
                {NameOf(recovery.field), TextOf(recovery.fault), NameOf(recovery.strategy)});
  }
  EXPECT_EQ(told,
            (std::vector<std::string_view>{"type", "not a type of message", "predict",      //
                                           "group_id", "not a letter or digit", "predict",  //
                                           "time_stamp", "before time 0", "predict",        //
                                           "reporter_vel", "not a finite number", "predict"}));
  const auto& counts = heard.receiver.counts.recovered_by;
  EXPECT_EQ(counts[static_cast<size_t>(SwarmField::kReporterVel)][static_cast<size_t>(kPredict)],
            1);
  EXPECT_EQ(heard.two().reported_us, 15'000'000);  // 10 s and the 5 s between the two before.
}

TEST(Receive, DropsAMessageWhoseFlagIsMendedWithWhatIsNoFlag) {
  for (const RecoveryStrategy strategy : {kNeutral, kSentinel, kSkipField, kPrevious}) {
    Heard heard;
    heard.receiver.plan.of(SwarmField::kType) = {strategy};
    std::vector<uint8_t> bytes = EncodeReport(ReportOfTwo());
    bytes[0] = 'X';
    heard = Hear(bytes, heard);
    EXPECT_EQ(heard.reception.reason, RejectReason::kUnrecoverable);
    EXPECT_EQ(heard.reception.field, SwarmField::kType);
  }
}

TEST(Receive, DoesNotLetAMendedTimeBeLaterThanNow) {
  Heard heard;
  heard.receiver.state.members[0].log.entries[0].time_us = 100'000;  // 9.9 s between its reports.
  ReportMessage report = ReportOfTwo();
  report.time_stamp_s = kNaN;
  heard = Hear(EncodeReport(report), heard);
  EXPECT_EQ(heard.two().reported_us, kTestNow_us);
}

TEST(SkipField, KeepsWhatWasKnownAndTakesTheRest) {
  Heard heard;
  heard.receiver.plan.of(SwarmField::kReporterPos) = {kSkipField};
  ReportMessage report = ReportOfTwo();
  report.position_m.y() = kNaN;
  heard = Hear(EncodeReport(report), heard);
  EXPECT_EQ(heard.reception.result, ReceptionResult::kRecovered);
  EXPECT_EQ(heard.two().report.now.position_m, Eigen::Vector3d(205, 0, 10));
  EXPECT_EQ(heard.two().report.now.velocity_mps, Eigen::Vector3d(1.25, 0.5, 0));
  EXPECT_EQ(heard.two().reported_us, 15'000'000);
  EXPECT_EQ(heard.two().log.entries.size(), 2U);
}

TEST(SkipField, LeavesAFieldUnknownThatNeverWasKnown) {
  Heard heard;
  heard.receiver.state.members[0] = SwarmContact{.id = 2};
  heard.receiver.plan.of(SwarmField::kReporterPos) = {kSkipField};
  ReportMessage report = ReportOfTwo();
  report.position_m.y() = kNaN;
  heard = Hear(EncodeReport(report), heard);
  EXPECT_FALSE(PredictContact(heard.two(), kTestNow_us));
  EXPECT_TRUE(heard.two().report.now.position_m.allFinite());
  heard = Hear(EncodeReport(ReportOfTwo()), heard);
  EXPECT_TRUE(PredictContact(heard.two(), kTestNow_us));
}

TEST(Sentinel, MakesAContactUnusableUntilItsNextReport) {
  for (const SwarmField field :
       {SwarmField::kReporterPos, SwarmField::kReporterVel, SwarmField::kTimeStamp}) {
    Heard heard;
    heard.receiver.plan.of(field) = {kSentinel};
    ReportMessage report = ReportOfTwo();
    if (field == SwarmField::kReporterPos) report.position_m.x() = kNaN;
    if (field == SwarmField::kReporterVel) report.velocity_mps.x() = kNaN;
    if (field == SwarmField::kTimeStamp) report.time_stamp_s = kNaN;
    heard = Hear(EncodeReport(report), heard);
    EXPECT_EQ(heard.reception.result, ReceptionResult::kRecovered);
    EXPECT_FALSE(PredictContact(heard.two(), kTestNow_us)) << NameOf(field);
    EXPECT_EQ(heard.two().log.entries.size(), 2U) << NameOf(field);
    heard = Hear(EncodeReport(ReportOfTwo()), heard);
    EXPECT_TRUE(PredictContact(heard.two(), kTestNow_us)) << NameOf(field);
  }
}

TEST(Sentinel, InTheTimesOfAnswersAsksForNone) {
  for (const RecoveryStrategy strategy : {kSentinel, kSkipField}) {
    Heard heard;
    heard.receiver.plan.of(SwarmField::kRspnStart) = {strategy};
    BroadcastMessage request = RequestToFour();
    request.response_start_s = kNaN;
    heard = Hear(EncodeBroadcast(request), heard);
    EXPECT_EQ(heard.reception.result, ReceptionResult::kRecovered);
    EXPECT_EQ(heard.receiver.state.request, std::nullopt);
    EXPECT_EQ(heard.receiver.state.response_start_us, 12'000'000);
  }
}

}  // namespace
}  // namespace shoal
