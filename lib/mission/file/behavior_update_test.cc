#include "lib/mission/file/behavior_update.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shoal::behavior_update_test {

using Points = std::vector<Eigen::Vector2d>;

BehaviorOptions Waypoint() {
  WaypointOptions waypoint;
  waypoint.points = {{0, 0}, {100, 0}};
  waypoint.speed = 1.5;
  return {.name = "survey", .what = waypoint};
}

BehaviorOptions Loiter() {
  LoiterOptions loiter;
  loiter.polygon = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
  return {.name = "loiter", .what = loiter};
}

Result<BehaviorOptions> Read(const BehaviorOptions& options, const std::string& text) {
  const auto items = ParseUpdate(text);
  EXPECT_TRUE(items.ok()) << text;
  return ReadBehaviorUpdate(options, *items, {7, 8});
}

template <class Options>
Options Updated(const BehaviorOptions& options, const std::string& text) {
  const auto updated = Read(options, text);
  EXPECT_TRUE(updated.ok()) << updated.error();
  return std::get<Options>(updated.ok() ? updated->what : options.what);
}

std::string ErrorOf(const BehaviorOptions& options, const std::string& text) {
  const auto updated = Read(options, text);
  EXPECT_FALSE(updated.ok()) << text;
  return updated.ok() ? "" : updated.error();
}

TEST(Update, ReadsPointsAsTheFileAndAsTextWritesThem) {
  const Points expected = {{0, 0}, {10, -5.5}};
  for (const char* text :
       {"points = [[0, 0], [10, -5.5]]", "points=0,0:10,-5.5", "points = pts={0,0:10,-5.5}"}) {
    EXPECT_EQ(Updated<WaypointOptions>(Waypoint(), text).points, expected) << text;
  }
  EXPECT_EQ(Updated<WaypointOptions>(Waypoint(), "speed = 2").points.size(), 2U);
}

TEST(Update, AddsAndReplacesSinglePoints) {
  EXPECT_EQ(Updated<WaypointOptions>(Waypoint(), "newpt = 5,6 # newpt = 7,8").points,
            (Points{{0, 0}, {100, 0}, {5, 6}, {7, 8}}));
  EXPECT_EQ(Updated<WaypointOptions>(Waypoint(), "point = 5,6").points, (Points{{5, 6}}));
  EXPECT_EQ(Updated<WaypointOptions>(Waypoint(), "point = present_position").points,
            (Points{{7, 8}}));
}

TEST(Update, ReadsEveryKindOfValue) {
  const auto waypoint = Updated<WaypointOptions>(
      Waypoint(),
      "speed = 2 # capture_line = TRUE # repeat = 3 # order = reverse # wptflag = DONE = true # "
      "lead = -1 # post_suffix = 5 # lead_condition = (A = 1) and (B = 2)");
  EXPECT_EQ(waypoint.speed, 2);
  EXPECT_TRUE(waypoint.capture_line);
  EXPECT_EQ(waypoint.repeat, 3);
  EXPECT_EQ(waypoint.order, "reverse");
  EXPECT_EQ(waypoint.wptflag, std::vector<std::string>{"DONE = true"});
  EXPECT_EQ(waypoint.post_suffix, "5");
  EXPECT_EQ(waypoint.lead_condition, "(A = 1) and (B = 2)");
  EXPECT_EQ(Updated<WaypointOptions>(Waypoint(), "wptflag = [\"A = 1\", \"B = 2\"]").wptflag,
            (std::vector<std::string>{"A = 1", "B = 2"}));
  EXPECT_TRUE(Updated<WaypointOptions>(Waypoint(), "use_alt_speed = toggle").use_alt_speed);
  EXPECT_EQ(Updated<LegRunOptions>({.name = "legs", .what = LegRunOptions()},
                                   "leg_spds = 1, 2 # p1 = 3,4 # p2 = [5, 6]"),
            (LegRunOptions{.p1 = {{3, 4}}, .p2 = {{5, 6}}, .leg_spds = {1, 2}}));
}

TEST(Update, ChangesWhatAllKindsHave) {
  const auto updated =
      Read(Waypoint(), "pwt = 30 # condition = DEPLOY = true # duration = 60 # endflag = A = 1");
  ASSERT_TRUE(updated.ok()) << updated.error();
  EXPECT_EQ(updated->pwt, 30);
  EXPECT_EQ(updated->condition, std::vector<std::string>{"DEPLOY = true"});
  EXPECT_EQ(updated->duration, 60);
  EXPECT_EQ(updated->flags.endflag, std::vector<std::string>{"A = 1"});
}

TEST(Update, HasTheRangesAndMessagesOfTheFile) {
  EXPECT_EQ(ErrorOf(Waypoint(), "speed = -1"), "speed = -1 is out of range; allowed: 0 to 50");
  EXPECT_EQ(ErrorOf(Waypoint(), "speed = fast"), "speed must be a number, not the string 'fast'");
  EXPECT_EQ(ErrorOf(Waypoint(), "sped = 2"), "unknown key 'sped' (did you mean 'speed'?)");
  EXPECT_EQ(ErrorOf(Waypoint(), "nm_radius = 2"),
            "unknown key 'nm_radius' (here it is 'slip_radius')");
  EXPECT_EQ(ErrorOf(Waypoint(), "points = 0,0:1"),
            "points: '1' is not a point; write points like 0,0:100,0");
  EXPECT_NE(ErrorOf(Waypoint(), "condition = DEPLOY").find("'DEPLOY' compares nothing"),
            std::string::npos);
  EXPECT_NE(ErrorOf(Loiter(), "polygon = 0,0:1,0").find("polygon is not convex"),
            std::string::npos);
  EXPECT_NE(ErrorOf(Waypoint(), "points = [[1e9, 0]]").find("is out of range"), std::string::npos);
  EXPECT_NE(ErrorOf(Waypoint(), "name = x # kind = loiter").find("unknown key 'kind'"),
            std::string::npos);
}

TEST(Update, MovesAndScalesTheLoiterPolygon) {
  const auto first_corner = [](const std::string& text) {
    const auto polygon = Updated<LoiterOptions>(Loiter(), text).polygon;
    EXPECT_EQ(polygon.size(), 4U);
    return polygon.front();
  };
  EXPECT_TRUE(first_corner("center_assign = 100,0").isApprox(Eigen::Vector2d(90, -10)));
  EXPECT_TRUE(first_corner("center_assign = present_position").isApprox(Eigen::Vector2d(-3, -2)));
  EXPECT_TRUE(
      first_corner("xcenter_assign = 5 # ycenter_assign = -5").isApprox(Eigen::Vector2d(-5, -15)));
  const auto scaled = Updated<LoiterOptions>(Loiter(), "mod_poly_rad = 10").polygon;
  EXPECT_NEAR(scaled.front().norm(), std::sqrt(200.0) + 10, 1e-9);
  const auto small = Updated<LoiterOptions>(Loiter(), "mod_poly_rad = -100").polygon;
  EXPECT_NEAR(small.front().norm(), 5, 1e-9);
  EXPECT_NE(ErrorOf(Loiter(), "center_assign = here").find("is not a point"), std::string::npos);
  EXPECT_NE(ErrorOf(Loiter(), "mod_poly_rad = much").find("is not a number"), std::string::npos);
}

TEST(Update, MovesAStation) {
  const BehaviorOptions keep = {.name = "keep", .what = StationKeepOptions()};
  EXPECT_EQ(Updated<StationKeepOptions>(keep, "station_pt = 1,2").station_pt,
            Eigen::Vector2d(1, 2));
  EXPECT_EQ(Updated<StationKeepOptions>(keep, "station_pt = present_position").station_pt,
            Eigen::Vector2d(7, 8));
}

TEST(Update, FillsInARecipe) {
  const BehaviorOptions trail = {
      .name = "trail_", .templating = Templating::kSpawn, .what = TrailOptions()};
  EXPECT_EQ(Updated<TrailOptions>(trail, "contact = henry # trail_range = 30").contact.contact,
            "henry");
}

}  // namespace shoal::behavior_update_test
