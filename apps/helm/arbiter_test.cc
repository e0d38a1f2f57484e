// A whole helm with behaviors: what it decides, publishes and takes from others.
#include "apps/helm/arbiter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "apps/helm/vessel_testing.h"

namespace shoal::arbiter_test {

BehaviorOptions AvoidEveryone() {
  AvoidCollisionOptions avoid;
  avoid.pwt_outer_dist = 80;
  avoid.pwt_inner_dist = 20;
  avoid.completed_dist = 100;
  avoid.min_util_cpa_dist = 8;
  avoid.max_util_cpa_dist = 25;
  return {.name = "avd_", .pwt = 200, .templating = Templating::kSpawn, .what = AnyBehavior(avoid)};
}

BehaviorOptions GoTo(const char* name, const Eigen::Vector2d& point_m) {
  WaypointOptions waypoint;
  waypoint.points = {point_m};
  waypoint.speed = 2;
  return {.name = name, .what = AnyBehavior(waypoint)};
}

/// alpha at the origin, on its way north at 2 m/s.
Vehicle Northbound() {
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.helm_options.deploy_at_start = true;
  vehicle.tasks = {
      {.name = "north", .what = WaypointsTask{.points_m = {{0, 1000}}, .speed_mps = 2}}};
  return vehicle;
}

node_report_t Report(const std::string& name, int64_t utime, double x_m, double y_m,
                     double heading_deg) {
  node_report_t report{};
  report.utime = utime;
  report.name = name;
  report.x_m = x_m;
  report.y_m = y_m;
  report.heading_deg = heading_deg;
  report.speed_mps = 2;
  return report;
}

bool Mentions(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(words) != line.npos; });
}

TEST(Arbiter, LetsATaskAloneSteerToTheLastBit) {
  Vehicle with_behaviors = Northbound();
  with_behaviors.behaviors = {AvoidEveryone()};
  HelmAndVessel plain(Northbound());
  HelmAndVessel weighed(with_behaviors);
  plain.Step();  // What it publishes arrives one step later.
  weighed.Step();
  for (int i = 1; i < 300; ++i) {
    plain.Step();
    weighed.Step();
    ASSERT_EQ(plain.actuators.has_value(), weighed.actuators.has_value()) << "in step " << i;
    if (!plain.actuators) continue;
    ASSERT_EQ(plain.actuators->rudder_deg, weighed.actuators->rudder_deg) << "in step " << i;
    ASSERT_EQ(plain.actuators->thrust_pct, weighed.actuators->thrust_pct) << "in step " << i;
  }
  EXPECT_EQ(plain.state.waypoint_y_m, weighed.state.waypoint_y_m);
  EXPECT_TRUE(weighed.decisions.empty());
}

/// Steps both helms, and expects that they do the same.
void ExpectTheSame(HelmAndVessel& plain, HelmAndVessel& weighed, int num_steps) {
  for (int i = 0; i < num_steps; ++i) {
    plain.Step();
    weighed.Step();
    ASSERT_EQ(plain.desired->heading_deg, weighed.desired->heading_deg) << "at " << plain.utime;
    ASSERT_EQ(plain.desired->speed_mps, weighed.desired->speed_mps) << "at " << plain.utime;
    ASSERT_EQ(plain.actuators->rudder_deg, weighed.actuators->rudder_deg) << "at " << plain.utime;
    ASSERT_EQ(plain.actuators->thrust_pct, weighed.actuators->thrust_pct) << "at " << plain.utime;
    ASSERT_EQ(plain.states.size(), weighed.states.size()) << "at " << plain.utime;
    ASSERT_EQ(plain.state.state, weighed.state.state);
    ASSERT_EQ(plain.state.all_stop, weighed.state.all_stop);
    ASSERT_EQ(plain.state.task, weighed.state.task);
    ASSERT_EQ(plain.state.waypoint_index, weighed.state.waypoint_index);
    ASSERT_EQ(plain.state.distance_m, weighed.state.distance_m);
  }
}

TEST(Arbiter, DecidesTheSameWithoutBehaviorsAndWithOneThatNeverRuns) {
  Vehicle vehicle = TestVehicle();
  vehicle.tasks.resize(1);
  std::get<WaypointsTask>(vehicle.tasks[0].what).points_m = {{0, 20}, {20, 20}};
  Vehicle with_idle = vehicle;
  BehaviorOptions idle = GoTo("idle", {-1000, 0});
  idle.condition = {"NEVER = true"};
  with_idle.behaviors = {idle};
  HelmAndVessel plain(vehicle);
  HelmAndVessel weighed(with_idle);
  const auto both = [&](const std::string& command, const std::vector<double>& values = {}) {
    plain.Command(command, values);
    weighed.Command(command, values);
  };
  plain.publishes_nav = weighed.publishes_nav = false;
  plain.Run(0.5);
  weighed.Run(0.5);
  plain.publishes_nav = weighed.publishes_nav = true;
  plain.Run(0.2);
  weighed.Run(0.2);
  ExpectTheSame(plain, weighed, 10);
  both("deploy");
  ExpectTheSame(plain, weighed, 200);
  both("all_stop");
  ExpectTheSame(plain, weighed, 20);
  both("resume");
  ExpectTheSame(plain, weighed, 20);
  both("goto", {10, -10});
  ExpectTheSame(plain, weighed, 50);
  both("speed", {2.5});
  ExpectTheSame(plain, weighed, 20);
  plain.publishes_nav = weighed.publishes_nav = false;
  ExpectTheSame(plain, weighed, 30);
  EXPECT_EQ(plain.state.state, "ALL-STOP");
  plain.publishes_nav = weighed.publishes_nav = true;
  both("deploy");
  ExpectTheSame(plain, weighed, 400);
  EXPECT_EQ(plain.state.task, "end_of_tasks");
  both("park");
  ExpectTheSame(plain, weighed, 20);
  EXPECT_EQ(plain.state.state, "PARK");
  EXPECT_TRUE(plain.decisions.empty());
  EXPECT_TRUE(plain.messages.empty());
}

TEST(Arbiter, TurnsAsideForAVesselThatItReceivesReportsOfAndPublishesWhy) {
  Vehicle vehicle = Northbound();
  vehicle.behaviors = {AvoidEveryone()};
  HelmAndVessel loop(vehicle);
  double nearest_m = 1000;
  for (int i = 0; i < 600; ++i) {
    const double y_m = 140 - 0.2 * i;
    if (i % 5 == 0) loop.SayReport(Report("bravo", loop.utime, 2, y_m, 180));
    loop.Step();
    nearest_m = std::min(nearest_m, (loop.vessel.position_m - Eigen::Vector2d(2, y_m)).norm());
  }
  EXPECT_GT(nearest_m, 8);
  ASSERT_FALSE(loop.decisions.empty());
  bool names_bravo = false;
  for (const helm_decision_t& decision : loop.decisions) {
    for (const helm_aim_t& aim : decision.aims) {
      if (aim.contact != "bravo" || aim.weight <= 0) continue;
      names_bravo = true;
      EXPECT_EQ(aim.name, "avd_bravo");
      EXPECT_EQ(aim.kind, "avoid_collision");
      EXPECT_LT(aim.age_s, 1);
    }
  }
  EXPECT_TRUE(names_bravo);
  EXPECT_TRUE(Mentions(loop.Events(), "spawn"));
}

TEST(Arbiter, DoesNotAvoidWhatItReceivesNoReportOf) {
  Vehicle vehicle = Northbound();
  vehicle.behaviors = {AvoidEveryone()};
  HelmAndVessel loop(vehicle);
  loop.Run(60);
  EXPECT_LT(std::abs(loop.vessel.position_m.x()), 0.01);
}

TEST(Arbiter, WarnsOfReportsWithImpossibleNumbersAndUnderItsOwnNameAndDrivesOn) {
  Vehicle vehicle = Northbound();
  vehicle.behaviors = {AvoidEveryone()};
  HelmAndVessel loop(vehicle);
  loop.Run(20);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 100; ++i) {
    node_report_t bad = Report("bravo", loop.utime, 0, loop.vessel.position_m.y() + 20, 180);
    bad.heading_deg = nan;
    loop.SayReport(bad);
    loop.SayReport(Report("alpha", loop.utime, 0, loop.vessel.position_m.y() + 20, 180));
    loop.Step();
  }
  EXPECT_LT(std::abs(loop.vessel.position_m.x()), 0.01);
  EXPECT_GT(loop.vessel.position_m.y(), 50);
  EXPECT_TRUE(Mentions(loop.Page().run_warnings, "contact bravo: "));
  EXPECT_TRUE(Mentions(loop.Page().run_warnings, "contact alpha: "));
}

TEST(Arbiter, WarnsOfAContactThatJumpsAndGoesByItsNewPlace) {
  Vehicle vehicle = Northbound();
  vehicle.behaviors = {AvoidEveryone()};
  HelmAndVessel loop(vehicle);
  for (int i = 0; i < 300; ++i) {
    const double y_m = i < 100 ? 900 : loop.vessel.position_m.y() + 15;
    if (i % 5 == 0) loop.SayReport(Report("bravo", loop.utime, 0, y_m, 180));
    loop.Step();
  }
  EXPECT_TRUE(Mentions(loop.Page().run_warnings, "contact bravo: "));
  EXPECT_GT(std::abs(loop.vessel.position_m.x()), 5);
}

TEST(Arbiter, TakesVariablesFromOrdersAndNodeMessages) {
  Vehicle vehicle = Northbound();
  vehicle.tasks.clear();
  vehicle.variables = {{"GO", std::string("no")}};
  BehaviorOptions east = GoTo("east", {1000, 0});
  east.condition = {"GO = east"};
  BehaviorOptions west = GoTo("west", {-1000, 0});
  west.condition = {"GO = west"};
  vehicle.behaviors = {east, west};
  HelmAndVessel loop(vehicle);
  loop.Run(2);
  EXPECT_EQ(loop.state.all_stop, "NothingToDo");
  EXPECT_EQ(loop.actuators->thrust_pct, 0);

  loop.Command("set", {}, "GO = east");
  loop.Run(10);
  EXPECT_EQ(loop.state.state, "DRIVE");
  EXPECT_EQ(loop.state.task, "east");
  EXPECT_EQ(loop.state.task_kind, "waypoint");
  EXPECT_EQ(loop.state.all_stop, "clear");
  EXPECT_NEAR(loop.desired->heading_deg, 90, 1);

  node_message_t message{};
  message.src_node = "bravo";
  message.var_name = "GO";
  message.string_val = "west";
  loop.PublishMessage(message);
  loop.Run(10);
  EXPECT_EQ(loop.state.task, "west");
  EXPECT_NEAR(loop.desired->heading_deg, 270, 3);
}

TEST(Arbiter, RefusesASettingWithoutAValueOrForAHelmWithoutBehaviors) {
  Vehicle vehicle = Northbound();
  HelmAndVessel plain(vehicle);
  plain.Command("set", {}, "GO = east");
  plain.Run(0.3);
  EXPECT_TRUE(Mentions(plain.Page().run_warnings, "the vehicle has no behaviors"));
  vehicle.behaviors = {AvoidEveryone()};
  HelmAndVessel weighed(vehicle);
  weighed.Command("set", {}, "GO");
  weighed.Run(0.3);
  EXPECT_TRUE(Mentions(weighed.Page().run_warnings, "HELM_COMMAND refused: set"));
}

TEST(Arbiter, SetsTheVariablesThatStandForOrders) {
  Vehicle vehicle = Northbound();
  vehicle.helm_options.deploy_at_start = false;
  vehicle.tasks.clear();
  vehicle.variables = {{"DEPLOY", std::string("false")}, {"RETURN", std::string("false")}};
  BehaviorOptions out = GoTo("out", {1000, 0});
  out.condition = {"DEPLOY = true", "RETURN = false"};
  BehaviorOptions home = GoTo("home", {-1000, 0});
  home.condition = {"RETURN = true"};
  vehicle.behaviors = {out, home};
  HelmAndVessel loop(vehicle);
  loop.Run(1);
  EXPECT_EQ(loop.state.state, "PARK");
  loop.Command("deploy");
  loop.Run(5);
  EXPECT_EQ(loop.state.task, "out");
  loop.Command("return");
  loop.Run(5);
  EXPECT_EQ(loop.state.task, "home");
  loop.Command("deploy");
  loop.Run(5);
  EXPECT_EQ(loop.state.task, "out");
}

TEST(Arbiter, KeepsVariablesThatDeployIsToldToKeep) {
  for (const bool is_kept : {false, true}) {
    Vehicle vehicle = Northbound();
    vehicle.helm_options.deploy_at_start = false;
    if (is_kept) vehicle.helm_options.deploy_keeps = {"STATION_KEEP"};
    vehicle.tasks.clear();
    vehicle.variables = {{"DEPLOY", std::string("false")}, {"STATION_KEEP", std::string("true")}};
    BehaviorOptions out = GoTo("out", {1000, 0});
    out.condition = {"STATION_KEEP = false"};
    BehaviorOptions stay = GoTo("stay", {-1000, 0});
    stay.condition = {"STATION_KEEP = true"};
    vehicle.behaviors = {out, stay};
    HelmAndVessel loop(vehicle);
    loop.Command("deploy");
    loop.Run(5);
    EXPECT_EQ(loop.state.task, is_kept ? "stay" : "out");
  }
}

TEST(Arbiter, LetsGoalsRestWhileAnOrderSteers) {
  Vehicle vehicle = Northbound();
  vehicle.tasks.clear();
  vehicle.behaviors = {GoTo("east", {1000, 0}), AvoidEveryone()};
  HelmAndVessel loop(vehicle);
  loop.Run(20);
  EXPECT_EQ(loop.state.task, "east");
  loop.Command("goto", {loop.vessel.position_m.x(), -500});
  loop.Run(20);
  EXPECT_EQ(loop.state.task, "goto");
  EXPECT_NEAR(loop.desired->heading_deg, 180, 5);
  loop.Command("deploy");
  loop.Run(20);
  EXPECT_EQ(loop.state.task, "east");
}

TEST(Arbiter, SendsFlagsWithADestinationAsNodeMessages) {
  Vehicle vehicle = Northbound();
  BehaviorOptions here = GoTo("here", {0, 5});
  here.flags.endflag = {"DONE = true [to] all", "RANGE = 12.5 [to] group:scouts"};
  vehicle.behaviors = {here};
  HelmAndVessel loop(vehicle);
  loop.Run(20);
  ASSERT_EQ(loop.messages.size(), 2U);
  EXPECT_EQ(loop.messages[0].src_node, "alpha");
  EXPECT_EQ(loop.messages[0].dest_node, "all");
  EXPECT_EQ(loop.messages[0].var_name, "DONE");
  EXPECT_EQ(loop.messages[0].string_val, "true");
  EXPECT_EQ(loop.messages[1].dest_group, "scouts");
  EXPECT_EQ(loop.messages[1].is_double, 1);
  EXPECT_EQ(loop.messages[1].double_val, 12.5);
}

TEST(Arbiter, IsSilentWhileParkedAndShowsItsBehaviorsOnThePage) {
  Vehicle vehicle = Northbound();
  vehicle.helm_options.deploy_at_start = false;
  vehicle.behaviors = {GoTo("east", {1000, 0})};
  HelmAndVessel loop(vehicle);
  loop.Run(5);
  EXPECT_TRUE(loop.decisions.empty());
  loop.Command("deploy");
  loop.Run(5);
  EXPECT_FALSE(loop.decisions.empty());
  EXPECT_NE(loop.Page().text.find("east "), std::string::npos);
  EXPECT_NE(loop.Page().text.find("Decided: course"), std::string::npos);
}

TEST(Arbiter, IsLateByTheTimeThatABehaviorKeepsItBusy) {
  Vehicle vehicle = Northbound();
  vehicle.behaviors = {
      {.name = "fault",
       .duration = 5,
       .what = AnyBehavior(TestFailureOptions{.failure_type = "burn", .burn_time = 1.5})}};
  HelmAndVessel loop(vehicle);
  int num_silent = 0;
  for (int step = 0; step < 80; ++step) {
    loop.actuators.reset();
    if (step == 60) loop.Command("station_keep");
    loop.Step();
    if (step == 0 || loop.actuators) continue;
    ++num_silent;
    EXPECT_GE(step, 50);
    EXPECT_EQ(loop.state.task, "north");
  }
  EXPECT_EQ(num_silent, 15);
  EXPECT_EQ(loop.state.task, "station_keep");  // What arrives meanwhile waits.
  EXPECT_TRUE(Mentions(loop.Page().run_warnings, "busy"));
}

TEST(Arbiter, PublishesADecisionThatDoesNotChangeOncePerSecond) {
  Vehicle vehicle = Northbound();
  vehicle.behaviors = {GoTo("far", {0, 100'000})};
  HelmAndVessel loop(vehicle);
  loop.Run(30);
  const size_t before = loop.decisions.size();
  loop.Run(10);
  EXPECT_GE(loop.decisions.size() - before, 9U);
  EXPECT_LE(loop.decisions.size() - before, 11U);
}

TEST(Arbiter, ParksTheHelmInTheStepInWhichABehaviorAsksForIt) {
  OpRegionOptions region;
  region.core_poly = {{-30, -30}, {-30, 30}, {30, 30}, {30, -30}};
  region.look_ahead = 0;
  region.soft_poly_breach = true;
  Vehicle vehicle = Northbound();
  vehicle.behaviors = {{.name = "region", .what = AnyBehavior(region)}};
  HelmAndVessel loop(vehicle);
  for (int i = 0; i < 600 && loop.state.state != "PARK"; ++i) loop.Step();
  EXPECT_EQ(loop.state.state, "PARK");
  EXPECT_EQ(loop.state.all_stop, "parked");
  EXPECT_EQ(loop.state.task, "");
  EXPECT_EQ(loop.actuators->thrust_pct, 0);
  EXPECT_GT(loop.vessel.position_m.y(), 30);
}

TEST(Arbiter, PassesTheAimOfTheTasksOnWhereThereAreNoBehaviors) {
  Arbiter arbiter(Mission{}, Northbound());
  arbiter.inputs().OnNodeReport(Report("alpha", 0, 0, 20, 180), 0);
  arbiter.inputs().Set({.variable = "GO", .value = 1.0}, "command");
  const nav_t nav{};
  const Guidance wish{.heading_rad = 1, .speed_mps = 2};
  const Arbiter::Step step =
      arbiter.Advance({.drives = true, .nav = &nav, .list = {.guidance = &wish}});
  EXPECT_EQ(step.guidance, &wish);
  EXPECT_EQ(arbiter.Advance({.utime = 1, .drives = true, .nav = &nav}).guidance, nullptr);
  EXPECT_EQ(arbiter.all_stop(), "clear");
  EXPECT_EQ(arbiter.Leading(), nullptr);
  EXPECT_FALSE(arbiter.TakeDecision().has_value());
  EXPECT_TRUE(arbiter.TakeEvents().empty());
  EXPECT_TRUE(arbiter.TakeWarnings().empty()) << "a report under its own name is not taken";
  EXPECT_EQ(arbiter.Text(), "");
}

TEST(Arbiter, ExecutesDeployAtStartOnceForTasksAndVariables) {
  Vehicle vehicle = Northbound();
  vehicle.variables = {{"DEPLOY", std::string("false")}};
  BehaviorOptions east = GoTo("east", {1000, 0});
  east.condition = {"DEPLOY = true"};
  east.pwt = 1000;
  vehicle.behaviors = {east};
  HelmAndVessel loop(vehicle);
  loop.Run(2);
  EXPECT_EQ(loop.state.state, "DRIVE");
  EXPECT_EQ(loop.state.task, "north");
  EXPECT_NEAR(loop.desired->heading_deg, 90, 1);
}

}  // namespace shoal::arbiter_test
