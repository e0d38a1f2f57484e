#include "apps/viewer/rules_of_page.h"

#include <gtest/gtest.h>

#include "apps/shore_broker/shore_broker_app.h"
#include "lib/bus/memory_bus.h"
#include "lib/mission/load.h"

namespace shoal {
namespace {

constexpr const char* kMission = R"(
[mission]
duration_s = 10
[comms]
comms_range = 250.5
critical_range = 30
stale_time = 5
drop_percentage = 12.5
[[vehicle]]
name = "alpha"
stealth = 0.5
earange = 2
[[vehicle]]
name = "bravo"
)";

/// What shore_broker itself shows.
std::string PageOf(const std::string& mission_text) {
  const LoadedMission loaded = LoadMissionText(mission_text, "test.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  MemoryBus hub;
  ShoreBrokerApp broker(SetupOf(loaded.mission), hub.Join("shore_broker"));
  hub.NextStep();
  hub.HandleAll();
  broker.Tick(0);
  return broker.Status().text;
}

TEST(RulesOfPage, AreThoseOfTheBroker) {
  const auto rules = RulesOfPage(PageOf(kMission));
  ASSERT_TRUE(rules);
  EXPECT_EQ(rules->comms_range_m, 250.5);
  EXPECT_EQ(rules->critical_range_m, 30);
  EXPECT_EQ(rules->stale_time_s, 5);
  EXPECT_EQ(rules->drop_percentage, 12.5);
  ASSERT_EQ(rules->num_factors, 1);
  EXPECT_EQ(rules->factors[0].vehicle, "ALPHA");
  EXPECT_EQ(rules->factors[0].stealth, 0.5);
  EXPECT_EQ(rules->factors[0].earange, 2);
}

TEST(RulesOfPage, KnowWhatHasNoLimit) {
  const auto rules = RulesOfPage(
      PageOf("[mission]\nduration_s = 10\n[comms]\ncomms_range = \"nolimit\"\nstale_time = "
             "\"nolimit\"\n[[vehicle]]\nname = \"alpha\"\n"));
  ASSERT_TRUE(rules);
  EXPECT_LT(rules->comms_range_m, 0);
  EXPECT_LT(rules->stale_time_s, 0);
}

TEST(RulesOfPage, AreNotMadeOfAnotherPage) {
  const std::string page = PageOf(kMission);
  EXPECT_FALSE(RulesOfPage(""));
  EXPECT_FALSE(RulesOfPage("Configuration:\n"));
  EXPECT_FALSE(
      RulesOfPage("Configuration:\n    Comms Range: nan\n    Critical Range: 1\n"
                  "    Stale Drop: 1\n    Drop Percentage: 1\n"));
  const size_t begin = page.find("Configuration:");
  ASSERT_NE(begin, std::string::npos);
  const size_t end = page.find("Drop Percentage");
  // However it is cut, there is no crash and no half of a rule.
  for (size_t size = begin; size < end; ++size) EXPECT_FALSE(RulesOfPage(page.substr(0, size)));
}

TEST(RulesOfPage, LeaveOutFactorsThatMakeNoSense) {
  const auto rules = RulesOfPage(
      "Configuration:\n    Comms Range: 1\n    Critical Range: 1\n    Stale Drop: 1\n"
      "    Drop Percentage: 1\n    A: stealth x, earange 1\n    B: earange 1, stealth 1\n"
      "    : stealth 1, earange 1\n    a b: stealth 1, earange 1\n    C: stealth 2, earange 3");
  ASSERT_TRUE(rules);
  ASSERT_EQ(rules->factors.size(), 1U);
  EXPECT_EQ(rules->factors[0].vehicle, "C");
}

}  // namespace
}  // namespace shoal
