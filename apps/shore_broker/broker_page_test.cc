#include "apps/shore_broker/broker_page.h"

#include <gtest/gtest.h>

#include <string>

namespace shoal {
namespace {

TEST(BrokerPage, SpellsOutRulesThatAreOff) {
  const Router router({.comms_range_m = -1, .stale_time_s = -1, .stale_forget_s = -1}, {});
  const std::string page = FormatBrokerPage(router, {});
  EXPECT_NE(page.find("Comms Range: nolimit\n"), std::string::npos);
  EXPECT_NE(page.find("Stale Drop: never\n"), std::string::npos);
  EXPECT_NE(page.find("Stale Forget: never\n"), std::string::npos);
}

TEST(BrokerPage, ShowsSomeOfAFloodOfNamesAndCountsAll) {
  Router router({}, {});
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
  Router router({.stale_forget_s = 10}, {});
  router.Admit({.name = "nemo", .group = ""}, 0);
  router.ForgetSilent(10'000'000);
  EXPECT_NE(FormatBrokerPage(router, {.now_utime = 10'000'000}).find("(forgotten)"),
            std::string::npos);
}

}  // namespace
}  // namespace shoal
