#include "lib/routing/decide.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace shoal {
namespace {

constexpr int64_t kNow = 1'000'000'000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Contact ReceiverAt(double x_m, double y_m, double depth_m, int64_t age_us = 0) {
  Contact receiver;
  receiver.position_m = {x_m, y_m, depth_m};
  receiver.received_utime = kNow - age_us;
  return receiver;
}

Decision Decide(const RoutingRules& rules, const Contact& receiver) {
  return DecideReport(rules, Eigen::Vector3d::Zero(), receiver, kNow);
}

TEST(RangeRule, LetsAReportThroughJustInsideTheRange) {
  const Decision decision =
      Decide({.comms_range_m = 250}, ReceiverAt(std::nextafter(250, 0), 0, 0));
  EXPECT_EQ(decision.cause, Cause::kDelivered);
}

TEST(RangeRule, StopsAReportAtTheRange) {
  const Decision decision = Decide({.comms_range_m = 250}, ReceiverAt(0, -250, 0));
  EXPECT_EQ(decision.cause, Cause::kOutOfRange);
  EXPECT_EQ(decision.range_m, 250);
  EXPECT_EQ(decision.limit_m, 250);
}

TEST(RangeRule, CountsTheDepth) {
  const Contact receiver = ReceiverAt(2, 3, 6);
  EXPECT_EQ(Decide({.comms_range_m = 7}, receiver).cause, Cause::kOutOfRange);
  EXPECT_EQ(Decide({.comms_range_m = 7.001}, receiver).cause, Cause::kDelivered);
}

TEST(RangeRule, HasNoLimitWhereTheRangeIsNegative) {
  const Decision decision = Decide({.comms_range_m = -1}, ReceiverAt(1e9, 0, 0));
  EXPECT_EQ(decision.cause, Cause::kDelivered);
  EXPECT_EQ(decision.range_m, 1e9);
  EXPECT_EQ(decision.limit_m, -1);
}

TEST(RangeRule, LetsNothingThroughWhereTheRangeIsZero) {
  EXPECT_EQ(Decide({.comms_range_m = 0}, ReceiverAt(0, 0, 0)).cause, Cause::kOutOfRange);
}

TEST(RangeRule, StandsDistancesBeyondAllNumbers) {
  const Decision decision = Decide({.comms_range_m = 100}, ReceiverAt(1e308, 1e308, 1e308));
  EXPECT_EQ(decision.cause, Cause::kOutOfRange);
  EXPECT_EQ(decision.range_m, kInfinity);
}

TEST(StaleRule, HearsAVehicleJustYoungerThanTheStaleTime) {
  const Decision decision = Decide({.stale_time_s = 5}, ReceiverAt(1, 0, 0, 4'999'999));
  EXPECT_EQ(decision.cause, Cause::kDelivered);
  EXPECT_EQ(decision.age_s, 4.999999);
  EXPECT_EQ(decision.age_limit_s, 5);
}

TEST(StaleRule, StopsReportsToAVehicleAsOldAsTheStaleTime) {
  const Decision decision = Decide({.stale_time_s = 5}, ReceiverAt(1, 0, 0, 5'000'000));
  EXPECT_EQ(decision.cause, Cause::kStaleReceiver);
  EXPECT_EQ(decision.age_s, 5);
  EXPECT_EQ(decision.range_m, -1) << "the range was not asked";
}

TEST(StaleRule, ComesBeforeTheRange) {
  EXPECT_EQ(Decide({.comms_range_m = 0}, ReceiverAt(1, 0, 0, 9'000'000)).cause,
            Cause::kStaleReceiver);
}

TEST(StaleRule, NeverHoldsWhereTheStaleTimeIsNegative) {
  const Decision decision = Decide({.stale_time_s = -1}, ReceiverAt(1, 0, 0, kNow));
  EXPECT_EQ(decision.cause, Cause::kDelivered);
  EXPECT_EQ(decision.age_limit_s, -1);
}

TEST(StaleRule, AlwaysHoldsWhereTheStaleTimeIsZero) {
  EXPECT_EQ(Decide({.stale_time_s = 0}, ReceiverAt(1, 0, 0)).cause, Cause::kStaleReceiver);
}

RC_GTEST_PROP(DecideReport, DeliversExactlyWhatIsFreshAndNear, ()) {
  const auto within = [](int limit) { return *rc::gen::inRange(-1, limit); };
  const RoutingRules rules = {.comms_range_m = static_cast<double>(within(20)),
                              .stale_time_s = static_cast<double>(within(5))};
  const int age_s = *rc::gen::inRange(0, 7);
  const Contact receiver = ReceiverAt(within(15), within(15), within(5), age_s * 1'000'000);
  const bool fresh = rules.stale_time_s < 0 || age_s < rules.stale_time_s;
  const bool near = rules.comms_range_m < 0 ||
                    receiver.position_m.squaredNorm() < rules.comms_range_m * rules.comms_range_m;
  const Decision decision = Decide(rules, receiver);
  RC_ASSERT((decision.cause == Cause::kDelivered) == (fresh && near));
  RC_ASSERT((decision.cause == Cause::kStaleReceiver) == !fresh);
  RC_ASSERT(IsStale(rules, receiver.received_utime, kNow) == !fresh);
}

}  // namespace
}  // namespace shoal
