#include "lib/helm/decision/speed_along.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace shoal::speed_along_test {

const Domain kDomain;

TEST(SpeedAlong, IsTheComponentOfTheVelocity) {
  const SpeedAlong along(90, kDomain);
  EXPECT_NEAR(along.At(90, 20), 2, 1e-12);
  EXPECT_NEAR(along.At(30, 20), 1, 1e-12);
  EXPECT_NEAR(along.At(0, 20), 0, 1e-12);
  EXPECT_NEAR(along.At(270, 40), -4, 1e-12);
}

RC_GTEST_PROP(SpeedAlong, IsBoundedInEveryBox, ()) {
  const SpeedAlong along(*rc::gen::inRange(-7200, 7200) / 10.0, kDomain);
  GridBox box;
  box.first_course = *rc::gen::inRange(0, 360);
  box.last_course = *rc::gen::inRange(box.first_course, 360);
  box.first_speed = *rc::gen::inRange(0, 41);
  box.last_speed = *rc::gen::inRange(box.first_speed, 41);
  const CourseSpeedFunction::Range range = along.Bound(box);
  double most = -100;
  double least = 100;
  for (int course = box.first_course; course <= box.last_course; ++course) {
    for (int speed = box.first_speed; speed <= box.last_speed; ++speed) {
      most = std::max(most, along.At(course, speed));
      least = std::min(least, along.At(course, speed));
    }
  }
  RC_ASSERT(range.min <= least);
  RC_ASSERT(range.max >= most);
  // Not loose either: by the width of a course at the greatest speed.
  RC_ASSERT(range.max <= most + 0.001 || most < 0);
}

}  // namespace shoal::speed_along_test
