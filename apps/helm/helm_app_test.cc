#include "apps/helm/helm_app.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "apps/helm/vessel_testing.h"

namespace shoal::helm_app_test {

Vehicle Deployed() {
  Vehicle vehicle = TestVehicle();
  vehicle.helm_options.deploy_at_start = true;
  return vehicle;
}

bool Mentions(const StatusPage& page, const std::string& words) {
  return std::any_of(page.run_warnings.begin(), page.run_warnings.end(),
                     [&](const std::string& text) { return text.find(words) != text.npos; });
}

TEST(HelmApp, PublishesZeroActuatorsAndNoDesiredBeforeTheFirstNav) {
  HelmAndVessel loop(Deployed());
  loop.publishes_nav = false;
  loop.Run(0.3);
  ASSERT_TRUE(loop.actuators.has_value());
  EXPECT_EQ(loop.actuators->thrust_pct, 0);
  EXPECT_FALSE(loop.desired.has_value());
  EXPECT_EQ(loop.state.state, "DRIVE");
}

TEST(HelmApp, StaysParkedWithItsHeadingDesiredUntilDeployed) {
  HelmAndVessel loop(TestVehicle());
  loop.vessel.heading_rad = DegToRad(75);
  loop.Run(3);
  EXPECT_EQ(loop.state.state, "PARK");
  EXPECT_EQ(loop.state.all_stop, "never deployed");
  EXPECT_NEAR(loop.desired->heading_deg, 75, 1e-9);
  EXPECT_EQ(loop.desired->speed_mps, 0);
  EXPECT_EQ(loop.actuators->thrust_pct, 0);
  EXPECT_EQ(loop.actuators->rudder_deg, 0);

  loop.Command("deploy");
  loop.Run(3);
  EXPECT_EQ(loop.state.state, "DRIVE");
  EXPECT_EQ(loop.state.task, "survey");
  EXPECT_EQ(loop.state.task_kind, "waypoints");
  EXPECT_EQ(loop.state.all_stop, "clear");
  EXPECT_GT(loop.actuators->thrust_pct, 0);
}

TEST(HelmApp, PublishesItsStateOnChangeAndOncePerSecond) {
  HelmAndVessel loop(TestVehicle());
  loop.Run(5.5);
  EXPECT_EQ(loop.states.size(), 6u);
  loop.Command("deploy");
  loop.Run(0.3);
  EXPECT_EQ(loop.states.size(), 7u);
  EXPECT_EQ(loop.states.back().state, "DRIVE");
}

TEST(HelmApp, StopsForALostNavAndGoesOnWhenItIsBack) {
  HelmAndVessel loop(Deployed());
  loop.Run(10);
  EXPECT_EQ(loop.state.state, "DRIVE");
  loop.publishes_nav = false;
  loop.Run(1.9);
  EXPECT_EQ(loop.state.state, "DRIVE");
  loop.Run(0.5);
  EXPECT_EQ(loop.state.state, "ALL-STOP");
  EXPECT_EQ(loop.state.all_stop, "no NAV for 2.0 s");
  EXPECT_EQ(loop.state.task, "survey");
  EXPECT_EQ(loop.actuators->thrust_pct, 0);
  EXPECT_TRUE(Mentions(loop.Page(), "no NAV for 2.0 s"));

  loop.publishes_nav = true;
  loop.Run(0.5);
  EXPECT_EQ(loop.state.state, "DRIVE");
  EXPECT_EQ(loop.state.all_stop, "clear");
  EXPECT_GT(loop.actuators->thrust_pct, 0);
  EXPECT_EQ(loop.NumWarnings(), 0u);
}

TEST(HelmApp, StopsWhenThereNeverWasANav) {
  HelmAndVessel loop(Deployed());
  loop.publishes_nav = false;
  loop.Run(2.5);
  EXPECT_EQ(loop.state.state, "ALL-STOP");
  EXPECT_EQ(loop.state.all_stop, "no NAV for 2.0 s");
}

TEST(HelmApp, TakesNavThatIsNotFiniteForNone) {
  const double nan = std::nan("");
  HelmAndVessel loop(Deployed());
  loop.Run(5);
  loop.publishes_nav = false;
  for (int i = 0; i < 30; ++i) {
    nav_t nav = loop.Nav();
    if (i % 4 == 0) nav.x_m = nan;
    if (i % 4 == 1) nav.heading_deg = std::numeric_limits<double>::infinity();
    if (i % 4 == 2) nav.y_m = 1e300;
    if (i % 4 == 3) nav.speed_mps = nan;
    loop.PublishNav(nav);
    loop.Step();
  }
  EXPECT_EQ(loop.state.state, "ALL-STOP");
  EXPECT_TRUE(Mentions(loop.Page(), "invalid values"));
  EXPECT_TRUE(std::isfinite(loop.desired->heading_deg));
}

TEST(HelmApp, WarnsOfOrdersItDoesNotUnderstandAndChangesNothing) {
  HelmAndVessel loop(Deployed());
  loop.Run(2.5);
  const size_t num_states = loop.states.size();
  loop.Command("selfdestruct");
  loop.Command("goto", {1});
  loop.Command("goto", {std::nan(""), 0});
  loop.Command("speed", {-2});
  loop.Command("task", {}, "nowhere");
  loop.Command("");
  loop.Run(0.4);
  EXPECT_EQ(loop.NumWarnings(), 6u);
  EXPECT_EQ(loop.states.size(), num_states);
  EXPECT_EQ(loop.state.task, "survey");
}

/// A node message of bravo.
node_message_t MessageOfBravo(const std::string& var_name, const std::string& value) {
  node_message_t message{};
  message.src_node = "bravo";
  message.dest_node = "alpha";
  message.var_name = var_name;
  message.string_val = value;
  return message;
}

TEST(HelmApp, ExecutesOrdersThatComeAsNodeMessages) {
  HelmAndVessel loop(TestVehicle());
  loop.Run(1);
  loop.PublishMessage(MessageOfBravo("UPDATE_LOITER", "deploy"));
  loop.Run(1);
  EXPECT_EQ(loop.state.state, "PARK") << "other variables are not orders";
  loop.PublishMessage(MessageOfBravo("HELM_COMMAND", "deploy"));
  loop.Run(1);
  EXPECT_EQ(loop.state.state, "DRIVE");
  loop.PublishMessage(MessageOfBravo("HELM_COMMAND", "station_keep"));
  loop.Run(1);
  EXPECT_EQ(loop.state.task, "station_keep");
}

TEST(HelmApp, WarnsOfMessagesThatAreNoOrders) {
  HelmAndVessel loop(TestVehicle());
  loop.PublishMessage(MessageOfBravo("HELM_COMMAND", "dance"));
  loop.Run(1);
  EXPECT_TRUE(Mentions(loop.Page(), "HELM_COMMAND of bravo refused: unknown command"));
  node_message_t number = MessageOfBravo("HELM_COMMAND", "");
  number.is_double = 1;
  number.double_val = 3;
  loop.PublishMessage(number);
  loop.Run(1);
  EXPECT_TRUE(Mentions(loop.Page(), "a number is not an order"));
}

TEST(HelmApp, ExecutesAllStopAndResume) {
  HelmAndVessel loop(Deployed());
  loop.Run(20);
  loop.Command("all_stop");
  loop.Run(0.3);
  EXPECT_EQ(loop.state.state, "ALL-STOP");
  EXPECT_EQ(loop.state.all_stop, "all_stop command");
  EXPECT_EQ(loop.actuators->thrust_pct, 0);
  EXPECT_EQ(loop.actuators->rudder_deg, 0);
  loop.Run(20);
  EXPECT_EQ(loop.vessel.speed_mps, 0);
  loop.Command("resume");
  loop.Run(10);
  EXPECT_EQ(loop.state.state, "DRIVE");
  EXPECT_NEAR(loop.vessel.speed_mps, 1.5, 0.1);
}

TEST(HelmApp, ShowsTheNearestContactsOnItsPage) {
  HelmAndVessel loop(TestVehicle());
  loop.Run(1);
  for (int i = 0; i < 2000; ++i) {
    node_report_t report{};
    report.name = "boat_" + std::to_string(i);
    report.x_m = 10.0 * (i + 1);
    loop.SayReport(report);
  }
  node_report_t bad{};
  bad.name = "ghost";
  bad.y_m = std::nan("");
  loop.SayReport(bad);
  loop.Run(2);
  const StatusPage page = loop.Page();
  EXPECT_NE(page.text.find("Contacts: 1000"), std::string::npos);
  EXPECT_NE(page.text.find("boat_0           range     10.0 m, age    2.9 s"), std::string::npos);
  EXPECT_NE(page.text.find("boat_9 "), std::string::npos);
  EXPECT_EQ(page.text.find("boat_10 "), std::string::npos);
  EXPECT_TRUE(Mentions(page, "more than 1000 contacts"));
  EXPECT_TRUE(Mentions(page, "invalid position"));
}

}  // namespace shoal::helm_app_test
