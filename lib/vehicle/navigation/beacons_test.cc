#include "lib/vehicle/navigation/beacons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"

namespace shoal::beacons_test {

Beacon At(double x_m, BeaconKind kind, double interval_s = 10) {
  return {.name = "b", .position_m = {x_m, 0, 0}, .kind = kind, .interval_s = interval_s};
}

/// Returns when readings come, to a step of 0.1 s, at the origin.
std::vector<double> Times(const AcousticRanging& ranging, const Beacon& beacon, double until_s) {
  BeaconReceiver receiver(ranging, {}, {beacon}, StreamKey(1, "beacon"));
  std::vector<double> times;
  for (int i = 0; i / 10.0 <= until_s; ++i) {
    if (!receiver.Read({0, 0, 0}, 0, i / 10.0).empty()) times.push_back(i / 10.0);
  }
  return times;
}

TEST(Beacons, AreReceivedWhenTheirSoundArrives) {
  EXPECT_EQ(Times({}, At(1500, BeaconKind::kOneWay), 25), (std::vector<double>{1, 11, 21}));
  // There, turnaround, and back.
  EXPECT_EQ(Times({}, At(1500, BeaconKind::kTwoWay), 25), (std::vector<double>{2.1, 12.1, 22.1}));
}

TEST(Beacons, BeginAtTheirOffset) {
  Beacon beacon = At(1500, BeaconKind::kOneWay);
  beacon.offset_s = 4;
  EXPECT_EQ(Times({}, beacon, 24), (std::vector<double>{5, 15}));
}

TEST(Beacons, AreReceivedWithinTheRangeAndNotBeyond) {
  AcousticRanging ranging;
  ranging.max_range_m = 1500;
  EXPECT_EQ(Times(ranging, At(1500, BeaconKind::kOneWay), 9).size(), 1U);
  EXPECT_EQ(Times(ranging, At(1500.01, BeaconKind::kOneWay), 9).size(), 0U);
}

TEST(Beacons, MeasureTheTravelTimeOfTheirSound) {
  // Sound takes a way of 1 % more than the straight one, and none comes from beyond 1600 m.
  const TravelTimes bent = [](const Eigen::Vector3d& from_m,
                              const Eigen::Vector3d& to_m) -> std::optional<double> {
    const double range_m = (to_m - from_m).norm();
    if (range_m > 1600) return std::nullopt;
    return 1.01 * range_m / 1500;
  };
  BeaconReceiver receiver({}, {}, {At(1500, BeaconKind::kOneWay)}, StreamKey(1, "beacon"), bent);
  std::vector<BeaconReading> readings;
  for (int i = 0; i <= 15 && readings.empty(); ++i) {
    readings = receiver.Read({0, 0, 0}, 0, i / 10.0);
  }
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_NEAR(readings[0].range_m, 1515, 1e-3);
  EXPECT_NEAR(receiver.ReadPacket(0, 1, {100, 0, 0}, 0, 5).range_m, 1.01 * 1400, 1e-3);
  BeaconReceiver far({}, {}, {At(1700, BeaconKind::kOneWay)}, StreamKey(1, "beacon"), bent);
  for (int i = 0; i <= 300; ++i) EXPECT_TRUE(far.Read({0, 0, 0}, 0, i / 10.0).empty());
}

TEST(Beacons, AreLostAtTheStatedShare) {
  const int kCount = 4000;
  AcousticRanging ranging;
  ranging.dropout = 0.25;
  const size_t received = Times(ranging, At(15, BeaconKind::kOneWay, 0.1), kCount / 10.0).size();
  // Within 3.29 standard deviations: 99.9 % of good seeds pass.
  EXPECT_NEAR(static_cast<double>(received), 0.75 * kCount, 3.29 * std::sqrt(0.1875 * kCount));
}

TEST(Beacons, AreMeasuredAsTheOthersAreNotThere) {
  AcousticRanging ranging;
  ranging.errors.noise_m = 2;
  const Beacon first = At(150, BeaconKind::kOneWay);
  Beacon second = At(75, BeaconKind::kOneWay);
  second.name = "other";
  BeaconReceiver alone(ranging, {}, {first}, StreamKey(1, "beacon"));
  BeaconReceiver both(ranging, {}, {second, first}, StreamKey(1, "beacon"));
  static_cast<void>(alone.Read({0, 0, 0}, 0, 0));
  static_cast<void>(both.Read({0, 0, 0}, 0, 0));
  const auto one = alone.Read({0, 0, 0}, 0, 1);
  const auto two = both.Read({0, 0, 0}, 0, 1);
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(one[0].range_m, two[1].range_m);
  EXPECT_NE(one[0].range_m, 150);
}

TEST(Beacons, AreSeenInADirectionByAnArrayOnly) {
  AcousticRanging ranging;
  BeaconReceiver without(ranging, {}, {At(150, BeaconKind::kTwoWay)}, StreamKey(1, "beacon"));
  ranging.usbl.emplace();
  BeaconReceiver with(ranging, {}, {At(150, BeaconKind::kTwoWay)}, StreamKey(1, "beacon"));
  static_cast<void>(without.Read({0, 0, 0}, 0, 0));
  static_cast<void>(with.Read({0, 0, 0}, 0, 0));
  EXPECT_FALSE(without.Read({0, 0, 0}, 0, 1).at(0).direction);
  const BeaconReading reading = with.Read({0, 0, 0}, 0, 1).at(0);
  ASSERT_TRUE(reading.direction);
  EXPECT_NEAR(reading.direction->bearing_rad, DegToRad(90), 1e-12);
  EXPECT_EQ(reading.direction->range_m, reading.range_m);
}

TEST(Beacons, AreRangedByTheirPacketsWhenTheseCome) {
  BeaconReceiver receiver({}, {.phase_s = 0.01}, {At(150, BeaconKind::kPackets)},
                          StreamKey(1, "beacon"));
  EXPECT_TRUE(receiver.Read({0, 0, 0}, 0, 0).empty());
  EXPECT_TRUE(receiver.Read({0, 0, 0}, 0, 100).empty());
  // By the own clock.
  EXPECT_NEAR(receiver.ReadPacket(0, 7, {0, 0, 0}, 0, 100).range_m, 165, 0.0015);
}

}  // namespace shoal::beacons_test
