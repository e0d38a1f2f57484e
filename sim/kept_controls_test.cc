#include "sim/kept_controls.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace shoal::kept_controls_test {

bool Keep(KeptControls& controls, const std::string& rule, const std::string& vehicle,
          double value) {
  unc_control_t control{};
  control.vehicle = vehicle;
  control.value = value;
  return controls.Keep(*FindControl(rule), control);
}

std::vector<std::string> Lines(const KeptControls& controls) {
  std::vector<std::string> lines;
  for (const kept_control_t& each : controls.All().controls) {
    lines.push_back(
        fmt::format("{} {} {}", each.channel, each.control.vehicle, each.control.value));
  }
  return lines;
}

TEST(KeptControls, AreTheLastOfEachRuleAndVehicleInOrder) {
  KeptControls controls;
  EXPECT_EQ(controls.All().num_controls, 0);
  EXPECT_TRUE(Keep(controls, "stealth", "bravo", 0.25));
  EXPECT_TRUE(Keep(controls, "stealth", "alpha", 0.5));
  EXPECT_TRUE(Keep(controls, "stealth", "BRAVO", 0.75));
  EXPECT_TRUE(Keep(controls, "comms_range", "", 300));
  EXPECT_TRUE(Keep(controls, "comms_range", "", -1));
  EXPECT_EQ(Lines(controls),
            (std::vector<std::string>{"UNC_COMMS_RANGE  -1", "UNC_STEALTH alpha 0.5",
                                      "UNC_STEALTH BRAVO 0.75"}));
}

TEST(KeptControls, HoldTexts) {
  KeptControls controls;
  unc_control_t control{};
  control.text = "Ghosts";
  EXPECT_TRUE(controls.Keep(*FindControl("ignore_group"), control));
  ASSERT_EQ(controls.All().num_controls, 1);
  EXPECT_EQ(controls.All().controls[0].control.text, "Ghosts");
}

TEST(KeptControls, AreNoneThatTheBrokerRefusesOrExecutesOnce) {
  KeptControls controls;
  EXPECT_TRUE(Keep(controls, "drop_percentage", "", 50));
  EXPECT_TRUE(Keep(controls, "drop_percentage", "", 101));
  EXPECT_TRUE(Keep(controls, "drop_percentage", "", std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(Keep(controls, "drop_percentage", "alpha", 10));
  EXPECT_TRUE(Keep(controls, "stealth", "", 0.5));
  EXPECT_TRUE(Keep(controls, "stealth", "no such name!", 0.5));
  EXPECT_TRUE(Keep(controls, "full_report", "alpha", 0));
  EXPECT_EQ(Lines(controls), std::vector<std::string>{"UNC_DROP_PCT  50"});
}

TEST(KeptControls, LeaveThoseOutThatThereIsNoRoomFor) {
  KeptControls controls;
  for (size_t i = 0; i < KeptControls::kMax; ++i) {
    EXPECT_TRUE(Keep(controls, "stealth", fmt::format("v{}", i), 0.5));
  }
  EXPECT_FALSE(Keep(controls, "stealth", "one_more", 0.5));
  EXPECT_TRUE(Keep(controls, "stealth", "v7", 0.25)) << "one that is kept can change";
  EXPECT_EQ(controls.All().num_controls, static_cast<int32_t>(KeptControls::kMax));
}

}  // namespace shoal::kept_controls_test
