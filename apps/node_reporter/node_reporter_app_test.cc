#include "apps/node_reporter/node_reporter_app.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lib/bus/bus/memory_bus.h"

namespace shoal::node_reporter_app_test {

constexpr int64_t kTick_us = 100'000;

Mission OneVehicle() {
  Mission mission;
  mission.seed = 7;
  mission.tick_us = kTick_us;
  mission.start_utime = 1'000'000;
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.type = "auv";
  vehicle.group = "red";
  vehicle.color = "orange";
  vehicle.length_m = 2.5;
  vehicle.reporter_options.extra = {{"payload", "ctd"}};
  mission.vehicles = {vehicle};
  return mission;
}

nav_t NavAt(double x_m, int64_t utime = 1) {
  nav_t nav = {};
  nav.utime = utime;
  nav.x_m = x_m;
  nav.y_m = -20;
  nav.z_m = 3;
  nav.lat_deg = 43.8;
  nav.lon_deg = -70.3;
  nav.heading_deg = 90;
  nav.speed_mps = 1;
  nav.speed_over_ground_mps = 1;
  nav.course_over_ground_deg = 90;
  nav.altitude_m = -1;
  return nav;
}

class NodeReporterTest : public testing::Test {
 protected:
  NodeReporterTest() {
    Subscribe(vehicle_bus_, channels::NodeReportLocal(),
              [this](const node_report_t& report) { reports_.push_back(report); });
  }
  ReporterOptions& options() { return mission_.vehicles[0].reporter_options; }

  /// Runs one step in which the app receives what was published before.
  void Step() {
    if (!app_) app_ = std::make_unique<NodeReporterApp>(mission_, mission_.vehicles[0], app_bus_);
    hub_.NextStep();
    hub_.HandleAll();
    app_->Tick(mission_.UtimeOf(step_++));
  }
  /// Steps with a NAV that moves East at 1 m/s.
  void StepsWithNav(int count) {
    for (int i = 0; i < count; ++i) {
      Publish(vehicle_bus_, channels::Nav("alpha"),
              NavAt(static_cast<double>(step_) * 0.1, mission_.UtimeOf(step_)));
      Step();
    }
  }
  void Steps(int count) {
    for (int i = 0; i < count; ++i) Step();
  }
  /// Returns all reports so far.
  const std::vector<node_report_t>& Reports() {
    hub_.NextStep();
    hub_.HandleAll();
    return reports_;
  }
  void SayHelm(const std::string& state, const std::string& task) {
    helm_state_t helm = {};
    helm.state = state;
    helm.task = task;
    helm.all_stop = "by the helm";
    Publish(vehicle_bus_, channels::HelmState("alpha"), helm);
  }

  Mission mission_ = OneVehicle();
  MemoryBus hub_;
  Bus& app_bus_ = hub_.Join("node_reporter_alpha");
  Bus& vehicle_bus_ = hub_.Join("vehicle");
  std::unique_ptr<NodeReporterApp> app_;
  int64_t step_ = 0;
  std::vector<node_report_t> reports_;
};

TEST_F(NodeReporterTest, ReportsWhatNavAndTheMissionHold) {
  StepsWithNav(1);
  ASSERT_EQ(Reports().size(), 1U);
  const node_report_t& report = reports_[0];
  EXPECT_EQ(report.utime, 1'000'000);
  EXPECT_EQ(report.name, "alpha");
  EXPECT_EQ(report.type, "auv");
  EXPECT_EQ(report.group, "red");
  EXPECT_EQ(report.color, "orange");
  EXPECT_EQ(report.length_m, 2.5);
  EXPECT_EQ(report.y_m, -20);
  EXPECT_EQ(report.depth_m, 3);
  EXPECT_EQ(report.altitude_m, -1);
  EXPECT_EQ(report.lat_deg, 43.8);
  EXPECT_EQ(report.lon_deg, -70.3);
  EXPECT_EQ(report.heading_deg, 90);
  EXPECT_EQ(report.course_over_ground_deg, 90);
  ASSERT_EQ(report.num_extra, 1);
  EXPECT_EQ(report.extra[0].key, "payload");
  EXPECT_EQ(report.extra[0].value, "ctd");
}

TEST_F(NodeReporterTest, CarriesTheTimeOfItsPosition) {
  Publish(vehicle_bus_, channels::Nav("alpha"), NavAt(7, mission_.UtimeOf(0)));
  step_ = 1;
  Step();
  ASSERT_EQ(Reports().size(), 1U);
  EXPECT_EQ(reports_[0].x_m, 7);
  EXPECT_EQ(reports_[0].utime, mission_.UtimeOf(0)) << "a step before it was made";
}

TEST_F(NodeReporterTest, TakesNavWithoutATimeOfTheMissionAtItsStep) {
  for (const int64_t utime : {int64_t{0}, int64_t{-5'000'000}, int64_t{1'000'000'000}}) {
    Publish(vehicle_bus_, channels::Nav("alpha"), NavAt(7, utime));
    step_ += 100;
    Step();
    EXPECT_EQ(Reports().back().utime, mission_.UtimeOf(step_ - 1)) << utime;
  }
}

TEST_F(NodeReporterTest, KeepsItsRateAndCountsItsReports) {
  StepsWithNav(21);
  ASSERT_EQ(Reports().size(), 5U);
  for (size_t i = 0; i < reports_.size(); ++i) {
    EXPECT_EQ(reports_[i].index, static_cast<int64_t>(i));
    EXPECT_EQ(reports_[i].utime, 1'000'000 + static_cast<int64_t>(i) * 500'000);
  }
}

TEST_F(NodeReporterTest, WarnsOfARateAboveTheStepsAndReportsInEachStep) {
  options().rate_hz = 20;
  StepsWithNav(5);
  EXPECT_EQ(Reports().size(), 5U);
  EXPECT_EQ(app_->Status().config_warnings.size(), 1U);
}

TEST_F(NodeReporterTest, IsSilentUntilThereIsNav) {
  Steps(10);
  EXPECT_TRUE(Reports().empty());
  EXPECT_TRUE(app_->Status().run_warnings.empty()) << "the grace period goes on";
}

TEST_F(NodeReporterTest, WarnsOfMissingNavAfterTheGracePeriodUntilNavIsBack) {
  options().nav_grace_period_s = 1;
  Steps(10);
  EXPECT_TRUE(app_->Status().run_warnings.empty());
  Steps(1);
  EXPECT_EQ(app_->Status().run_warnings.size(), 1U);
  StepsWithNav(1);
  EXPECT_TRUE(app_->Status().run_warnings.empty());
}

TEST_F(NodeReporterTest, FallsSilentWhenNavIsTwoSecondsOld) {
  options().rate_hz = 10;
  options().nav_grace_period_s = 0;
  StepsWithNav(1);
  Steps(20);
  EXPECT_EQ(Reports().size(), 21U);
  EXPECT_TRUE(app_->Status().run_warnings.empty());
  Steps(5);
  EXPECT_EQ(Reports().size(), 21U);
  EXPECT_EQ(app_->Status().run_warnings.size(), 1U);
}

TEST_F(NodeReporterTest, DropsInvalidNav) {
  nav_t nav = NavAt(0);
  nav.heading_deg = std::numeric_limits<double>::quiet_NaN();
  Publish(vehicle_bus_, channels::Nav("alpha"), nav);
  vehicle_bus_.PublishBytes("NAV_ALPHA", {});
  Step();
  EXPECT_TRUE(Reports().empty());
  EXPECT_EQ(app_->Status().run_warnings.size(), 1U);
  EXPECT_EQ(app_bus_.counters().undecodable, 1);
}

TEST_F(NodeReporterTest, ReportsTheHelmsStateAndTask) {
  SayHelm("DRIVE", "survey");
  StepsWithNav(5);
  SayHelm("PARK", "");
  StepsWithNav(1);
  ASSERT_EQ(Reports().size(), 2U);
  EXPECT_EQ(reports_[0].mode, "DRIVE:survey");
  EXPECT_EQ(reports_[0].all_stop, "by the helm");
  EXPECT_EQ(reports_[1].mode, "PARK");
}

TEST_F(NodeReporterTest, ReportsThatThereIsNoHelm) {
  options().rate_hz = 1;
  StepsWithNav(1);
  SayHelm("DRIVE", "survey");
  StepsWithNav(70);
  ASSERT_EQ(Reports().size(), 8U);
  EXPECT_EQ(reports_[0].mode, "NOHELM-EVER");
  EXPECT_EQ(reports_[0].all_stop, "clear");
  EXPECT_EQ(reports_[5].mode, "DRIVE:survey");
  EXPECT_EQ(reports_[6].mode, "NOHELM-6");
}

TEST_F(NodeReporterTest, SkipsWhatDeadReckoningPredictsButNotForTooLong) {
  options().extrapolate = true;
  options().extrap_max_gap_s = 3;
  StepsWithNav(61);
  ASSERT_EQ(Reports().size(), 3U);
  EXPECT_EQ(reports_[1].utime - reports_[0].utime, 3'000'000);
  EXPECT_EQ(reports_[2].index, 2);
}

TEST_F(NodeReporterTest, ShowsWhatBecameOfMessagesAndAcks) {
  Step();
  node_message_t message = {};
  message.dest_node = "bravo";
  message.var_name = "FOOBAR";
  message.ack_id = "a-1";
  Publish(vehicle_bus_, channels::MediatedMessage("alpha"), message);
  ack_message_t ack = {};
  ack.src_node = "bravo";
  ack.dest_node = "alpha";
  ack.ack_id = "long gone";
  Publish(vehicle_bus_, channels::AckMessageTo("alpha"), ack);
  Step();
  const std::string page = app_->Status().text;
  for (const char* line : {"Messages to be acknowledged: 1\n", "    Waiting: 1\n",
                           "    Acknowledged: 0\n", "Acks that nothing waits for: 1\n"}) {
    EXPECT_NE(page.find(line), std::string::npos) << line << page;
  }
}

TEST_F(NodeReporterTest, KeepsTheBlackoutIntervalWithinItsVariance) {
  options().rate_hz = 10;
  options().blackout_interval_s = 3;
  options().blackout_variance_s = 1;
  StepsWithNav(600);
  ASSERT_GT(Reports().size(), 14U);
  int64_t shortest = 100'000'000;
  int64_t longest = 0;
  for (size_t i = 1; i < reports_.size(); ++i) {
    const int64_t gap = reports_[i].utime - reports_[i - 1].utime;
    shortest = std::min(shortest, gap);
    longest = std::max(longest, gap);
  }
  EXPECT_GE(shortest, 2'000'000);
  EXPECT_LE(longest, 4'100'000) << "4 s, and up to one step more";
  EXPECT_GT(longest - shortest, 500'000);
}

}  // namespace shoal::node_reporter_app_test
