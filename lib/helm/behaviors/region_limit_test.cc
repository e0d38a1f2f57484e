// Whatever behaviors want, and however much: no decision leads out of the op region.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/geometry/convex_polygon.h"
#include "lib/base/random/stream.h"
#include "lib/helm/behaviors/behavior_set.h"

namespace shoal::region_limit_test {

const Polygon kRegion = {{-60, -40}, {-50, 50}, {40, 60}, {70, -10}, {20, -50}};

double Between(Stream& stream, double low, double high) {
  return low + (high - low) * stream.Uniform();
}

Eigen::Vector2d DrawPlace(Stream& stream, double within_m) {
  return {Between(stream, -within_m, within_m), Between(stream, -within_m, within_m)};
}

/// Most of them within 15 m of the border.
Eigen::Vector2d DrawPlaceInside(Stream& stream) {
  while (true) {
    const Eigen::Vector2d place_m = DrawPlace(stream, 70);
    const double outside_m = SignedDistance(kRegion, place_m);
    if (outside_m < 0 && (outside_m > -15 || stream.Uniform() < 0.1)) return place_m;
  }
}

template <class Options>
Options Avoiding(Stream& stream) {
  Options options;
  options.contact.contact = stream.Uniform() < 0.5 ? "bravo" : "charlie";
  options.pwt_outer_dist = Between(stream, 40, 150);
  options.pwt_inner_dist = Between(stream, 5, 40);
  options.min_util_cpa_dist = Between(stream, 2, 20);
  options.max_util_cpa_dist = Between(stream, 20, 80);
  return options;
}

AnyBehavior DrawBehavior(Stream& stream) {
  switch (stream.UniformInt(10)) {
    case 0:
      return WaypointOptions{.points = {DrawPlace(stream, 150), DrawPlace(stream, 150)},
                             .speed = Between(stream, 0.5, 4)};
    case 1:
      return Avoiding<AvoidCollisionOptions>(stream);
    case 2:
      return Avoiding<ColregsOptions>(stream);
    case 3:
      return ConstantHeadingOptions{.heading = Between(stream, 0, 360)};
    case 4:
      return ConstantSpeedOptions{.speed = Between(stream, 0, 4)};
    case 5: {
      const Eigen::Vector2d centre_m = DrawPlace(stream, 100);
      LoiterOptions loiter;
      for (int i = 0; i < 6; ++i) {
        loiter.polygon.emplace_back(centre_m + 30 * UnitVector(DegToRad(60 * i)));
      }
      loiter.speed = Between(stream, 0.5, 4);
      return loiter;
    }
    case 6: {
      TrailOptions trail;
      trail.contact.contact = "bravo";
      return trail;
    }
    case 7:
      return StationKeepOptions{.station_pt = DrawPlace(stream, 150)};
    case 8:
      return MaxSpeedOptions{.max_speed = Between(stream, 0, 4)};
    default:
      return MemoryTurnLimitOptions{.memory_time = 20, .turn_range = 40};
  }
}

ContactView DrawContact(Stream& stream, const std::string& name) {
  ContactView contact = {.name = name};
  contact.now = {.position_m = DrawPlace(stream, 80),
                 .heading_deg = Between(stream, 0, 360),
                 .speed_mps = Between(stream, 0, 3)};
  contact.reported = contact.now;
  return contact;
}

struct Scene {
  HelmSetup setup = {.vehicle = "alpha"};
  OpRegionOptions region = {.core_poly = kRegion};
};

/// An op region, a goal, and up to five other behaviors, with weights up to 1000.
Scene DrawScene(Stream& stream) {
  Scene scene;
  scene.region.look_ahead = Between(stream, 1, 10);
  if (stream.Uniform() < 0.3) {
    scene.region.save_dist = 0;
    scene.region.halt_dist = 0;
  }
  const double pwt = Between(stream, 0, 300);
  scene.setup.behaviors.push_back({.name = "region", .pwt = pwt, .what = scene.region});
  scene.setup.behaviors.push_back(
      {.name = "goal", .what = WaypointOptions{.points = {DrawPlace(stream, 200)}, .speed = 2}});
  for (uint64_t i = stream.UniformInt(6); i > 0; --i) {
    scene.setup.behaviors.push_back({.name = "behavior" + std::to_string(i),
                                     .pwt = Between(stream, 0, 1000),
                                     .what = DrawBehavior(stream)});
  }
  return scene;
}

TEST(OpRegion, IsLeftByNoDecisionOfAnyWeightedSum) {
  int num_decisions = 0;
  int num_held = 0;
  for (uint64_t seed = 0; seed < 25; ++seed) {
    Stream stream(seed, "region limit");
    const Scene scene = DrawScene(stream);
    BehaviorSet set(scene.setup);
    for (int i = 0; i < 4; ++i) {
      Contacts contacts = {{"bravo", DrawContact(stream, "bravo")},
                           {"charlie", DrawContact(stream, "charlie")}};
      const OwnMotion own = {.motion = {.position_m = DrawPlaceInside(stream),
                                        .heading_deg = Between(stream, 0, 360),
                                        .speed_mps = Between(stream, 0, 4)}};
      const HelmOutcome outcome = set.Iterate({.time_s = 0.25 * i,
                                               .drives = true,
                                               .own = own,
                                               .contacts = &contacts,
                                               .explains = false});
      if (!outcome.has_decision || !outcome.commands.course_deg) continue;
      ++num_decisions;
      num_held += outcome.wanted ? 1 : 0;
      const auto after = [&](const HelmPoint& point) {
        return SignedDistance(kRegion,
                              own.motion.position_m + *point.speed_mps * scene.region.look_ahead *
                                                          UnitVector(DegToRad(*point.course_deg)));
      };
      EXPECT_LE(after(outcome.commands), 1e-6) << "seed " << seed << ", iteration " << i;
    }
  }
  EXPECT_GT(num_decisions, 80);
  EXPECT_GT(num_held, 10);
}

/// A goal to the east, 10 m from the eastern border of a square.
HelmSetup AtTheBorder(const OpRegionOptions& region) {
  return {
      .vehicle = "alpha",
      .behaviors = {
          {.name = "goal", .pwt = 1000, .what = WaypointOptions{.points = {{500, 0}}, .speed = 4}},
          {.name = "region", .what = region}}};
}

const Polygon kSquare = {{-50, -50}, {-50, 50}, {50, 50}, {50, -50}};
const OwnMotion kNearTheBorder = {
    .motion = {.position_m = {40, 0}, .heading_deg = 90, .speed_mps = 2}};

TEST(OpRegion, StatesWhichDecisionItExcludes) {
  BehaviorSet set(AtTheBorder({.core_poly = kSquare}));
  const HelmOutcome outcome = set.Iterate({.drives = true, .own = kNearTheBorder});
  ASSERT_TRUE(outcome.wanted.has_value());
  EXPECT_EQ(*outcome.wanted, (HelmPoint{.course_deg = 90, .speed_mps = 4}));
  EXPECT_LE(*outcome.commands.speed_mps * std::sin(DegToRad(*outcome.commands.course_deg)) * 5,
            10 + 1e-6);
  EXPECT_NE(outcome.aims.at(1).state.find("excludes course 90 deg speed 4 m/s"), std::string::npos)
      << outcome.aims.at(1).state;
}

TEST(OpRegion, HoldsATaskBackToo) {
  HelmSetup setup = AtTheBorder({.core_poly = kSquare});
  setup.behaviors.erase(setup.behaviors.begin());
  BehaviorSet set(std::move(setup));
  HelmInputs inputs = {.drives = true, .own = kNearTheBorder};
  inputs.task = TaskAim{.name = "east", .course_deg = 90, .speed_mps = 3};
  const HelmOutcome held = set.Iterate(inputs);
  EXPECT_FALSE(held.only_task);
  EXPECT_FALSE(held.is_task_point);
  EXPECT_TRUE(held.has_decision);
  inputs.task->speed_mps = 2;
  EXPECT_TRUE(set.Iterate(inputs).only_task);
}

TEST(OpRegion, AllowsEverythingWithoutLookAhead) {
  BehaviorSet set(AtTheBorder({.core_poly = kSquare, .look_ahead = 0}));
  const HelmOutcome outcome = set.Iterate({.drives = true, .own = kNearTheBorder});
  EXPECT_FALSE(outcome.wanted.has_value());
  EXPECT_EQ(outcome.commands, (HelmPoint{.course_deg = 90, .speed_mps = 4}));
}

TEST(OpRegion, AllowsEverythingBeforeItWasEntered) {
  BehaviorSet set(AtTheBorder({.core_poly = kSquare}));
  const OwnMotion outside = {.motion = {.position_m = {60, 0}}};
  EXPECT_FALSE(set.Iterate({.drives = true, .own = outside}).wanted.has_value());
}

TEST(OpRegion, LetsNoDecisionBeDeeperThanItsLimit) {
  HelmSetup setup = AtTheBorder({.core_poly = kSquare, .max_depth = 30});
  setup.domain.depth_m = {.first = 0, .step = 1, .count = 101};
  setup.behaviors.push_back({.name = "dive", .what = ConstantDepthOptions{.depth = 45}});
  BehaviorSet set(std::move(setup));
  const HelmOutcome outcome = set.Iterate({.drives = true, .own = OwnMotion()});
  EXPECT_EQ(outcome.commands.depth_m, 30);
  ASSERT_TRUE(outcome.wanted.has_value());
  EXPECT_EQ(outcome.wanted->depth_m, 45);
}

}  // namespace shoal::region_limit_test
