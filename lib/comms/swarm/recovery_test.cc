#include "lib/comms/swarm/recovery.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/group_testing.h"

namespace shoal::recovery_test {

using enum RecoveryStrategy;

const Eigen::Vector3d kBad = Eigen::Vector3d::Constant(std::nan(""));
const FieldSubject kTwo{.id = 2};
const FieldSubject kLeader{.is_leader = true};

template <class Value>
std::optional<Value> RecoveredBy(RecoveryStrategy strategy, const DamagedField& damaged,
                                 const GroupState& state) {
  const auto value = RecoverBy(strategy, damaged, {state, {}, kTestNow_us});
  if (!value) return std::nullopt;
  return std::get<Value>(*value);
}

TEST(RecoverPrevious, KnowsMembersThoughThereIsALeader) {
  const GroupState state = FollowerThree().state;
  EXPECT_EQ(RecoveredBy<Eigen::Vector3d>(kPrevious, {SwarmField::kReporterPos, kBad, kTwo}, state),
            Eigen::Vector3d(205, 0, 10));
  EXPECT_EQ(RecoveredBy<double>(kPrevious, {SwarmField::kTimeStamp, -5.0, kTwo}, state), 10.0);
  EXPECT_EQ(RecoveredBy<uint8_t>(kPrevious, {SwarmField::kGroupId, uint8_t{0}, kTwo}, state), 'A');
}

TEST(RecoverPrevious, HasNothingOfAnUnknownContact) {
  GroupState state = FollowerThree().state;
  state.members[0] = SwarmContact{.id = 2};
  EXPECT_FALSE(
      RecoveredBy<Eigen::Vector3d>(kPrevious, {SwarmField::kReporterPos, kBad, kTwo}, state));
  state.target.reset();
  EXPECT_FALSE(
      RecoveredBy<Eigen::Vector3d>(kPrevious, {SwarmField::kLeaderPos, kBad, kLeader}, state));
}

TEST(RecoverPrevious, DoesNotPassASentinelOn) {
  GroupState state = FollowerThree().state;
  state.members[0].report.now.position_m.setConstant(SentinelValues().position_m);
  EXPECT_FALSE(
      RecoveredBy<Eigen::Vector3d>(kPrevious, {SwarmField::kReporterPos, kBad, kTwo}, state));
}

TEST(RecoverPredict, CountsFollowersByItsOwnRoleNotTheSenders) {
  GroupState state = FollowerThree().state;
  const DamagedField damaged{SwarmField::kNumFollowers, int64_t{0}, kLeader};
  EXPECT_EQ(RecoveredBy<int64_t>(kPredict, damaged, state), 4);
  state.is_leader = true;
  EXPECT_EQ(RecoveredBy<int64_t>(kPredict, damaged, state), 3);
}

TEST(RecoverPredict, MovesAPositionOnFromItsReportWhateverTheDelayWas) {
  GroupState state = FollowerThree().state;
  state.members[0].arrived_us = state.members[0].reported_us;
  const auto position_m =
      RecoveredBy<Eigen::Vector3d>(kPredict, {SwarmField::kReporterPos, kBad, kTwo}, state);
  ASSERT_TRUE(position_m);
  EXPECT_TRUE(position_m->isApprox(Eigen::Vector3d(205 + 6 * 1.5, 0, 10)));
}

TEST(RecoverPredict, MovesAPositionAtConstantVelocityAndAVelocityAtConstantAcceleration) {
  const GroupState state = FollowerThree().state;
  const auto position_m =
      RecoveredBy<Eigen::Vector3d>(kPredict, {SwarmField::kLeaderPos, kBad, kLeader}, state);
  const auto velocity_mps =
      RecoveredBy<Eigen::Vector3d>(kPredict, {SwarmField::kLeaderVel, kBad, kLeader}, state);
  ASSERT_TRUE(position_m && velocity_mps);
  EXPECT_TRUE(position_m->isApprox(Eigen::Vector3d(114, 0, 10)));
  EXPECT_TRUE(velocity_mps->isApprox(Eigen::Vector3d(1.5 + 6 * 0.1, 0, 0)));
}

TEST(RecoverPredict, MakesNothingOfTwoReportsOfTheSameTime) {
  GroupState state = FollowerThree().state;
  state.members[0].log.entries[0].time_us = state.members[0].log.entries[1].time_us;
  EXPECT_FALSE(
      RecoveredBy<Eigen::Vector3d>(kPredict, {SwarmField::kReporterVel, kBad, kTwo}, state));
}

TEST(RecoverPredict, DoesNotPredictWhatItWouldNotHaveBelieved) {
  GroupState state = FollowerThree().state;
  state.members[0].log.entries[1] = {.time_us = 5'000'001, .motion = {.velocity_mps = {99, 0, 0}}};
  EXPECT_FALSE(
      RecoveredBy<Eigen::Vector3d>(kPredict, {SwarmField::kReporterVel, kBad, kTwo}, state));
  state.members[0].log.entries[1].motion.position_m.x() = 99'999;
  EXPECT_FALSE(
      RecoveredBy<Eigen::Vector3d>(kPredict, {SwarmField::kReporterPos, kBad, kTwo}, state));
}

TEST(RecoverPredict, TakesAnEarlyUnknownTimeForTheBeginning) {
  const GroupState state{.episode_us = 5'000'000};
  const DamagedField damaged{SwarmField::kTimeStamp, -5.0, {}};
  EXPECT_EQ(std::get<double>(RecoverBy(kPredict, damaged, {state, {}, 1'000'000}).value()), 0);
}

TEST(RecoverPredict, HasNoReporterInAnEmptyGroup) {
  EXPECT_FALSE(RecoveredBy<int64_t>(kPredict, {SwarmField::kReporterId, int64_t{0}, {}}, {}));
}

TEST(RecoverNeutral, NumbersTheScheduleAsMuNetNumbersItsVehicles) {
  const DamagedField damaged{SwarmField::kRspnSched, std::vector<int64_t>{9, 0, 0}, {}};
  EXPECT_EQ(RecoveredBy<std::vector<int64_t>>(kNeutral, damaged, {}),
            (std::vector<int64_t>{2, 3, 4}));
}

TEST(NearestFlag, RecoversUpToSevenBits) {
  EXPECT_EQ(NearestFlag({'S', 'P', 'R', 'T'}), kReportFlag);
  EXPECT_EQ(NearestFlag({'Z', 'Z', 'Z', 'Z'}), kReportFlag);          // 7 bits.
  EXPECT_EQ(NearestFlag({'Z', 'Z', 'Z', 'Z' ^ 0x20}), std::nullopt);  // 8 bits.
  EXPECT_EQ(NearestFlag({0, 0, 0, 0}), std::nullopt);
}

TEST(NearestFlag, TakesFewRandomWordsForAFlag) {
  std::minstd_rand random(1);
  int num_taken = 0;
  constexpr int kNumWords = 100'000;
  for (int i = 0; i < kNumWords; ++i) {
    MessageFlag flag;
    for (char& letter : flag) letter = static_cast<char>(random() >> 8);
    if (NearestFlag(flag)) ++num_taken;
  }
  EXPECT_NEAR(num_taken, kNumWords * 0.0042, kNumWords * 0.001);  // muNet: 70 %.
}

TEST(Recover, TakesTheFirstStrategyThatHasAnAnswer) {
  RecoveryPlan plan;
  plan.of(SwarmField::kReporterPos) = {kPredict, kPrevious, kNeutral};
  GroupState state = FollowerThree().state;
  const DamagedField damaged{SwarmField::kReporterPos, kBad, kTwo};
  const auto strategy = [&] {
    return Recover(plan, damaged, {state, {}, kTestNow_us}).value().strategy;
  };
  EXPECT_EQ(strategy(), kPredict);
  state.members[0].log = {};
  EXPECT_EQ(strategy(), kPrevious);
  state.members[0].is_known = false;
  EXPECT_EQ(strategy(), kNeutral);
}

TEST(Recover, DropsTheMessageWithoutAnyStrategyOrBySkip) {
  RecoveryPlan plan;
  plan.of(SwarmField::kReporterPos) = {};
  const GroupState state = FollowerThree().state;
  const DamagedField damaged{SwarmField::kReporterPos, kBad, kTwo};
  EXPECT_FALSE(Recover(plan, damaged, {state, {}, kTestNow_us}));
  plan.of(SwarmField::kReporterPos) = {kSkip, kNeutral};
  EXPECT_FALSE(Recover(plan, damaged, {state, {}, kTestNow_us}));
}

}  // namespace shoal::recovery_test
