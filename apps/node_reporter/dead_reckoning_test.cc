#include "apps/node_reporter/dead_reckoning.h"

#include <gtest/gtest.h>

namespace shoal::dead_reckoning_test {

constexpr DeadReckoningLimits kLimits = {.position_m = 0.25, .heading_deg = 1, .max_gap_s = 5};

/// On its way North East at sqrt(2) m/s, heading North.
node_report_t At(double seconds, double x_m, double y_m, double heading_deg = 0) {
  node_report_t report = {};
  report.utime = static_cast<int64_t>(seconds * 1e6);
  report.x_m = x_m;
  report.y_m = y_m;
  report.heading_deg = heading_deg;
  report.speed_over_ground_mps = 1.4142135623730951;
  report.course_over_ground_deg = 45;
  return report;
}

TEST(Predicts, CarriesOnAlongTheCourseOverGround) {
  EXPECT_TRUE(Predicts(At(0, 0, 0), At(2, 2, 2), kLimits));
  EXPECT_TRUE(Predicts(At(0, 0, 0), At(2, 2.24, 2), kLimits));
  EXPECT_FALSE(Predicts(At(0, 0, 0), At(2, 2.26, 2), kLimits));
  EXPECT_FALSE(Predicts(At(0, 0, 0), At(2, 0, 0), kLimits));
}

TEST(Predicts, ComparesTheDepth) {
  node_report_t deeper = At(2, 2, 2);
  deeper.depth_m = 0.3;
  EXPECT_FALSE(Predicts(At(0, 0, 0), deeper, kLimits));
}

TEST(Predicts, ComparesHeadingsAcrossNorth) {
  EXPECT_TRUE(Predicts(At(0, 0, 0, 359.6), At(1, 1, 1, 0.5), kLimits));
  EXPECT_FALSE(Predicts(At(0, 0, 0, 359.4), At(1, 1, 1, 0.5), kLimits));
}

TEST(Predicts, NothingAfterTheLargestGap) {
  EXPECT_TRUE(Predicts(At(0, 0, 0), At(4.999, 4.999, 4.999), kLimits));
  EXPECT_FALSE(Predicts(At(0, 0, 0), At(5, 5, 5), kLimits));
}

}  // namespace shoal::dead_reckoning_test
