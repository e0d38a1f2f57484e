#include "lib/helm/decision/shapes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace shoal::shapes_test {

constexpr Axis kSpeed = {.first = 0, .step = 0.1, .count = 41};
constexpr Axis kDepth = {.first = 0, .step = 1, .count = 101};

double At(const std::vector<double>& values, int index) {
  return values.at(static_cast<size_t>(index));
}

TEST(PeakOverCourse, FallsFromTheSummitAcrossNorth) {
  // Summit 350, peak 20 with delta 10, base 40: 100, 95 (10 away), 90 (20), 45 (40), 0 (60).
  const auto values = PeakOverCourse(350, 20, 40, 10);
  ASSERT_EQ(values.size(), 360U);
  EXPECT_DOUBLE_EQ(At(values, 350), 100);
  EXPECT_DOUBLE_EQ(At(values, 0), 95);
  EXPECT_DOUBLE_EQ(At(values, 340), 95);
  EXPECT_DOUBLE_EQ(At(values, 10), 90);
  EXPECT_DOUBLE_EQ(At(values, 30), 45);
  EXPECT_DOUBLE_EQ(At(values, 310), 45);
  EXPECT_DOUBLE_EQ(At(values, 50), 0);
  EXPECT_DOUBLE_EQ(At(values, 170), 0);
}

TEST(PeakOverCourse, DoesNotRoundTheSummit) {
  const auto values = PeakOverCourse(90.25, 0, 180);
  EXPECT_DOUBLE_EQ(At(values, 90), 100 * (1 - 0.25 / 180));
  EXPECT_DOUBLE_EQ(At(values, 91), 100 * (1 - 0.75 / 180));
}

TEST(PeakOverCourse, TakesSummitsOutsideOf0To360) {
  EXPECT_EQ(PeakOverCourse(-10, 5, 90), PeakOverCourse(350, 5, 90));
  EXPECT_EQ(PeakOverCourse(725, 5, 90), PeakOverCourse(5, 5, 90));
}

TEST(PeakOverCourse, KeepsAPeakThatFallsBetweenTwoCourses) {
  const auto values = PeakOverCourse(359.7, 0.1, 0.1, 0, 5, 80);
  EXPECT_EQ(At(values, 0), 80);
  EXPECT_EQ(std::count(values.begin(), values.end(), 5.0), 359);
  EXPECT_EQ(At(PeakOverCourse(12.5, 0, 0), 12), 100);
}

RC_GTEST_PROP(PeakOverCourse, TurnsWithItsSummit, ()) {
  const int turn = *rc::gen::inRange(0, 360);
  const double summit_deg = *rc::gen::inRange(0, 3600) / 10.0;
  const double peak_deg = *rc::gen::inRange(0, 90);
  const double base_deg = *rc::gen::inRange(1, 90);
  const auto values = PeakOverCourse(summit_deg, peak_deg, base_deg, 20);
  const auto turned = PeakOverCourse(summit_deg + turn, peak_deg, base_deg, 20);
  for (int course = 0; course < 360; ++course) {
    RC_ASSERT(std::abs(At(values, course) - At(turned, (course + turn) % 360)) < 1e-9);
  }
}

TEST(PeakOverAxis, HasTheValuesOfTheWaypointsSpeedPart) {
  // The reference's PEAK(v, v/2, 1.6, delta 20) at v = 2.
  const auto values = PeakOverAxis(kSpeed, 2, 1, 1.6, 20);
  ASSERT_EQ(values.size(), 41U);
  EXPECT_NEAR(At(values, 20), 100, 1e-12);
  EXPECT_NEAR(At(values, 15), 90, 1e-12);
  EXPECT_NEAR(At(values, 10), 80, 1e-12);
  EXPECT_NEAR(At(values, 30), 80, 1e-12);
  EXPECT_NEAR(At(values, 2), 40, 1e-12);
  EXPECT_NEAR(At(values, 0), 30, 1e-12);
  EXPECT_NEAR(At(values, 38), 40, 1e-12);
}

TEST(PeakOverAxis, IgnoresDeltaWithoutPeakWidth) {
  const auto values = PeakOverAxis(kSpeed, 2, 0, 0.4, 30);
  EXPECT_NEAR(At(values, 20), 100, 1e-9);
  EXPECT_NEAR(At(values, 22), 50, 1e-9);
  EXPECT_NEAR(At(values, 24), 0, 1e-9);
}

TEST(PeakOverAxis, HasPlateausWhoseEdgesAreGridPoints) {
  const auto values = PeakOverAxis(kSpeed, 2, 0.3, 0, 0);  // 17 .. 23, whatever 23 * 0.1 is.
  EXPECT_EQ(std::count(values.begin(), values.end(), 100.0), 7);
  EXPECT_EQ(At(values, 17), 100);
  EXPECT_EQ(At(values, 23), 100);
}

TEST(PeakOverAxis, InsistsOnTheNearestPointOfASummitOutside) {
  const auto above = PeakOverAxis(kSpeed, 9, 0, 0.5);
  EXPECT_EQ(At(above, 40), 100);
  EXPECT_EQ(std::count(above.begin(), above.end(), 0.0), 40);
  EXPECT_EQ(At(PeakOverAxis(kSpeed, -3, 0, 0.5), 0), 100);
}

TEST(SpeedPolyline, GoesThroughItsFivePoints) {
  const auto values = SpeedPolyline(kSpeed, 2, 0.1, 2.4, 70, 20);
  ASSERT_EQ(values.size(), 41U);
  EXPECT_DOUBLE_EQ(At(values, 0), 0);
  EXPECT_DOUBLE_EQ(At(values, 1), 70);
  EXPECT_NEAR(At(values, 10), 70 + 30 * 9.0 / 19, 1e-9);
  EXPECT_DOUBLE_EQ(At(values, 20), 100);
  EXPECT_DOUBLE_EQ(At(values, 22), 60);
  EXPECT_DOUBLE_EQ(At(values, 24), 20);
  EXPECT_DOUBLE_EQ(At(values, 32), 10);
  EXPECT_DOUBLE_EQ(At(values, 40), 0);
}

TEST(SpeedPolyline, DropsPointsThatCoincide) {
  const auto stopped = SpeedPolyline(kSpeed, 0, 0, 0.4, 70, 20);
  ASSERT_EQ(stopped.size(), 41U);
  EXPECT_EQ(At(stopped, 0), 100);
  EXPECT_EQ(At(stopped, 4), 20);
  const auto fastest = SpeedPolyline(kSpeed, 4, 0.1, 4.4, 70, 20);
  ASSERT_EQ(fastest.size(), 41U);
  EXPECT_EQ(At(fastest, 40), 100);
  EXPECT_EQ(At(fastest, 1), 70);
  const auto near_the_end = SpeedPolyline(kSpeed, 3.8, 0.1, 4.2, 70, 20);
  EXPECT_EQ(At(near_the_end, 38), 100);
  EXPECT_EQ(At(near_the_end, 40), 20);
}

TEST(HeadingPolyline, HasItsKneesLeftAndRight) {
  const auto values = HeadingPolyline(350, 20, 40, 25, 60);
  EXPECT_DOUBLE_EQ(At(values, 350), 100);
  EXPECT_DOUBLE_EQ(At(values, 330), 25);
  EXPECT_DOUBLE_EQ(At(values, 340), 62.5);
  EXPECT_DOUBLE_EQ(At(values, 30), 60);
  EXPECT_DOUBLE_EQ(At(values, 10), 80);
  EXPECT_DOUBLE_EQ(At(values, 170), 0);
  EXPECT_DOUBLE_EQ(At(values, 250), 12.5);
  EXPECT_DOUBLE_EQ(At(values, 100), 30);
}

TEST(AtMost, Is100UpToTheSummitAndFallsOverItsBase) {
  const auto values = AtMost(kDepth, 40, 20);
  EXPECT_EQ(At(values, 0), 100);
  EXPECT_EQ(At(values, 40), 100);
  EXPECT_DOUBLE_EQ(At(values, 45), 75);
  EXPECT_DOUBLE_EQ(At(values, 60), 0);
  EXPECT_EQ(At(values, 100), 0);
}

TEST(AtMost, CutsAtASummitWithoutBase) {
  const auto values = AtMost(kSpeed, 2.3, 0);  // 23 * 0.1 is more than 2.3.
  EXPECT_EQ(At(values, 23), 100);
  EXPECT_EQ(At(values, 24), 0);
  EXPECT_EQ(At(AtMost(kDepth, -5, 0), 0), 100);
  EXPECT_EQ(At(AtMost(kDepth, -5, 0), 1), 0);
}

TEST(AtLeast, IsTheMirrorImageOfAtMost) {
  const auto least = AtLeast(kDepth, 40, 20);
  const auto most = AtMost(kDepth, 60, 20);
  for (int i = 0; i <= 100; ++i) EXPECT_DOUBLE_EQ(At(least, i), At(most, 100 - i));
  EXPECT_DOUBLE_EQ(At(least, 30), 50);
  EXPECT_EQ(At(AtLeast(kDepth, 200, 0), 100), 100);
}

TEST(SumOf, CombinesPointByPoint) { EXPECT_EQ(SumOf({1, 5}, {3, 2}), (std::vector<double>{4, 7})); }

double ValueAt(const Objective& objective, int course, int speed) {
  double value = 0;
  if (!objective.course.empty()) value += At(objective.course, course);
  if (!objective.speed.empty()) value += At(objective.speed, speed);
  if (objective.coupled != nullptr) value += objective.coupled->At(course, speed);
  return objective.offset + objective.scale * value;
}

TEST(Couple, SharesOutBetweenCourseAndSpeed) {
  std::vector<double> course(360, 0);
  course[7] = 20;
  course[8] = 10;
  std::vector<double> speed(41, 3);
  speed[5] = 5;
  speed[6] = 4;
  const Objective objective = Couple(course, speed, 80, 20);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 7, 5), 100);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 8, 5), 60);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 7, 6), 90);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 0, 5), 20);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 0, 0), 0);
}

TEST(Couple, LeavesAFlatPartWithoutEffect) {
  std::vector<double> course(360, 0);
  course[7] = 20;
  const Objective objective = Couple(course, std::vector<double>(41, 60), 50, 50);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 7, 30), 100);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 0, 3), 0);
  const Objective flat = Couple(std::vector<double>(360, 40), std::vector<double>(41, 60), 50, 50);
  EXPECT_DOUBLE_EQ(ValueAt(flat, 7, 30), 50);
}

class Product : public CourseSpeedFunction {
 public:
  double At(int course, int speed) const override { return -2.0 * course * speed; }
  Range Bound(const GridBox& box) const override {
    return {.min = At(box.last_course, box.last_speed),
            .max = At(box.first_course, box.first_speed)};
  }
};

TEST(NormaliseTo100, SpansACoupledFunctionExactly) {
  const Domain domain;
  const Objective objective =
      NormaliseTo100({.coupled = std::make_shared<Product>(), .offset = 7, .scale = -3}, domain);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 0, 17), 0);
  EXPECT_DOUBLE_EQ(ValueAt(objective, 359, 40), 100);
  EXPECT_NEAR(ValueAt(objective, 359, 20), 50, 1e-12);
}

TEST(NormaliseTo100, CountsDepthIn) {
  const Domain domain{.depth_m = kDepth};
  const Objective objective =
      NormaliseTo100({.depth = PeakOverAxis(kDepth, 30, 0, 50, 0, 10, 20)}, domain);
  EXPECT_NEAR(objective.offset + objective.scale * At(objective.depth, 30), 100, 1e-12);
  EXPECT_NEAR(objective.offset + objective.scale * At(objective.depth, 90), 0, 1e-12);
}

TEST(NormaliseTo100, LeavesAFlatFunctionFlatAndClipsIt) {
  const Domain domain;
  Objective flat{.course = std::vector<double>(360, 170)};
  flat = NormaliseTo100(flat, domain);
  EXPECT_EQ(ValueAt(flat, 99, 0), 100);
  EXPECT_TRUE(flat.mentions_course());
  EXPECT_EQ(ValueAt(NormaliseTo100({.speed = std::vector<double>(41, -3)}, domain), 0, 5), 0);
  EXPECT_EQ(ValueAt(NormaliseTo100({.speed = std::vector<double>(41, 33)}, domain), 0, 5), 33);
}

}  // namespace shoal::shapes_test
