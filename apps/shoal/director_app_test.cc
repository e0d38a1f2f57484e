#include "apps/shoal/director_app.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "lib/bus/memory_bus.h"

namespace shoal {
namespace {

Mission TwoVehicles() {
  Mission mission;
  mission.start_utime = 2'000'000;
  mission.tick_us = 100'000;
  mission.duration_s = 10;
  mission.vehicles.resize(2);
  mission.vehicles[0].name = "bravo";
  mission.vehicles[1].name = "alpha";
  return mission;
}

Event Command(double at_s, const std::string& vehicle, const std::string& command,
              const std::string& argument = "") {
  return {.at_s = at_s,
          .what = CommandEvent{
              .vehicle = vehicle, .command = command, .argument = argument, .values = {}}};
}

class DirectorTest : public testing::Test {
 protected:
  DirectorTest() {
    for (const std::string name : {"alpha", "bravo"}) {
      Subscribe(fleet_, channels::HelmCommand(name), [this, name](const helm_command_t& command) {
        Note(name + " " + command.command + " " + command.argument, command.utime);
      });
      Subscribe(fleet_, channels::SimCommand(name), [this, name](const sim_command_t& command) {
        Note(name + " sim " + command.command, command.utime);
      });
    }
    Subscribe(fleet_, channels::UncCommsRange(), [this](const unc_control_t& control) {
      Note("range " + std::to_string(static_cast<int>(control.value)), control.utime);
    });
  }
  void Note(const std::string& text, int64_t utime) {
    heard_.push_back(std::to_string((utime - mission_.start_utime) / 1000) + " " + text);
  }
  DirectorApp& Director() {
    if (!director_) director_.emplace(mission_, director_bus_);
    return *director_;
  }
  /// Lets the director handle what was said in the step before, and takes a step.
  void Step() {
    Director();
    hub_.NextStep();
    hub_.HandleAll();
    Director().Tick(mission_.UtimeOf(step_++));
  }
  /// Ends the mission as the launcher does.
  void End() {
    hub_.NextStep();
    hub_.HandleAll();
    Director().End();
  }
  void SayNav(const std::string& name, double x_m) {
    nav_t nav = {};
    nav.x_m = x_m;
    Publish(fleet_, channels::Nav(name), nav);
  }
  void SayFate(const std::string& source, const std::string& destination, const std::string& cause,
               const std::string& kind = "report") {
    comms_fates_t message = {};
    fate_t fate = {};
    fate.kind = kind;
    fate.source = source;
    fate.destination = destination;
    fate.cause = cause;
    message.num_fates = 1;
    message.fates = {fate};
    Publish(fleet_, channels::CommsFates(), message);
  }

  Mission mission_ = TwoVehicles();
  MemoryBus hub_;
  Bus& director_bus_ = hub_.Join("shoal");
  Bus& fleet_ = hub_.Join("fleet");
  std::optional<DirectorApp> director_;
  int64_t step_ = 0;
  std::vector<std::string> heard_;
};

TEST_F(DirectorTest, SaysEachEventOnceInTheFirstStepAtOrAfterItsTime) {
  mission_.events = {
      Command(0, "alpha", "deploy"),
      {.at_s = 0.3, .what = RuleEvent{.rule = "comms_range", .vehicle = "", .value = 50}},
      {.at_s = 0.31, .what = SimCommandEvent{.vehicle = "bravo", .command = "pause", .values = {}}},
      Command(99, "alpha", "park"),
  };
  for (int i = 0; i < 10; ++i) Step();
  EXPECT_EQ(heard_,
            (std::vector<std::string>{"0 alpha deploy ", "300 range 50", "400 bravo sim pause"}));
}

TEST_F(DirectorTest, SaysEventsOfOneTimeInTheMissionsOrder) {
  mission_.events = {
      Command(0.1, "alpha", "task", "b"),
      Command(0.1, "alpha", "task", "a"),
  };
  for (int i = 0; i < 4; ++i) Step();
  EXPECT_EQ(heard_, (std::vector<std::string>{"100 alpha task b", "100 alpha task a"}));
}

TEST_F(DirectorTest, SaysWhatIsForAllToEachVehicle) {
  mission_.events = {Command(0, "all", "return")};
  Step();
  Step();
  EXPECT_EQ(heard_, (std::vector<std::string>{"0 alpha return ", "0 bravo return "}));
}

TEST_F(DirectorTest, CountsDeliveredAndBlockedReports) {
  Step();
  SayFate("alpha", "bravo", "delivered");
  SayFate("alpha", "bravo", "out_of_range");
  SayFate("bravo", "alpha", "out_of_range");
  SayFate("bravo", "alpha", "delivered", "message");
  Step();
  EXPECT_EQ(Director().num_delivered(), 1);
  EXPECT_EQ(Director().num_blocked(), 2);
  EXPECT_EQ(Director().fates().Count(1, 0, "out_of_range"), 1);
}

TEST_F(DirectorTest, JudgesByTheStepInWhichAVehicleWasThere) {
  mission_.expectations = {
      {.where = "x.toml:1",
       .what = ArrivalExpectation{
           .vehicle = "alpha", .point_m = Eigen::Vector2d(100, 0), .within_m = 1, .by_s = 0.2}}};
  Step();
  SayNav("alpha", 0);
  Step();
  EXPECT_FALSE(Director().Passed());
  Step();
  SayNav("alpha", 100);  // Said in the step of 0.2 s, heard in that of 0.3 s.
  Step();
  EXPECT_TRUE(Director().Passed());
  EXPECT_NE(Director().Summary().find("there at 0.2 s"), std::string::npos) << Director().Summary();
}

TEST_F(DirectorTest, MindsWhatWasSaidInTheLastStep) {
  mission_.expectations = {
      {.where = "x.toml:1",
       .what = ArrivalExpectation{.vehicle = "alpha", .point_m = Eigen::Vector2d(100, 0)}},
      {.where = "x.toml:9",
       .what = HelmExpectation{.vehicle = "alpha", .state = "PARK", .task = ""}},
  };
  Step();
  SayNav("alpha", 0);
  Step();
  SayNav("alpha", 100);
  helm_state_t helm = {};
  helm.state = "PARK";
  Publish(fleet_, channels::HelmState("alpha"), helm);
  EXPECT_TRUE(Director().Summary().ends_with("FAIL: 2 of 2 expectations missed\n"));
  End();
  EXPECT_TRUE(Director().Passed());
  EXPECT_TRUE(Director().Summary().ends_with("\nPASS\n"));
}

TEST_F(DirectorTest, StandsNonsense) {
  Step();
  SayNav("alpha", std::numeric_limits<double>::quiet_NaN());
  fleet_.PublishBytes("COMMS_FATES", {});
  SayFate(std::string(100'000, 'x'), "", "made up");
  Step();
  EXPECT_EQ(director_bus_.counters().undecodable, 1);
  EXPECT_EQ(Director().num_blocked(), 1);
  EXPECT_EQ(Director().Status().run_warnings.size(), 1U);
}

}  // namespace
}  // namespace shoal
