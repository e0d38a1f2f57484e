#include "lib/helm/behaviors/contact_recipe.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/helm_testing.h"

namespace shoal::contact_recipe_test {

constexpr AlertRange kRange = {.alert_m = 80, .cpa_m = 200};

VesselMotion At(double x_m, double heading_deg, double speed_mps) {
  return {.position_m = {x_m, 0}, .heading_deg = heading_deg, .speed_mps = speed_mps};
}

TEST(Alert, IsOnWithinItsRangeWhateverTheMotion) {
  EXPECT_TRUE(IsAlert(kRange, At(0, 270, 2), At(79, 90, 2)));
  EXPECT_FALSE(IsAlert(kRange, At(0, 270, 2), At(81, 90, 2)));
}

TEST(Alert, IsOnEarlierForAContactThatWillComeWithinIt) {
  EXPECT_TRUE(IsAlert(kRange, At(0, 90, 2), At(199, 270, 2)));
  EXPECT_FALSE(IsAlert(kRange, At(0, 90, 2), At(201, 270, 2)));
  EXPECT_FALSE(IsAlert(kRange, At(0, 0, 2), At(150, 0, 2)));
}

TEST(AlertRange, IsThatOfBehaviorsWhichKeepClear) {
  const auto range = AlertRangeOf(ColregsOptions{.pwt_outer_dist = 80, .completed_dist = 100});
  ASSERT_TRUE(range.has_value());
  EXPECT_EQ(range->alert_m, 80);
  EXPECT_EQ(range->cpa_m, 100);
  EXPECT_TRUE(AlertRangeOf(AvoidCollisionOptions()).has_value());
  EXPECT_FALSE(AlertRangeOf(TrailOptions()).has_value());
  EXPECT_FALSE(AlertRangeOf(WaypointOptions()).has_value());
}

TEST(Filter, MatchesAndIgnoresWithoutRegardToCase) {
  ContactView contact = ContactAt("Henry", 0, 0);
  contact.type = "kayak";
  EXPECT_TRUE(Passes({}, contact));
  EXPECT_TRUE(Passes({.match_name = {"gilda", "henry"}}, contact));
  EXPECT_FALSE(Passes({.match_name = {"gilda"}}, contact));
  EXPECT_FALSE(Passes({.ignore_name = {"HENRY"}}, contact));
  EXPECT_FALSE(Passes({.match_group = {"blue"}}, contact));
  EXPECT_TRUE(Passes({.ignore_group = {"blue"}}, contact));
  EXPECT_TRUE(Passes({.match_type = {"Kayak"}}, contact));
  EXPECT_FALSE(Passes({.match_type = {"kayak"}, .ignore_type = {"kayak"}}, contact));
}

TEST(DistanceToAPolygon, IsZeroInside) {
  const std::vector<Eigen::Vector2d> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(DistanceTo(square, {5, 5}), 0);
  EXPECT_EQ(DistanceTo(square, {13, 5}), 3);
  EXPECT_NEAR(DistanceTo(square, {13, 14}), 5, 1e-12);
}

}  // namespace shoal::contact_recipe_test
