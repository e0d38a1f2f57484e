#include "apps/shore_broker/broker_page.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal {
namespace {

TEST(BrokerPage, SpellsOutRulesThatAreOff) {
  RoutingRules rules;
  rules.comms_range_m = -1;
  rules.stale_time_s = -1;
  rules.stale_forget_s = -1;
  const Router router(rules, 1, {});
  const std::string page = FormatBrokerPage(router, {});
  EXPECT_NE(page.find("Comms Range: nolimit\n"), std::string::npos);
  EXPECT_NE(page.find("Stale Drop: never\n"), std::string::npos);
  EXPECT_NE(page.find("Stale Forget: never\n"), std::string::npos);
}

TEST(BrokerPage, ShowsSomeOfAFloodOfNamesAndCountsAll) {
  Router router({}, 1, {});
  for (int i = 0; i < Router::kMaxStrangers + 5; ++i) {
    router.Admit({.name = "nemo" + std::to_string(i), .group = ""}, 0);
  }
  const std::string page = FormatBrokerPage(router, {.now_utime = 1'000'000});
  EXPECT_NE(page.find("Total Received: 1005 "), std::string::npos) << page;
  EXPECT_NE(page.find("(and 800 more)"), std::string::npos);
  EXPECT_NE(page.find("Known Vehicles: 1000\n"), std::string::npos);
  EXPECT_NE(page.find("Too Many Vehicles: 5\n"), std::string::npos);
}

TEST(BrokerPage, MarksAForgottenVehicle) {
  RoutingRules rules;
  rules.stale_forget_s = 10;
  Router router(rules, 1, {});
  router.Admit({.name = "nemo", .group = ""}, 0);
  router.ForgetSilent(10'000'000);
  EXPECT_NE(FormatBrokerPage(router, {.now_utime = 10'000'000}).find("(forgotten)"),
            std::string::npos);
}

}  // namespace
}  // namespace shoal
