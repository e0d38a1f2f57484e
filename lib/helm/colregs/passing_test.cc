#include "lib/helm/colregs/passing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/base/geometry/angles.h"

namespace shoal::passing_test {

const VesselMotion kNorthbound = {.position_m = {0, 0}, .heading_deg = 0, .speed_mps = 1};

TEST(Passing, IsAheadOfAVesselWhoseBowIsCrossedFirst) {
  // From its port side, at right angles: at the line after 10 s, where it is 10 m on, of 30.
  const VesselMotion own = {.position_m = {-20, 30}, .heading_deg = 90, .speed_mps = 2};
  const Passing passing = PassingOf(own, kNorthbound);
  EXPECT_TRUE(passing.crosses);
  EXPECT_TRUE(passing.crosses_bow);
  EXPECT_FALSE(passing.crosses_stern);
  EXPECT_NEAR(CrossingDistance(own, kNorthbound), 20, 1e-9);
}

TEST(Passing, IsAsternWhereTheOtherIsThereFirst) {
  const VesselMotion own = {.position_m = {20, 5}, .heading_deg = 270, .speed_mps = 1};
  const Passing passing = PassingOf(own, kNorthbound);
  EXPECT_TRUE(passing.crosses_stern);
  EXPECT_FALSE(passing.crosses_bow);
  EXPECT_NEAR(CrossingDistance(own, kNorthbound), -15, 1e-9);
}

TEST(Passing, CrossesNothingWhereItGoesAway) {
  const VesselMotion own = {.position_m = {20, 5}, .heading_deg = 90, .speed_mps = 1};
  EXPECT_FALSE(PassingOf(own, kNorthbound).crosses);
  EXPECT_EQ(CrossingDistance(own, kNorthbound), std::numeric_limits<double>::infinity());
}

TEST(Passing, OvertakesOnTheSideOnWhichItIs) {
  const VesselMotion to_port = {.position_m = {-5, -30}, .heading_deg = 0, .speed_mps = 2};
  EXPECT_TRUE(PassingOf(to_port, kNorthbound).passes);
  EXPECT_TRUE(PassingOf(to_port, kNorthbound).passes_port);
  const VesselMotion to_starboard = {.position_m = {5, -30}, .heading_deg = 0, .speed_mps = 2};
  EXPECT_FALSE(PassingOf(to_starboard, kNorthbound).passes_port);
  const VesselMotion slower = {.position_m = {5, -30}, .heading_deg = 0, .speed_mps = 0.5};
  EXPECT_FALSE(PassingOf(slower, kNorthbound).passes);
}

TEST(Passing, MeetsPortToPortWhereTheBearingDriftsToTheLeft) {
  const VesselMotion own = {.position_m = {-4, 50}, .heading_deg = 180, .speed_mps = 1};
  const Passing passing = PassingOf(own, kNorthbound);
  EXPECT_TRUE(passing.passes);
  EXPECT_LT(passing.bearing_rate_degps, 0);
  EXPECT_TRUE(passing.passes_port);
}

VesselMotion DrawVessel() {
  const auto real = [](int from, int to) {
    return *rc::gen::inRange(from * 100, to * 100) / 100.0;
  };
  return {.position_m = {real(-80, 80), real(-80, 80)},
          .heading_deg = real(0, 360),
          .speed_mps = real(0, 4)};
}

VesselMotion Mirrored(const VesselMotion& vessel) {
  return {.position_m = {-vessel.position_m.x(), vessel.position_m.y()},
          .heading_deg = Wrap360(-vessel.heading_deg),
          .speed_mps = vessel.speed_mps};
}

RC_GTEST_PROP(Passing, IsTheMirrorImageInAMirror, ()) {
  const VesselMotion own = DrawVessel();
  const VesselMotion contact = DrawVessel();
  RC_PRE((own.position_m - contact.position_m).norm() > 1);
  const Passing seen = PassingOf(own, contact);
  const Passing mirrored = PassingOf(Mirrored(own), Mirrored(contact));
  RC_PRE(std::abs(seen.bearing_rate_degps) > 1e-9);
  RC_PRE(std::abs(CrossingDistance(own, contact)) < 1e6);
  RC_ASSERT(std::abs(seen.bearing_rate_degps + mirrored.bearing_rate_degps) < 1e-9);
  RC_ASSERT(seen.passes_port != mirrored.passes_port);
  RC_ASSERT(seen.crosses_bow == mirrored.crosses_bow);
  RC_ASSERT(seen.crosses_stern == mirrored.crosses_stern);
}

RC_GTEST_PROP(Passing, CrossesTheBowWhereTheCrossingIsAhead, ()) {
  const VesselMotion own = DrawVessel();
  const VesselMotion contact = DrawVessel();
  RC_PRE((own.position_m - contact.position_m).norm() > 1);
  const double ahead_m = CrossingDistance(own, contact);
  RC_PRE(std::isfinite(ahead_m) && std::abs(ahead_m) > 1e-6);
  const Passing passing = PassingOf(own, contact);
  RC_ASSERT(passing.crosses);
  RC_ASSERT(passing.crosses_bow == (ahead_m > 0));
  RC_ASSERT(passing.crosses_stern == (ahead_m < 0));
}

TEST(Passing, CrossesNothingOnTheOthersOwnCourse) {
  for (int heading_deg = 0; heading_deg < 360; ++heading_deg) {
    const double rad = DegToRad(heading_deg);
    const VesselMotion contact = {
        .position_m = {3, 4}, .heading_deg = static_cast<double>(heading_deg), .speed_mps = 2};
    const VesselMotion own = {
        .position_m = contact.position_m + 20 * UnitVector(rad) + 7 * UnitVector(rad + kPi / 2),
        .heading_deg = static_cast<double>(heading_deg),
        .speed_mps = 2};
    const Passing passing = PassingOf(own, contact);
    EXPECT_FALSE(passing.crosses) << heading_deg;
    EXPECT_FALSE(passing.passes) << heading_deg;
    EXPECT_EQ(CrossingDistance(own, contact), std::numeric_limits<double>::infinity());
  }
}

}  // namespace shoal::passing_test
