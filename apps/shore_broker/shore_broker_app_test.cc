#include "apps/shore_broker/shore_broker_app.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>

#include "apps/shore_broker/broker_testing.h"

namespace shoal::shore_broker_app_test {

class ShoreBrokerTest : public BrokerFixture {};

TEST_F(ShoreBrokerTest, HandsOnTheVeryBytesThatCameIn) {
  const node_report_t report = ReportFrom("alpha", 0);
  Send(report);
  Send(ReportFrom("bravo", 249));
  Step();
  Bytes expected;
  EncodeInto(report, &expected);
  ASSERT_EQ(received_["bravo"].size(), 1U);
  EXPECT_EQ(received_["bravo"][0], expected);
  EXPECT_EQ(received_["alpha"].size(), 1U) << "both are known before either is routed";
}

TEST_F(ShoreBrokerTest, PublishesAFateForEveryPair) {
  Send(ReportFrom("alpha", 0));
  Send(ReportFrom("bravo", 249));
  Send(ReportFrom("charlie", 251));
  Step();
  ASSERT_EQ(fates_.size(), 6U);
  EXPECT_EQ(fates_[0].source + ">" + fates_[0].destination, "alpha>bravo");
  EXPECT_EQ(fates_[0].cause, "delivered");
  EXPECT_EQ(fates_[0].range_m, 249);
  EXPECT_EQ(fates_[1].source + ">" + fates_[1].destination, "alpha>charlie");
  EXPECT_EQ(fates_[1].cause, "out_of_range");
  EXPECT_EQ(fates_[1].limit_m, 250);
}

TEST_F(ShoreBrokerTest, RoutesEachOfSeveralReportsOfOneStepFromItsOwnPlace) {
  Send(ReportFrom("bravo", 0));
  Step();
  Send(ReportFrom("alpha", 1000));
  Send(ReportFrom("alpha", 100));
  Step();
  ASSERT_EQ(fates_.size(), 2U);
  EXPECT_EQ(fates_[0].cause, "out_of_range");
  EXPECT_EQ(fates_[0].number, 0);
  EXPECT_EQ(fates_[1].cause, "delivered");
  EXPECT_EQ(fates_[1].number, 1);
}

TEST_F(ShoreBrokerTest, ReceivesVehiclesFromOutside) {
  Send(ReportFrom("alpha", 0));
  Publish(listener_, channels::NodeReportFromOutside(), ReportFrom("Charlie", 10));
  Step();
  EXPECT_EQ(received_["alpha"].size(), 1U);
  EXPECT_EQ(received_["charlie"].size(), 1U);
}

TEST_F(ShoreBrokerTest, StopsReportsToASilentVehicle) {
  Send(ReportFrom("bravo", 0));
  Step();
  Send(ReportFrom("alpha", 0));
  Step(4'900'000);
  EXPECT_EQ(fates_.at(0).cause, "delivered");
  Send(ReportFrom("alpha", 0));
  Step(100'000);
  EXPECT_EQ(fates_.at(0).cause, "stale_receiver");
  EXPECT_EQ(fates_.at(0).age_s, 5);
  EXPECT_TRUE(PageHas("Stale Vehicles: 1"));
}

TEST_F(ShoreBrokerTest, FollowsAChangeOfTheRangeInTheSameStep) {
  Send(ReportFrom("alpha", 0));
  Send(ReportFrom("bravo", 300));
  Send("comms_range", 301);
  Step();
  EXPECT_EQ(fates_.at(0).cause, "delivered");
}

TEST_F(ShoreBrokerTest, RefusesAnImpossibleRuleAndKeepsTheOld) {
  Send("comms_range", std::numeric_limits<double>::quiet_NaN());
  Send("stale_time", std::numeric_limits<double>::infinity());
  Send("stale_time", 1, "alpha");
  Step();
  EXPECT_TRUE(PageHas("Comms Range: 250"));
  EXPECT_TRUE(PageHas("Stale Drop: 5"));
  EXPECT_EQ(broker_.Status().run_warnings.size(), 3U);
}

TEST_F(ShoreBrokerTest, HandsACommandOnToTheMissionAndToEveryKnownUnregisteredVehicle) {
  Send(ReportFrom("charlie", 0));
  helm_command_t command = {};
  command.command = "return";
  Publish(listener_, channels::HelmCommandAll(), command);
  Step();
  EXPECT_EQ(orders_, (std::map<std::string, std::string>{{"alpha", "return"}, {"bravo", "return"}}))
      << "charlie was not known yet";
  Publish(listener_, channels::HelmCommandAll(), command);
  Step();
  EXPECT_EQ(orders_.size(), 3U);
  EXPECT_TRUE(PageHas("Helm Commands Handed On: 2"));
}

TEST_F(ShoreBrokerTest, GivesAnInvalidReportAFateWithoutDestination) {
  Send(ReportFrom("bravo", 0));
  Send(ReportFrom("alpha", std::numeric_limits<double>::quiet_NaN()));
  node_report_t turned = ReportFrom("bravo", 0);
  turned.heading_deg = std::numeric_limits<double>::infinity();
  Send(turned);
  Send(ReportFrom(std::string(10'000, 'x'), 0));
  Step();
  ASSERT_EQ(fates_.size(), 3U);
  EXPECT_EQ(fates_[0].source, "alpha");
  EXPECT_EQ(fates_[1].source, "bravo");
  EXPECT_EQ(fates_[2].source, "");
  for (const fate_t& fate : fates_) {
    EXPECT_EQ(fate.cause, "invalid");
    EXPECT_EQ(fate.destination, "");
  }
  EXPECT_TRUE(PageHas("Invalid: 3"));
  EXPECT_TRUE(PageHas("Known Vehicles: 1"));
  EXPECT_FALSE(broker_.Status().run_warnings.empty());
}

TEST_F(ShoreBrokerTest, DropsAndCountsBytesThatAreNoMessage) {
  const Bytes garbage = {1, 2, 3};
  listener_.PublishBytes("NODE_REPORT_LOCAL", garbage);
  listener_.PublishBytes("NODE_REPORT", garbage);
  listener_.PublishBytes("HELM_COMMAND", garbage);
  listener_.PublishBytes("UNC_COMMS_RANGE", {});
  Step();
  EXPECT_EQ(broker_bus_.counters().undecodable, 4);
  EXPECT_TRUE(PageHas("Undecodable Messages: 4"));
  EXPECT_TRUE(orders_.empty());
}

TEST_F(ShoreBrokerTest, OutlivesABurstOfMadeUpNamesWithAFateForEveryPair) {
  for (int i = 0; i < 100; ++i) Send(ReportFrom("nemo" + std::to_string(i), 1e300 * i));
  Step();
  EXPECT_TRUE(PageHas("Known Vehicles: 100"));
  EXPECT_EQ(fates_.size(), 100U * 99);
}

TEST_F(ShoreBrokerTest, ShowsAgesAndRatesAsTheManualDoes) {
  for (int i = 0; i < 20; ++i) {
    Send(ReportFrom("alpha", 0));
    Step(500'000);
  }
  Send(ReportFrom("bravo", 0));
  Step(500'000);
  EXPECT_TRUE(
      PageHas("    Total Received: 21           Elapsed      Rate\n"
              "        ALPHA: 20                  (0.5)    [2.00]\n"
              "        BRAVO: 1                   (0.0)    [0.10]\n"))
      << broker_.Status().text;
  EXPECT_TRUE(PageHas("    Total Sent: 1\n        ALPHA: 1\n"));
}

}  // namespace shoal::shore_broker_app_test
