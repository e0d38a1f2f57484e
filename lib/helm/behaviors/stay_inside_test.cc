#include "lib/helm/behaviors/stay_inside.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/random/stream.h"

namespace shoal::stay_inside_test {

const Polygon kSquare = {{-50, -50}, {-50, 50}, {50, 50}, {50, -50}};
const Domain kDomain;

const LookAhead kAtOnce = {.horizon_s = 5, .turn_degps = 0};
const LookAhead kTurning = {.horizon_s = 5, .turn_degps = 10};

TEST(StayInside, AllowsEverythingFarFromTheBorder) {
  EXPECT_TRUE(StayInside(kSquare, {.position_m = {0, 0}}, kTurning, kDomain).speeds.empty());
}

TEST(StayInside, AllowsTowardTheBorderTheDistancePerHorizon) {
  const VesselMotion own = {.position_m = {40, 0}, .heading_deg = 90};
  const AllowedPart allowed = StayInside(kSquare, own, kAtOnce, kDomain);
  EXPECT_EQ(allowed.speeds[90], (IndexRange{.first = 0, .last = 20}));  // 2 m/s for 10 m.
  EXPECT_EQ(allowed.speeds[60], (IndexRange{.first = 0, .last = 23}));
  EXPECT_EQ(allowed.speeds[0], (IndexRange{.first = 0, .last = 40}));
  EXPECT_EQ(allowed.speeds[270], (IndexRange{.first = 0, .last = 40}));
}

TEST(StayInside, AllowsInATurnWhatTheTurnDoesNotTakeOut) {
  const VesselMotion own = {.position_m = {40, 0}, .heading_deg = 90};
  const AllowedPart allowed = StayInside(kSquare, own, kTurning, kDomain);
  EXPECT_EQ(allowed.speeds[90].last, 20);
  EXPECT_EQ(allowed.speeds[60].last, 21);  // 3 s of turning: 10 m / (2.865 + 1.732).
  EXPECT_EQ(allowed.speeds[0].last, 22);   // It turns all the time: 10 m / 4.389.
  const VesselMotion away = {.position_m = {40, 0}, .heading_deg = 350};
  EXPECT_EQ(StayInside(kSquare, away, kTurning, kDomain).speeds[300].last, 40);
}

TEST(StayInside, AllowsOutsideOnlyWhatLeadsBackIn) {
  const VesselMotion own = {.position_m = {60, 0}, .heading_deg = 90};
  const AllowedPart allowed = StayInside(kSquare, own, kTurning, kDomain);
  EXPECT_EQ(allowed.speeds[270], (IndexRange{.first = 20, .last = 40}));
  EXPECT_TRUE(allowed.speeds[0].empty());
  EXPECT_TRUE(allowed.speeds[90].empty());
}

/// A convex polygon of corners on a circle, at times counter-clockwise.
Polygon DrawPolygon(Stream& stream) {
  std::vector<double> bearings_deg;
  for (int i = 0; i < 3 + static_cast<int>(stream.UniformInt(6)); ++i) {
    bearings_deg.push_back(360 * stream.Uniform());
  }
  std::sort(bearings_deg.begin(), bearings_deg.end());
  if (stream.Uniform() < 0.5) std::reverse(bearings_deg.begin(), bearings_deg.end());
  Polygon polygon_m;
  for (const double bearing_deg : bearings_deg) {
    polygon_m.push_back(40 * UnitVector(DegToRad(bearing_deg)));
  }
  return polygon_m;
}

/// Returns the greatest distance outside on the way, in small steps; straight on and in the turn.
double FarthestOutside(const Polygon& polygon_m, VesselMotion own, double course_deg,
                       double speed_mps, const LookAhead& ahead) {
  constexpr double kStep_s = 0.02;
  const Eigen::Vector2d straight = UnitVector(DegToRad(course_deg));
  double farthest_m =
      SignedDistance(polygon_m, own.position_m + speed_mps * ahead.horizon_s * straight);
  if (SignedDistance(polygon_m, own.position_m) > 0) return farthest_m;
  for (double time_s = 0; time_s < ahead.horizon_s; time_s += kStep_s) {
    const double turn_deg = Wrap180(course_deg - own.heading_deg);
    const double most_deg = ahead.turn_degps * kStep_s;
    const double before_deg = own.heading_deg;
    own.heading_deg += std::clamp(turn_deg, -most_deg, most_deg);
    own.position_m +=
        speed_mps * kStep_s * UnitVector(DegToRad(Wrap360((before_deg + own.heading_deg) / 2)));
    farthest_m = std::max(farthest_m, SignedDistance(polygon_m, own.position_m));
  }
  return farthest_m;
}

RC_GTEST_PROP(StayInside, AllowsExactlyWhatStaysInside, ()) {
  Stream stream(*rc::gen::arbitrary<uint64_t>(), "stay inside");
  const Polygon polygon_m = DrawPolygon(stream);
  RC_PRE(IsConvex(polygon_m));
  const VesselMotion own = {
      .position_m = 60 * stream.Uniform() * UnitVector(DegToRad(360 * stream.Uniform())),
      .heading_deg = 360 * stream.Uniform()};
  const LookAhead ahead = {.horizon_s = 1 + 9 * stream.Uniform(),
                           .turn_degps = 5 + 25 * stream.Uniform()};
  const Domain domain = {.speed_mps = {.first = 0, .step = 1, .count = 5}};
  const AllowedPart allowed = StayInside(polygon_m, own, ahead, domain);
  RC_CLASSIFY(allowed.speeds.empty());
  for (size_t course = stream.UniformInt(90); course < 360; course += 90) {
    for (int speed = 0; speed < domain.speed_mps.count; ++speed) {
      const double outside_m =
          FarthestOutside(polygon_m, own, static_cast<double>(course), speed, ahead);
      const bool is_allowed = allowed.speeds.empty() || allowed.speeds[course].Has(speed);
      if (std::abs(outside_m) > 0.05) RC_ASSERT(is_allowed == (outside_m < 0));
    }
  }
}

}  // namespace shoal::stay_inside_test
