#include "apps/shore_broker/broker_page.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace shoal::broker_page_test {

/// A network through which nothing went.
AcousticTraffic NoAcoustics() { return AcousticTraffic(BrokerSetup(), {}, 1, {}); }

/// Has one transmission of each kind for each cause that can block it.
void BlockForEveryCause(Router* router) {
  std::vector<Decision> decisions;
  std::vector<std::string> names;
  const auto report = [&](std::string_view name, double x_m, std::string_view group,
                          int64_t utime) {
    const Admission admission =
        router->Admit({.name = name, .group = group, .position_m = {x_m, 0, 0}}, utime);
    if (!admission.refused) router->Route(admission, utime, &decisions);
  };
  const auto message = [&](std::string_view source, std::string_view dest_node, int64_t utime,
                           int64_t length_bytes = 5, std::string_view dest_group = {}) {
    router->RouteMessage({.source = source,
                          .dest_node = dest_node,
                          .dest_group = dest_group,
                          .length_bytes = length_bytes},
                         utime, &decisions, &names);
  };
  constexpr int64_t kLater_us = 6'000'000;
  report("silent", 10, "", 0);
  for (const char* name : {"a", "b", "c", "d", "e"}) report(name, 0, "", kLater_us);
  report("e", 0, "", kLater_us);  // Too soon.
  report("far", 500, "", kLater_us);
  report("red", 0, "red", kLater_us);
  report("ghost", 0, "ghosts", kLater_us);
  report("no name", 0, "", kLater_us);
  message("a", "", kLater_us);  // Invalid.
  message("a", "b", kLater_us);
  message("a", "b", kLater_us);  // Too soon.
  message("b", "a", kLater_us, 1001);
  message("unknown", "a", kLater_us);
  message("c", "", kLater_us, 5, "greens");
  message("d", "missing:silent:far:red", kLater_us);
  RoutingRules rules = router->rules();
  rules.drop_percentage = 100;
  router->SetRules(rules);
  report("a", 0, "", 2 * kLater_us);
  report("b", 0, "", 2 * kLater_us);
  report("e", 0, "", 2 * kLater_us);
  message("e", "a", 2 * kLater_us);
  for (int i = 0; i <= Router::kMaxUnregistered; ++i) {
    router->Admit({.name = "nemo" + std::to_string(i)}, 2 * kLater_us);
  }
  message("one_too_many", "a", 2 * kLater_us);
}

TEST(BrokerPage, SpellsOutRulesThatAreOff) {
  RoutingRules rules;
  rules.comms_range_m = -1;
  rules.stale_time_s = -1;
  rules.stale_forget_s = -1;
  const Router router(rules, 1, {});
  const std::string page = FormatBrokerPage(router, NoAcoustics(), {});
  EXPECT_NE(page.find("Comms Range: nolimit\n"), std::string::npos);
  EXPECT_NE(page.find("Stale Drop: never\n"), std::string::npos);
  EXPECT_NE(page.find("Stale Forget: never\n"), std::string::npos);
}

TEST(BrokerPage, HasARowForEveryCauseThatBlocks) {
  RoutingRules rules;
  rules.critical_range_m = 0;
  rules.groups = true;
  rules.msg_groups = true;
  rules.ignore_group = "ghosts";
  rules.min_rpt_interval_s = 1;
  Router router(rules, 1, {});
  BlockForEveryCause(&router);

  std::istringstream page(FormatBrokerPage(router, NoAcoustics(), {.now_utime = 12'000'000}));
  std::vector<int64_t> left;  // Of each total, what its rows have not counted.
  bool is_row = false;
  for (std::string line; std::getline(page, line);) {
    const bool is_total = line.starts_with("    Total Blocked ");
    is_row = is_total || (is_row && line.starts_with("        "));
    if (!is_row) continue;
    const int64_t number = std::atoll(line.substr(line.rfind(' ') + 1).c_str());
    EXPECT_GT(number, 0) << line;
    if (is_total) {
      left.push_back(number);
    } else {
      left.back() -= number;
    }
  }
  EXPECT_EQ(left, (std::vector<int64_t>{0, 0}));
}

TEST(BrokerPage, ShowsSomeOfALargeFleetAndCountsAll) {
  std::vector<std::string> fleet;
  for (int i = 0; i < 1000; ++i) fleet.push_back("boat_" + std::to_string(i));
  Router router({}, 1, fleet);
  for (const std::string& name : fleet) router.Admit({.name = name, .group = ""}, 0);
  for (int i = 0; i < Router::kMaxUnregistered + 5; ++i) {
    router.Admit({.name = "nemo" + std::to_string(i), .group = ""}, 0);
  }
  const std::string page = FormatBrokerPage(router, NoAcoustics(), {.now_utime = 1'000'000});
  EXPECT_NE(page.find("Total Received: 1205 "), std::string::npos) << page;
  EXPECT_NE(page.find("(and 1000 more)"), std::string::npos);
  EXPECT_NE(page.find("Known Vehicles: 1200\n"), std::string::npos);
  EXPECT_NE(page.find("Too Many Vehicles: 5\n"), std::string::npos);
}

TEST(BrokerPage, CountsTheReportsOfAVehicleOfTheIgnoredGroupAsReceived) {
  RoutingRules rules;
  rules.ignore_group = "ghosts";
  Router router(rules, 1, std::vector<std::string>{"alpha", "casper"});
  router.Admit({.name = "alpha", .group = ""}, 0);
  router.Admit({.name = "casper", .group = "ghosts"}, 0);
  router.Admit({.name = "casper", .group = "ghosts"}, 500'000);
  const std::string page = FormatBrokerPage(router, NoAcoustics(), {.now_utime = 1'000'000});
  EXPECT_NE(page.find("Total Received: 3 "), std::string::npos) << page;
  EXPECT_NE(page.find("        ALPHA: 1                   (1.0)    [1.00]\n"), std::string::npos)
      << page;
  EXPECT_NE(page.find("        CASPER: 2              (refused)    [2.00]\n"), std::string::npos)
      << page;
}

TEST(BrokerPage, MarksAForgottenVehicle) {
  RoutingRules rules;
  rules.stale_forget_s = 10;
  Router router(rules, 1, {});
  router.Admit({.name = "nemo", .group = ""}, 0);
  router.ForgetSilent(10'000'000);
  EXPECT_NE(FormatBrokerPage(router, NoAcoustics(), {.now_utime = 10'000'000}).find("(forgotten)"),
            std::string::npos);
}

}  // namespace shoal::broker_page_test
