#include "lib/run/orders/order.h"

#include <gtest/gtest.h>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal::order_test {

using Words = std::vector<std::string>;
const OrderScope kScope = {.mission = "berta", .vehicles = {"alpha", "Bravo"}};

std::string ErrorOf(const std::string& target, const Words& words) {
  const Result<Order> order = ParseOrder(kScope, target, words);
  return order.ok() ? "" : order.error();
}

TEST(ParseOrder, FindsVehiclesWhateverTheCase) {
  const Result<Order> one = ParseOrder(kScope, "BRAVO", Words{"goto", "1", "2"});
  ASSERT_TRUE(one.ok());
  EXPECT_EQ(std::get<OrderToHelms>(*one).vehicles, Words{"Bravo"});
  const Result<Order> all = ParseOrder(kScope, "all", Words{"sim", "pause"});
  ASSERT_TRUE(all.ok());
  EXPECT_EQ(std::get<OrderToSims>(*all).vehicles, (Words{"alpha", "Bravo"}));
}

TEST(ParseOrder, KnowsRulesAndTheClock) {
  const Result<Order> rule = ParseOrder(kScope, "stealth", Words{"ALPHA", "0.5"});
  ASSERT_TRUE(rule.ok());
  EXPECT_EQ(std::get<OrderToBroker>(*rule).control.value, 0.5);
  EXPECT_FALSE(std::get<OrderToBroker>(*rule).is_unregistered);
  EXPECT_TRUE(std::get<OrderToBroker>(*ParseOrder(kScope, "stealth", Words{"zulu", "0.5"}))
                  .is_unregistered);
  EXPECT_EQ(std::get<OrderToClock>(*ParseOrder(kScope, "clock", Words{"warp", "3"})).command.warp,
            3);
}

TEST(ParseOrder, TakesOrdersToTheClockAloneForAPlayback) {
  OrderScope scope = kScope;
  scope.is_playback = true;
  EXPECT_TRUE(ParseOrder(scope, "clock", Words{"seek", "12"}).ok());
  for (const char* target : {"alpha", "all", "stealth"}) {
    const Result<Order> order = ParseOrder(scope, target, Words{"return"});
    ASSERT_FALSE(order.ok()) << target;
    EXPECT_NE(order.error().find("takes no orders"), std::string::npos) << order.error();
  }
}

TEST(ParseOrder, PrefersAVehicleOfThatName) {
  const OrderScope scope = {.mission = "m", .vehicles = {"clock", "comms_range"}};
  EXPECT_TRUE(std::holds_alternative<OrderToHelms>(*ParseOrder(scope, "clock", Words{"return"})));
  EXPECT_TRUE(
      std::holds_alternative<OrderToHelms>(*ParseOrder(scope, "comms_range", Words{"return"})));
}

TEST(ParseOrder, SendsToTheMembersOfAGroup) {
  const OrderScope scope = {.mission = "m",
                            .vehicles = {"alpha", "bravo", "charlie"},
                            .groups = {{"Sweepers", {"bravo", "charlie"}}, {"scouts", {"alpha"}}}};
  const Result<Order> helms = ParseOrder(scope, "group:sweepers", Words{"return"});
  ASSERT_TRUE(helms.ok());
  EXPECT_EQ(std::get<OrderToHelms>(*helms).vehicles, (Words{"bravo", "charlie"}));
  const Result<Order> sims = ParseOrder(scope, "group:scouts", Words{"sim", "pause"});
  ASSERT_TRUE(sims.ok());
  EXPECT_EQ(std::get<OrderToSims>(*sims).vehicles, Words{"alpha"});
  EXPECT_EQ(ParseOrder(scope, "group:sweeper", Words{"return"}).error(),
            "no group 'sweeper' in m (did you mean 'Sweepers'?); it has: Sweepers, scouts");
  EXPECT_EQ(ErrorOf("group:x", {"return"}), "no group 'x' in berta: none of its vehicles has one");
}

TEST(ParseOrder, KnowsTheOrdersOfTheMission) {
  const OrderScope scope = {.mission = "m",
                            .vehicles = {"alpha", "bravo"},
                            .orders = {{"patrol", "all", {"set", "PATROL=true"}},
                                       {"home", "alpha", {"return"}},
                                       {"patrol", "bravo", {"speed", "1.5"}},
                                       {"alpha", "bravo", {"park"}}}};
  const Result<Order> order = ParseOrder(scope, "patrol", {});
  ASSERT_TRUE(order.ok());
  const auto& [orders] = std::get<OrderByName>(*order);
  ASSERT_EQ(orders.size(), 2U);
  EXPECT_EQ(orders[0].vehicles, (Words{"alpha", "bravo"}));
  EXPECT_EQ(orders[0].command.argument, "PATROL=true");
  EXPECT_EQ(orders[1].vehicles, Words{"bravo"});
  EXPECT_EQ(orders[1].command.values, std::vector<double>{1.5});
  EXPECT_EQ(TracesOf(*order).size(), 3U);
  EXPECT_TRUE(std::holds_alternative<OrderToHelms>(*ParseOrder(scope, "alpha", Words{"park"})));
  EXPECT_EQ(ParseOrder(scope, "patrol", Words{"all"}).error(),
            "patrol is an [[order]] of m: it takes no more words");
  EXPECT_NE(ParseOrder(scope, "patrl", {}).error().find("did you mean 'patrol'"),
            std::string::npos);
}

TEST(ParseOrder, ExplainsWhatItDoesNotUnderstand) {
  EXPECT_EQ(
      ErrorOf("alhpa", {"return"}).find("no vehicle 'alhpa' in berta (did you mean 'alpha'?)"), 0U);
  EXPECT_NE(ErrorOf("clokc", {"pause"}).find("did you mean 'clock'?"), std::string::npos);
  EXPECT_NE(ErrorOf("alpha", {}).find("a command is missing: "), std::string::npos);
  EXPECT_NE(ErrorOf("alpha", {"fly"}).find("unknown command 'fly'"), std::string::npos);
  EXPECT_NE(ErrorOf("alpha", {"message"}).find("usage: message"), std::string::npos);
  EXPECT_NE(ErrorOf("", {""}), "");
  EXPECT_LT(ErrorOf(std::string(100'000, 'x'), {"y"}).size(), 2000U);
}

TEST(TracesOf, NameTheParticipantsThatExecuteTheOrder) {
  const auto traces = TracesOf(*ParseOrder(kScope, "all", Words{"sim", "pause"}));
  ASSERT_EQ(traces.size(), 2U);
  EXPECT_EQ(traces[1].app, "vehicle_sim_Bravo");
  EXPECT_EQ(TracesOf(*ParseOrder(kScope, "groups", Words{"true"})).at(0).app, "shore_broker");
  EXPECT_TRUE(TracesOf(*ParseOrder(kScope, "clock", Words{"pause"})).empty());
}

TEST(Publish, SendsAnOrderToEachThatItIsFor) {
  MemoryBus hub;
  Bus& sender = hub.Join("sender");
  Bus& listener = hub.Join("listener");
  std::string published;
  listener.SubscribeAll(
      [&](const Message& message) { published += std::string(message.channel) + " "; });
  for (const auto& [target, words] : std::vector<std::pair<std::string, Words>>{
           {"all", {"return"}},
           {"alpha", {"sim", "pause"}},
           {"alpha", {"message", "Bravo", "X", "1", "--ack"}},
           {"comms_range", {"100"}},
           {"clock", {"pause"}}}) {
    Publish(sender, *ParseOrder(kScope, target, words));
  }
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(published,
            "CLOCK_COMMAND HELM_COMMAND_ALPHA HELM_COMMAND_BRAVO MEDIATED_MESSAGE_ALPHA "
            "SIM_COMMAND_ALPHA UNC_COMMS_RANGE ");
}

}  // namespace shoal::order_test
