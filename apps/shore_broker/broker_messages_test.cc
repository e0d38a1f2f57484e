// What the broker does with node messages, acks and pulses.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "apps/shore_broker/broker_testing.h"

namespace shoal::broker_messages_test {

using Texts = std::vector<std::string>;

class BrokerMessagesTest : public BrokerFixture {
 protected:
  BrokerMessagesTest() {
    Send(ReportFrom("alpha", 0));
    Send(ReportFrom("bravo", 100));
    Step();
  }
  int64_t FatesOf(const std::string& kind) const {
    return std::count_if(fates_.begin(), fates_.end(),
                         [&](const fate_t& fate) { return fate.kind == kind; });
  }
};

TEST_F(BrokerMessagesTest, HandsOnTheVeryBytesThatCameIn) {
  const node_message_t message = MessageFrom("alpha", "bravo");
  Send(message);
  Step();
  Bytes expected;
  EncodeInto(message, &expected);
  ASSERT_EQ(messages_["bravo"].size(), 1U);
  EXPECT_EQ(messages_["bravo"][0], expected);
  EXPECT_TRUE(messages_["alpha"].empty());
  ASSERT_EQ(fates_.size(), 1U);
  EXPECT_EQ(fates_[0].kind, "message");
  EXPECT_EQ(fates_[0].cause, "delivered");
  EXPECT_EQ(fates_[0].range_m, 100);
  EXPECT_EQ(fates_[0].limit_m, 250);
  EXPECT_EQ(fates_[0].length_bytes, 5);
  EXPECT_EQ(fates_[0].length_limit_bytes, 1000);
}

TEST_F(BrokerMessagesTest, ReceivesMessagesFromOutside) {
  Publish(listener_, channels::NodeMessageFromOutside(), MessageFrom("bravo", "alpha"));
  Step();
  EXPECT_EQ(messages_["alpha"].size(), 1U);
}

TEST_F(BrokerMessagesTest, NamesAnUnknownDestinationAsItWasWritten) {
  Send(MessageFrom("alpha", "bravo:Gilda:" + std::string("x\x01y")));
  Step();
  EXPECT_EQ(Fates(), (Texts{"alpha>bravo delivered", "alpha>Gilda unknown_destination",
                            "alpha>x?y unknown_destination"}));
}

TEST_F(BrokerMessagesTest, ReportsTheSecondsLeftToWait) {
  Send(MessageFrom("alpha", "bravo"));
  Step();
  Send(MessageFrom("alpha", "bravo"));
  Step(20'000'000);
  Send(ReportFrom("alpha", 0));
  ASSERT_EQ(Fates(), (Texts{"alpha>bravo too_soon"}));
  EXPECT_DOUBLE_EQ(fates_[0].wait_s, 10);
}

TEST_F(BrokerMessagesTest, RefusesTextsThatMaxMsgLengthDoesNotCountBeyond1000Bytes) {
  Send("min_msg_interval", -1);
  for (std::string node_message_t::*text :
       {&node_message_t::src_app, &node_message_t::var_name, &node_message_t::color,
        &node_message_t::ack_id, &node_message_t::dest_group}) {
    for (const size_t length : {1000U, 1001U}) {
      node_message_t message = MessageFrom("alpha", "bravo");
      message.*text = std::string(length, 'x');
      Send(message);
      Step();
      ASSERT_EQ(fates_.size(), 1U);
      EXPECT_EQ(fates_[0].cause == "invalid", length > 1000) << fates_[0].cause;
    }
  }
}

TEST_F(BrokerMessagesTest, RefusesInvalidMessagesAndLogsWhy) {
  std::vector<node_message_t> bad(7, MessageFrom("alpha", "bravo"));
  bad[0].dest_node = "";
  bad[1].var_name = "";
  bad[2].is_double = 1;
  bad[3].is_double = 1;
  bad[3].string_val = "";
  bad[3].double_val = std::numeric_limits<double>::quiet_NaN();
  bad[4].ack_requested = 1;
  bad[5].src_node = "al pha";
  bad[6].src_node = "";
  for (const node_message_t& message : bad) Send(message);
  Step();
  ASSERT_EQ(fates_.size(), bad.size());
  for (const fate_t& fate : fates_) {
    EXPECT_EQ(fate.cause, "invalid");
    EXPECT_EQ(fate.destination, "");
  }
  EXPECT_EQ(broker_.Status().run_warnings.size(), 6U) << "the last two share one";
  EXPECT_TRUE(PageHas("    Total Msgs Received: 7\n"));
  EXPECT_TRUE(PageHas("    Total Blocked Msgs: 7\n        Invalid: 7\n"));
}

TEST_F(BrokerMessagesTest, LetsANumberThrough) {
  node_message_t message = MessageFrom("alpha", "all");
  message.string_val = "";
  message.is_double = 1;
  message.double_val = -2.5;
  Send(message);
  Step();
  EXPECT_EQ(Fates(), (Texts{"alpha>bravo delivered"}));
}

TEST_F(BrokerMessagesTest, ShowsWhatCameInAsAnEvent) {
  Send(MessageFrom("alpha", "bravo"));
  Step();
  EXPECT_TRUE(
      PageHas("Msg rec'd: src_node=alpha,dest_node=bravo,dest_group=,var_name=FOOBAR,"
              "string_val=hello"));
  EXPECT_TRUE(PageHas("    Total Msgs Received: 1\n        ALPHA: 1    (0.0)\n"));
  EXPECT_TRUE(PageHas("    Total Sent: 1\n        BRAVO: 1\n"));
}

TEST_F(BrokerMessagesTest, CarriesAnAckBackUnderTheRangeRulesWithoutAnInterval) {
  ack_message_t ack = {};
  ack.src_node = "bravo";
  ack.dest_node = "alpha";
  for (const char* id : {"a-1", "a-2"}) {
    ack.ack_id = id;
    Send(ack);
  }
  Step();
  EXPECT_EQ(acks_["alpha"].size(), 2U);
  EXPECT_EQ(FatesOf("ack"), 2);
  Send(ReportFrom("bravo", 250));
  Step();
  Send(ack);
  Step();
  EXPECT_EQ(Fates(), (Texts{"bravo>alpha out_of_range"}));
  EXPECT_TRUE(acks_["alpha"].empty());
  EXPECT_TRUE(PageHas("Total Acks Received: 3"));
}

TEST_F(BrokerMessagesTest, RefusesAnAckOfNothingOrToOneself) {
  ack_message_t ack = {};
  ack.src_node = "bravo";
  ack.dest_node = "alpha";
  Send(ack);
  ack.ack_id = "a-1";
  ack.dest_node = "BRAVO";
  Send(ack);
  Step();
  EXPECT_EQ(Fates(), (Texts{"bravo> invalid", "bravo> invalid"}));
  EXPECT_FALSE(broker_.Status().run_warnings.empty());
}

TEST_F(BrokerMessagesTest, PulsesOncePerDelivery) {
  Send(ReportFrom("alpha", 10));
  Send(ReportFrom("bravo", 300));
  Send(MessageFrom("alpha", "bravo"));
  Send("comms_range", 1000);
  Step();
  ASSERT_EQ(pulses_.size(), 3U);
  EXPECT_EQ(pulses_[0].label, "ALPHA2BRAVO");
  EXPECT_EQ(pulses_[0].sx_m, 10);
  EXPECT_EQ(pulses_[0].tx_m, 300);
  EXPECT_EQ(pulses_[0].beam_width_m, 29);
  EXPECT_EQ(pulses_[1].label, "BRAVO2ALPHA");
  EXPECT_NE(pulses_[0].fill_color, pulses_[1].fill_color);
  EXPECT_EQ(pulses_[2].label, "ALPHA2BRAVO_MSG");
  EXPECT_EQ(pulses_[2].fill_color, "white");
}

TEST_F(BrokerMessagesTest, PulsesOnlyMessagesWhereReportsAreNotToBeSeen) {
  Send("view_node_rpt_pulses", 0);
  Send(ReportFrom("alpha", 10));
  Send(MessageFrom("alpha", "bravo"));
  Step();
  ASSERT_EQ(pulses_.size(), 1U);
  EXPECT_EQ(pulses_[0].ptype, "msg");
}

TEST_F(BrokerMessagesTest, GivesARepeatItsColorButNotTheSecondDestination) {
  Send("min_msg_interval", -1);
  Send(ReportFrom("charlie", 0));
  node_message_t message = MessageFrom("alpha", "bravo:charlie");
  message.ack_requested = 1;
  message.ack_id = "a-1";
  Step();
  Send(message);
  Step();
  ASSERT_EQ(pulses_.size(), 2U);
  EXPECT_EQ(pulses_[0].fill_color, "white");
  EXPECT_EQ(pulses_[1].fill_color, "white");
  Send(message);
  Step();
  ASSERT_EQ(pulses_.size(), 2U);
  EXPECT_EQ(pulses_[0].fill_color, "light_green");
  message.ack_id = "a-2";
  message.color = "pink";
  Send(message);
  Step();
  EXPECT_EQ(pulses_.at(0).fill_color, "pink");
}

}  // namespace shoal::broker_messages_test
