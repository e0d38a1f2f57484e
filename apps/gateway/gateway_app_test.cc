#include "apps/gateway/gateway_app.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/bus/bus/memory_bus.h"

namespace shoal::gateway_app_test {

class Gateway : public testing::Test {
 protected:
  explicit Gateway(GatewayOptions options = {.exists = true,
                                             .from = {"acoustic"},
                                             .to = {"vhf", "direct"},
                                             .queue = 2,
                                             .rate_hz = 10,
                                             .max_hops = 2}) {
    mission_.vehicles.resize(1);
    mission_.vehicles[0].name = "buoy";
    mission_.vehicles[0].media.gateway = std::move(options);
    app_ = std::make_unique<GatewayApp>(mission_, mission_.vehicles[0], app_bus_);
    Subscribe(listener_, channels::RelayTx(),
              [this](const relay_t& relay) { sent_.push_back(relay); });
  }

  relay_t Report(int64_t number, const std::string& via = "") {
    node_report_t report{};
    report.name = "auv";
    report.utime = 7'000'000;
    relay_t relay{};
    relay.gateway = "buoy";
    relay.kind = "report";
    relay.origin = "auv";
    relay.number = number;
    relay.via = via;
    EncodeInto(report, &relay.data);
    relay.num_bytes = static_cast<int32_t>(relay.data.size());
    return relay;
  }
  relay_t Message(int64_t number, const std::string& dest_node) {
    relay_t relay = Report(number);
    node_message_t message{};
    message.src_node = "auv";
    message.src_app = "ctd";
    message.dest_node = dest_node;
    relay.kind = "message";
    EncodeInto(message, &relay.data);
    relay.num_bytes = static_cast<int32_t>(relay.data.size());
    return relay;
  }

  /// Gives the gateway what was published, and returns what it publishes.
  std::vector<relay_t> Step(const std::vector<relay_t>& relays) {
    for (const relay_t& relay : relays) Publish(listener_, channels::RelayRx("buoy"), relay);
    hub_.NextStep();
    hub_.Handle(app_bus_);
    app_->Tick(utime_);
    utime_ += 100'000;
    hub_.NextStep();
    sent_.clear();
    hub_.Handle(listener_);
    return sent_;
  }

  Mission mission_;
  MemoryBus hub_;
  Bus& listener_ = hub_.Join("listener");
  Bus& app_bus_ = hub_.Join("gateway_buoy");
  std::unique_ptr<GatewayApp> app_;
  std::vector<relay_t> sent_;
  int64_t utime_ = 0;
};

TEST_F(Gateway, MarksItsNameInAReportAndLeavesItsTime) {
  const auto sent = Step({Report(5)});
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].refused, "");
  EXPECT_EQ(sent[0].via, "buoy");
  EXPECT_EQ(sent[0].origin, "auv");
  EXPECT_EQ(sent[0].number, 5);
  EXPECT_EQ(sent[0].media, (std::vector<std::string>{"vhf", "direct"}));
  node_report_t report;
  ASSERT_TRUE(Decode(sent[0].data, &report));
  EXPECT_EQ(report.utime, 7'000'000);
  ASSERT_EQ(report.extra.size(), 1U);
  EXPECT_EQ(report.extra[0].key, "via");
  EXPECT_EQ(report.extra[0].value, "buoy");
}

TEST_F(Gateway, AddsItselfToTheWayOfWhatAnotherHasForwarded) {
  relay_t first = Step({Report(5)}).at(0);
  first.via = "mast";
  const auto sent = Step({[&] {
    relay_t again = first;
    again.number = 6;
    return again;
  }()});
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].via, "mast:buoy");
  node_report_t report;
  ASSERT_TRUE(Decode(sent[0].data, &report));
  ASSERT_EQ(report.extra.size(), 1U) << "one field, written again";
  EXPECT_EQ(report.extra[0].value, "mast:buoy");
}

TEST_F(Gateway, MarksItsNameBehindTheAppOfAMessage) {
  const auto sent = Step({Message(1, "ship")});
  ASSERT_EQ(sent.size(), 1U);
  node_message_t message;
  ASSERT_TRUE(Decode(sent[0].data, &message));
  EXPECT_EQ(message.src_app, "ctd via=buoy");
}

TEST_F(Gateway, KeepsWhatIsForItselfAlone) {
  EXPECT_TRUE(Step({Message(1, "Buoy")}).empty());
  EXPECT_EQ(Step({Message(2, "buoy:ship")}).size(), 1U);
}

TEST_F(Gateway, StatesWhyItForwardsNotEach) {
  const auto sent = Step({Report(1), Report(1), Report(2, "a:b"), Report(3), Report(4)});
  std::vector<std::string> refused;
  for (const relay_t& relay : sent) refused.push_back(relay.refused);
  EXPECT_EQ(refused, (std::vector<std::string>{"already_received", "hop_limit", "queue_full", ""}));
  EXPECT_EQ(Step({}).size(), 1U) << "ten in a second: one in a step";
  EXPECT_TRUE(Step({}).empty());
}

}  // namespace shoal::gateway_app_test
