// Rules that change while the mission runs, and a broker that is started again.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "apps/shore_broker/broker_testing.h"

namespace shoal::broker_control_test {

using Texts = std::vector<std::string>;

class BrokerControlTest : public BrokerFixture {
 protected:
  /// Both report from where they are; returns the fates.
  Texts BothReport(double apart_m) {
    Send(ReportFrom("alpha", 0));
    Send(ReportFrom("bravo", apart_m));
    Step();
    return Fates();
  }
};

TEST_F(BrokerControlTest, PublishesTheRulesAtItsStartAndWhenOneChanges) {
  Step();
  ASSERT_EQ(rules_.size(), 1U);
  EXPECT_TRUE(rules_[0].is_start);
  EXPECT_EQ(rules_[0].rules.comms_range_m, 250);
  ASSERT_EQ(rules_[0].vehicles.size(), 2U);
  EXPECT_EQ(rules_[0].vehicles[1].name, "bravo");
  Step();
  EXPECT_EQ(rules_.size(), 1U);
  Send("comms_range", 300);
  Step();
  ASSERT_EQ(rules_.size(), 2U);
  EXPECT_FALSE(rules_[1].is_start);
  EXPECT_EQ(rules_[1].rules.comms_range_m, 300);
  Send("comms_range", 300);
  Step();
  EXPECT_EQ(rules_.size(), 2U) << "nothing changed";
}

TEST_F(BrokerControlTest, AnswersARequestForTheRulesInForceOutsideStepping) {
  const std::string channel = channels::CommsRulesReq().name;
  EXPECT_EQ(broker_.RequestChannels(), Texts{channel});
  Bytes request;
  EncodeInto(comms_rules_req_t{}, &request);
  EXPECT_FALSE(broker_.Answer(channel, request))
      << "before its first step it has no rules in force";
  Step();
  Send("comms_range", 300);
  Send("stealth", 0.5, "alpha");
  Step();
  const size_t num_published = rules_.size();
  const auto answer = broker_.Answer(channel, request);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->channel, channels::CommsRulesNow().name);
  EXPECT_TRUE(IsAnswer(answer->channel));
  const auto rules = ReadBrokerRules(answer->data);
  ASSERT_TRUE(rules);
  EXPECT_EQ(rules->utime, utime_);
  EXPECT_FALSE(rules->is_start);
  EXPECT_EQ(rules->rules.comms_range_m, 300);
  ASSERT_EQ(rules->factors.size(), 1U);
  EXPECT_EQ(rules->factors[0].second.stealth, 0.5);
  Step();
  EXPECT_EQ(rules_.size(), num_published) << "the mission does not notice";
  EXPECT_FALSE(broker_.Answer(channel, Bytes{1, 2, 3}));
  EXPECT_FALSE(broker_.Answer("COMMS_RULES", request));
}

TEST_F(BrokerControlTest, PublishesRulesFromWhichAnEqualBrokerIsMade) {
  Send("stealth", 0.5, "alpha");
  Send("groups", 1);
  Step();
  const auto setup = SetupOf(rules_.at(0));
  ASSERT_TRUE(setup.ok()) << setup.error();
  EXPECT_EQ(setup->rules.comms_range_m, 250);
  EXPECT_TRUE(setup->rules.groups);
  EXPECT_EQ(setup->vehicles, (Texts{"alpha", "bravo"}));
  ASSERT_EQ(setup->factors.size(), 1U);
  EXPECT_EQ(setup->factors[0].second.stealth, 0.5);
}

TEST_F(BrokerControlTest, TakesNoImpossibleRecordedRules) {
  Step();
  BrokerRules rules = rules_.at(0);
  rules.rules.drop_percentage = 101;
  EXPECT_FALSE(SetupOf(rules).ok());
  rules = rules_.at(0);
  rules.vehicles[1].name = "ALPHA";
  EXPECT_FALSE(SetupOf(rules).ok());
  rules = rules_.at(0);
  rules.tick_us = 0;
  EXPECT_FALSE(SetupOf(rules).ok());
  rules = rules_.at(0);
  rules.rules.stale_forget_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(SetupOf(rules).ok());
  rules = rules_.at(0);
  rules.factors = {{"alpha", {.stealth = 0.5, .earange = 11}}};
  EXPECT_FALSE(SetupOf(rules).ok());
  rules = rules_.at(0);
  rules.wrong = {"groups is a text, not a flag"};
  EXPECT_FALSE(SetupOf(rules).ok());
}

TEST_F(BrokerControlTest, FollowsEveryChannelOfTheTable) {
  for (const ControlRow& row : ControlTable()) {
    if (row.type == ControlType::kRequest) continue;
    const ControlValue value = row.min > 0 ? row.min : std::min(1.0, row.max);
    const ControlValue word = std::string("Ghosts");
    Send(row.rule, row.type == ControlType::kText ? word : value, row.of_vehicle ? "alpha" : "");
  }
  Step();
  EXPECT_TRUE(broker_.Status().run_warnings.empty());
  EXPECT_EQ(broker_.router().rules().comms_range_m, 1);
  EXPECT_EQ(broker_.router().rules().max_msg_length_bytes, 1);
  EXPECT_TRUE(broker_.router().rules().groups);
  EXPECT_EQ(broker_.router().rules().ignore_group, "Ghosts");
}

TEST_F(BrokerControlTest, IgnoresAGroupFromNowOnAndTakesItInAgain) {
  const auto report = [&] {
    node_report_t ghost = ReportFrom("alpha", 0);
    ghost.group = "ghosts";
    Send(ghost);
    Step();
    return Fates();
  };
  BothReport(10);
  EXPECT_EQ(report(), Texts{"alpha>bravo delivered"});
  Send("ignore_group", std::string("Ghosts"));
  EXPECT_EQ(report(), Texts{"alpha> ignored_group"});
  EXPECT_TRUE(PageHas("Ignore Group: Ghosts\n"));
  Send("ignore_group", std::string("two\nlines"));
  Send("ignore_group", std::string("elves"), "alpha");
  EXPECT_EQ(report(), Texts{"alpha> ignored_group"});
  EXPECT_EQ(broker_.Status().run_warnings.size(), 2U);
  Send("ignore_group", std::string());
  EXPECT_EQ(report(), Texts{"alpha>bravo delivered"});
  EXPECT_EQ(rules_.back().rules.ignore_group, "");
}

TEST_F(BrokerControlTest, ShortensTheRangeOfASource) {
  EXPECT_EQ(BothReport(200), (Texts{"alpha>bravo delivered", "bravo>alpha delivered"}));
  Send("stealth", 0.8, "ALPHA");
  EXPECT_EQ(BothReport(200), (Texts{"alpha>bravo out_of_range", "bravo>alpha delivered"}));
  Send("stealth", 0.81, "alpha");
  EXPECT_EQ(BothReport(200), (Texts{"alpha>bravo delivered", "bravo>alpha delivered"}));
}

TEST_F(BrokerControlTest, KeepsTheOldFactorWhereTheNewIsImpossible) {
  Send("earange", 2, "bravo");
  Step();
  for (const double bad : {0.99, 10.01, std::numeric_limits<double>::quiet_NaN()}) {
    Send("earange", bad, "bravo");
  }
  Send("earange", 2, "");
  EXPECT_EQ(BothReport(400), (Texts{"alpha>bravo delivered", "bravo>alpha out_of_range"}));
  EXPECT_EQ(broker_.Status().run_warnings.size(), 4U);
  EXPECT_TRUE(PageHas("BRAVO: stealth 1, earange 2"));
}

TEST_F(BrokerControlTest, KeepsAFactorForAVehicleThatIsNotKnownYet) {
  Send("earange", 2, "charlie");
  Step();
  Send(ReportFrom("charlie", 400));
  Send(ReportFrom("alpha", 0));
  Step();
  EXPECT_EQ(Fates(), (Texts{"charlie>alpha out_of_range", "alpha>charlie delivered"}));
}

TEST_F(BrokerControlTest, DeliversTheNextReportOfEachOtherVehicleOnRequest) {
  BothReport(5000);
  Send("full_report", 0, "bravo");
  EXPECT_EQ(BothReport(5000), (Texts{"alpha>bravo delivered", "bravo>alpha out_of_range"}));
  EXPECT_EQ(fates_.at(0).override_rule, "full_report");
  EXPECT_EQ(BothReport(5000), (Texts{"alpha>bravo out_of_range", "bravo>alpha out_of_range"}));
}

TEST_F(BrokerControlTest, RefusesARequestWithoutAVehicle) {
  Send("full_report", 0, "nemo");
  Step();
  EXPECT_EQ(broker_.Status().run_warnings.size(), 1U);
}

TEST_F(BrokerControlTest, SharesReportsAtTheRateThatEyesCanFollow) {
  broker_.OnWarp(10);
  Send("shared_node_reports", 0.1);
  int64_t num_shared = 0;
  for (int step = 0; step < 100; ++step) {
    Send(ReportFrom("alpha", 0));
    Step();
    num_shared += static_cast<int64_t>(shared_.size());
  }
  EXPECT_EQ(num_shared, 10) << "ten steps of 0.1 s at warp 10 are 0.1 s of wall time";
  Send("shared_node_reports", -1);
  Send(ReportFrom("alpha", 0));
  Step();
  EXPECT_TRUE(shared_.empty());
}

TEST_F(BrokerControlTest, SharesEachVehicleByItself) {
  Send("shared_node_reports", 1000);
  BothReport(10);
  EXPECT_EQ(shared_, (Texts{"alpha", "bravo"}));
}

TEST_F(BrokerControlTest, WorksAtOnceInTheMissionsFirstStep) {
  EXPECT_EQ(BothReport(10).size(), 2U);
  EXPECT_EQ(num_requests_, 0);
}

/// A broker whose first step is not the mission's.
class LateBrokerTest : public BrokerControlTest {
 protected:
  LateBrokerTest() { utime_ = kStart_utime + 7'000'000; }
  void Answer(const std::vector<kept_control_t>& controls) {
    unc_controls_t answer = {};
    answer.controls = controls;
    answer.num_controls = static_cast<int32_t>(controls.size());
    Publish(listener_, channels::UncControls(), answer);
  }
  static kept_control_t Kept(const std::string& channel, double value,
                             const std::string& vehicle = "") {
    return {.channel = channel,
            .control = {.utime = 0, .vehicle = vehicle, .value = value, .text = ""}};
  }

  Bus& unnamed_ = hub_.Join("");  ///< Outside the step protocol there are no names.
};

TEST_F(LateBrokerTest, IgnoresControlsFromUnregisteredParticipants) {
  BothReport(300);
  unc_controls_t answer = {};
  answer.controls = {Kept("UNC_COMMS_RANGE", 200)};
  answer.num_controls = 1;
  Publish(unnamed_, channels::UncControls(), answer);
  Step();
  EXPECT_TRUE(Fates().empty()) << "it waits still";
  Answer({Kept("UNC_COMMS_RANGE", 400)});
  Step();
  EXPECT_EQ(Fates(), (Texts{"alpha>bravo delivered", "bravo>alpha delivered"}));
  EXPECT_EQ(broker_.Status().run_warnings.size(), 1U);
}

TEST_F(LateBrokerTest, AsksForTheControlsThatItMissedAndHoldsInputsUntilItHasThem) {
  EXPECT_TRUE(BothReport(300).empty());
  EXPECT_EQ(num_requests_, 1);
  EXPECT_TRUE(rules_.empty());
  Answer({Kept("UNC_COMMS_RANGE", 400), Kept("UNC_STEALTH", 0.5, "alpha"), Kept("NONSENSE", 1)});
  Step();
  EXPECT_EQ(Fates(), (Texts{"alpha>bravo out_of_range", "bravo>alpha delivered"}));
  EXPECT_EQ(received_["alpha"].size(), 1U);
  ASSERT_EQ(rules_.size(), 1U);
  EXPECT_TRUE(rules_[0].is_start);
  EXPECT_EQ(rules_[0].rules.comms_range_m, 400);
  EXPECT_EQ(num_requests_, 1);
}

TEST_F(LateBrokerTest, LetsALaterControlPrevailOverWhatItMissed) {
  Step();
  Answer({Kept("UNC_COMMS_RANGE", 400)});
  Send("comms_range", 200);
  EXPECT_EQ(BothReport(300), (Texts{"alpha>bravo out_of_range", "bravo>alpha out_of_range"}));
}

TEST_F(LateBrokerTest, GoesOnWithTheMissionsRulesWithoutAnAnswer) {
  for (int step = 0; step < 10; ++step) EXPECT_TRUE(BothReport(200).empty());
  EXPECT_EQ(BothReport(200).size(), 22U) << "nothing that it received meanwhile is lost";
  EXPECT_EQ(broker_.Status().run_warnings.size(), 1U);
}

TEST_F(LateBrokerTest, HandsOnCommandsMeanwhile) {
  helm_command_t command = {};
  command.command = "return";
  Publish(listener_, channels::HelmCommandAll(), command);
  Step();
  EXPECT_EQ(orders_.size(), 2U);
}

}  // namespace shoal::broker_control_test
