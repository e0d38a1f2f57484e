#include "sim/director_app.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lib/bus/bus/memory_bus.h"

namespace shoal::director_app_test {

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
    for (const ControlRow& row : ControlTable()) {
      Subscribe(fleet_, channels::Control(row), [this, &row](const unc_control_t& control) {
        Note(fmt::format("{}{}{} {}", row.channel, control.vehicle.empty() ? "" : " ",
                         control.vehicle, control.value),
             control.utime);
      });
    }
    Subscribe(fleet_, channels::NodeMessageLocal(), [this](const node_message_t& message) {
      messages_.push_back({"local", message});
    });
    Subscribe(fleet_, channels::MediatedMessage("alpha"), [this](const node_message_t& message) {
      messages_.push_back({"mediated", message});
    });
    Subscribe(fleet_, channels::UncControls(),
              [this](const unc_controls_t& controls) { kept_.push_back(controls); });
  }
  void Note(const std::string& text, int64_t utime) {
    received_.push_back(std::to_string((utime - mission_.start_utime) / 1000) + " " + text);
  }
  DirectorApp& Director() {
    if (!director_) director_.emplace(mission_, director_bus_);
    return *director_;
  }
  /// Lets the director handle what was published in the step before, and takes a step.
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
  void PublishNav(const std::string& name, double x_m) {
    nav_t nav = {};
    nav.x_m = x_m;
    Publish(fleet_, channels::Nav(name), nav);
  }
  void PublishControl(const std::string& rule, const std::string& vehicle, double value) {
    unc_control_t control = {};
    control.vehicle = vehicle;
    control.value = value;
    Publish(fleet_, channels::Control(*FindControl(rule)), control);
  }
  /// Returns what the director has kept, as "CHANNEL vehicle value" each.
  std::vector<std::string> AskForControls() {
    kept_.clear();
    Publish(fleet_, channels::UncControlsReq(), unc_controls_req_t{});
    Step();
    Step();
    std::vector<std::string> lines;
    EXPECT_EQ(kept_.size(), 1U);
    for (const unc_controls_t& each : kept_) {
      for (const kept_control_t& kept : each.controls) {
        lines.push_back(
            fmt::format("{} {} {}", kept.channel, kept.control.vehicle, kept.control.value));
      }
    }
    return lines;
  }
  void PublishFate(const std::string& source, const std::string& destination,
                   const std::string& cause, const std::string& kind = "report",
                   int32_t count = 1) {
    comms_fates_t message = {};
    fate_t fate = {};
    fate.kind = kind;
    fate.source = source;
    fate.destination = destination;
    fate.cause = cause;
    fate.count = count;
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
  std::vector<std::string> received_;
  std::vector<std::pair<std::string, node_message_t>> messages_;
  std::vector<unc_controls_t> kept_;
};

TEST_F(DirectorTest, PublishesEachEventOnceInTheFirstStepAtOrAfterItsTime) {
  mission_.events = {
      Command(0, "alpha", "deploy"),
      {.at_s = 0.3, .what = RuleEvent{.rule = "comms_range", .vehicle = "", .value = 50}},
      {.at_s = 0.31, .what = SimCommandEvent{.vehicle = "bravo", .command = "pause", .values = {}}},
      Command(99, "alpha", "park"),
  };
  for (int i = 0; i < 10; ++i) Step();
  EXPECT_EQ(received_, (std::vector<std::string>{"0 alpha deploy ", "300 UNC_COMMS_RANGE 50",
                                                 "400 bravo sim pause"}));
}

TEST_F(DirectorTest, PublishesAnEventToEachMemberOfAGroup) {
  mission_.vehicles[0].group = "sweepers";
  mission_.events = {
      Command(0.1, "group:Sweepers", "deploy"),
      {.at_s = 0.2,
       .what = SimCommandEvent{.vehicle = "group:sweepers", .command = "pause", .values = {}}},
  };
  for (int i = 0; i < 5; ++i) Step();
  EXPECT_EQ(received_, (std::vector<std::string>{"100 bravo deploy ", "200 bravo sim pause"}));
}

TEST_F(DirectorTest, PublishesEventsOfOneTimeInTheMissionsOrder) {
  mission_.events = {
      Command(0.1, "alpha", "task", "b"),
      Command(0.1, "alpha", "task", "a"),
  };
  for (int i = 0; i < 4; ++i) Step();
  EXPECT_EQ(received_, (std::vector<std::string>{"100 alpha task b", "100 alpha task a"}));
}

TEST_F(DirectorTest, PublishesWhatIsForAllToEachVehicle) {
  mission_.events = {Command(0, "all", "return")};
  Step();
  Step();
  EXPECT_EQ(received_, (std::vector<std::string>{"0 alpha return ", "0 bravo return "}));
}

TEST_F(DirectorTest, PublishesEachRuleOnItsChannel) {
  for (const ControlRow& row : ControlTable()) {
    const auto number = static_cast<double>(mission_.events.size() + 1);
    mission_.events.push_back(
        {.at_s = number / 10,
         .what = RuleEvent{.rule = std::string(row.rule),
                           .vehicle = row.of_vehicle ? "alpha" : "",
                           .value = row.type == ControlType::kRequest ? 0.0 : 1.0}});
  }
  for (size_t i = 0; i < ControlTable().size() + 2; ++i) Step();
  ASSERT_EQ(received_.size(), ControlTable().size());
  EXPECT_EQ(received_[0], "100 UNC_COMMS_RANGE 1");
  EXPECT_EQ(received_[2], "300 UNC_STEALTH alpha 1");
  EXPECT_EQ(received_.back(), "1600 UNC_FULL_REPORT_REQ alpha 0");
}

TEST_F(DirectorTest, PublishesMessagesForTheirVehiclesAndLeavesAcksToThem) {
  MessageEvent plain;
  plain.src_node = "alpha";
  plain.dest_node = "bravo:charlie";
  plain.dest_group = "reds";
  plain.var_name = "UPDATE_LOITER";
  plain.string_val = "speed=2.4";
  MessageEvent number = plain;
  number.string_val = "";
  number.double_val = 2.5;
  number.ack = true;
  mission_.events = {{.at_s = 0.1, .what = plain}, {.at_s = 0.2, .what = number}};
  for (int i = 0; i < 4; ++i) Step();
  ASSERT_EQ(messages_.size(), 2U);
  const auto& [channel, first] = messages_[0];
  EXPECT_EQ(channel, "local");
  EXPECT_EQ(first.utime, mission_.UtimeOf(1));
  EXPECT_EQ(first.src_node, "alpha");
  EXPECT_EQ(first.dest_node, "bravo:charlie");
  EXPECT_EQ(first.dest_group, "reds");
  EXPECT_EQ(first.var_name, "UPDATE_LOITER");
  EXPECT_EQ(first.string_val, "speed=2.4");
  EXPECT_FALSE(first.is_double);
  EXPECT_FALSE(first.ack_requested);
  const auto& [mediated, second] = messages_[1];
  EXPECT_EQ(mediated, "mediated");
  EXPECT_EQ(second.double_val, 2.5);
  EXPECT_TRUE(second.is_double);
  EXPECT_TRUE(second.ack_requested);
  EXPECT_EQ(second.ack_id, "");
}

TEST_F(DirectorTest, KeepsTheLastControlOfEachRuleAndVehicleForABrokerThatAsks) {
  mission_.events = {
      {.at_s = 0.1, .what = RuleEvent{.rule = "stealth", .vehicle = "alpha", .value = 0.5}},
      {.at_s = 0.1, .what = RuleEvent{.rule = "full_report", .vehicle = "alpha", .value = 0}}};
  Step();
  EXPECT_EQ(AskForControls(), std::vector<std::string>{});
  PublishControl("comms_range", "", 300);
  PublishControl("stealth", "bravo", 0.25);
  PublishControl("stealth", "BRAVO", 0.75);
  PublishControl("comms_range", "", 250);
  Step();
  EXPECT_EQ(AskForControls(),
            (std::vector<std::string>{"UNC_COMMS_RANGE  250", "UNC_STEALTH alpha 0.5",
                                      "UNC_STEALTH BRAVO 0.75"}));
}

TEST_F(DirectorTest, WarnsOfControlsThatItHasNoRoomFor) {
  Step();
  for (size_t i = 0; i < KeptControls::kMax + 2; ++i) {
    PublishControl("stealth", fmt::format("v{}", i), 0.5);
  }
  Step();
  EXPECT_EQ(AskForControls().size(), KeptControls::kMax);
  ASSERT_EQ(Director().Status().run_warnings.size(), 1U);
  EXPECT_NE(Director().Status().run_warnings[0].find("(2 times)"), std::string::npos);
}

TEST_F(DirectorTest, CountsFatesByKindAndByHowManyTheyAre) {
  Step();
  PublishFate("alpha", "bravo", "delivered", "message");
  PublishFate("alpha", "bravo", "out_of_range", "ack");
  PublishFate("alpha", "*", "out_of_range", "report", 998);
  PublishFate("alpha", "*", "out_of_range", "report", -5);
  PublishFate("alpha", "bravo", "delivered", "rumour");
  Step();
  constexpr int kAll = FateCounts::kAll;
  EXPECT_EQ(Director().fates(Kind::kMessage).CountOffered(kAll, kAll), 1);
  EXPECT_EQ(Director().fates(Kind::kAck).Count(1, 0, "out_of_range"), 1);
  EXPECT_EQ(Director().num_blocked(), 998);
  EXPECT_EQ(Director().num_delivered(), 0);
}

TEST_F(DirectorTest, CountsDeliveredAndBlockedReports) {
  Step();
  PublishFate("alpha", "bravo", "delivered");
  PublishFate("alpha", "bravo", "out_of_range");
  PublishFate("bravo", "alpha", "out_of_range");
  PublishFate("bravo", "alpha", "delivered", "message");
  Step();
  EXPECT_EQ(Director().num_delivered(), 1);
  EXPECT_EQ(Director().num_blocked(), 2);
  EXPECT_EQ(Director().fates(Kind::kReport).Count(1, 0, "out_of_range"), 1);
}

TEST_F(DirectorTest, JudgesByTheStepInWhichAVehicleWasThere) {
  mission_.expectations = {
      {.where = "x.toml:1",
       .what = ArrivalExpectation{
           .vehicle = "alpha", .point_m = Eigen::Vector2d(100, 0), .within_m = 1, .by_s = 0.2}}};
  Step();
  PublishNav("alpha", 0);
  Step();
  EXPECT_FALSE(Director().Passed());
  Step();
  PublishNav("alpha", 100);  // Published in the step of 0.2 s, received in that of 0.3 s.
  Step();
  EXPECT_TRUE(Director().Passed());
  EXPECT_NE(Director().Summary(true).find("there at 0.2 s"), std::string::npos)
      << Director().Summary(true);
}

TEST_F(DirectorTest, JudgesWhatWasPublishedInTheLastStep) {
  mission_.expectations = {
      {.where = "x.toml:1",
       .what = ArrivalExpectation{.vehicle = "alpha", .point_m = Eigen::Vector2d(100, 0)}},
      {.where = "x.toml:9",
       .what = HelmExpectation{.vehicle = "alpha", .state = "PARK", .task = ""}},
  };
  Step();
  PublishNav("alpha", 0);
  Step();
  PublishNav("alpha", 100);
  helm_state_t helm = {};
  helm.state = "PARK";
  Publish(fleet_, channels::HelmState("alpha"), helm);
  EXPECT_TRUE(Director().Summary(true).ends_with("FAIL: 2 of 2 expectations missed\n"));
  End();
  EXPECT_TRUE(Director().Passed());
  EXPECT_TRUE(Director().Summary(true).ends_with("\nPASS\n"));
}

TEST_F(DirectorTest, EndsTheMissionWhenAllVehiclesWithThatEndingAreAtTheEndOfTheirTasks) {
  mission_.vehicles.resize(3);
  mission_.vehicles[2].name = "charlie";
  for (const size_t i : {0U, 1U}) {
    mission_.vehicles[i].helm_options.end_of_tasks = Ending::kEndMission;
  }
  const auto publish = [&](const std::string& name, const std::string& task) {
    helm_state_t helm{};
    helm.state = "DRIVE";
    helm.task = task;
    Publish(fleet_, channels::HelmState(name), helm);
    Step();
    Step();
  };
  Step();
  publish("alpha", "end_of_tasks");
  EXPECT_FALSE(Director().EndsMission()) << "bravo is not done";
  publish("alpha", "survey");
  publish("bravo", "end_of_tasks");
  EXPECT_FALSE(Director().EndsMission()) << "alpha was deployed again";
  publish("alpha", "end_of_tasks");
  EXPECT_TRUE(Director().EndsMission());
  publish("alpha", "survey");
  EXPECT_TRUE(Director().EndsMission()) << "what has ended has ended";
}

TEST_F(DirectorTest, LetsTheMissionRunWhereNoVehicleEndsIt) {
  helm_state_t helm{};
  helm.state = "DRIVE";
  helm.task = "end_of_tasks";
  Step();
  for (const Vehicle& vehicle : mission_.vehicles) {
    Publish(fleet_, channels::HelmState(vehicle.name), helm);
  }
  Step();
  Step();
  EXPECT_FALSE(Director().EndsMission());
}

TEST_F(DirectorTest, StandsNonsense) {
  Step();
  PublishNav("alpha", std::numeric_limits<double>::quiet_NaN());
  fleet_.PublishBytes("COMMS_FATES", {});
  PublishFate(std::string(100'000, 'x'), "", "made up");
  Step();
  EXPECT_EQ(director_bus_.counters().undecodable, 1);
  EXPECT_EQ(Director().num_blocked(), 1);
  EXPECT_EQ(Director().Status().run_warnings.size(), 1U);
}

}  // namespace shoal::director_app_test
