#include "lib/tools/campaign/plan.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "lib/tools/campaign/folder_testing.h"
#include "lib/tools/campaign/load_campaign.h"
#include "lib/tools/campaign/samples.h"

namespace shoal {
namespace {

class PlanTest : public testing::Test {
 protected:
  PlanTest() { std::ofstream(tmp_ / "m.toml") << kShortMission; }

  Campaign Load(const std::string& text) const {
    const LoadedCampaign loaded = LoadCampaignText(text, "c.toml", tmp_ / "");
    EXPECT_EQ(loaded.errors, std::vector<std::string>{});
    return loaded.campaign;
  }

  TemporaryFolder tmp_;
};

constexpr char kTwoByTwo[] =
    "[campaign]\nmission = \"m.toml\"\n[sweep]\n\"comms.comms_range\" = [100, 200]\n"
    "\"mission.duration_s\" = [1, 2]\n[policy.A]\n[policy.B]\n\"vehicle.alpha.start.x_m\" = 3\n"
    "[sample]\n\"vehicle.alpha.start.y_m\" = {uniform = [0, 1]}\n";

TEST_F(PlanTest, HasEachPointUnderEachPolicyTheLastAxisFastest) {
  const Campaign campaign = Load(kTwoByTwo);
  const MadePlan made = MakePlan(campaign, "b");
  ASSERT_EQ(made.errors, std::vector<std::string>{});
  ASSERT_EQ(made.plan.cases.size(), 8U);
  EXPECT_EQ(CaseText(campaign, made.plan.cases[0]),
            "comms.comms_range=100, mission.duration_s=1, policy=A");
  EXPECT_EQ(CaseText(campaign, made.plan.cases[3]),
            "comms.comms_range=100, mission.duration_s=2, policy=B");
  std::set<std::string> ids;
  for (const CampaignCase& each : made.plan.cases) ids.insert(each.id);
  EXPECT_EQ(ids.size(), 8U);
}

TEST_F(PlanTest, GivesAllCasesTheSameSeedAndSamplesInARepetition) {
  const Campaign campaign = Load(kTwoByTwo);
  const MadePlan made = MakePlan(campaign, "b");
  const auto first = OverridesOf(campaign, made.plan, 0, 17);
  const auto last = OverridesOf(campaign, made.plan, 7, 17);
  ASSERT_EQ(first.size(), 4U);
  ASSERT_EQ(last.size(), 5U);
  EXPECT_EQ(last[2], "vehicle.alpha.start.x_m=3");
  EXPECT_EQ(first[2], last[3]);
  EXPECT_EQ(first[3], last[4]);
  EXPECT_EQ(first[3], "mission.seed=" + std::to_string(SeedOf(campaign, 17)));
  EXPECT_NE(OverridesOf(campaign, made.plan, 0, 18)[3], first[3]);
}

TEST_F(PlanTest, ListsWhatTheMissionsStartAndOpenEachOnce) {
  EXPECT_EQ(MakePlan(Load(CampaignText(5)), "b").programs, std::vector<std::string>{});
  std::ofstream(tmp_ / "m.toml")
      << kShortMission
      << "[[participant]]\nname = \"mine\"\ncommand = [\"/bin/p\\u009b2J\", "
         "\"--fast\"]\n[netsim]\n";
  const MadePlan made = MakePlan(Load(CampaignText(5)), "b");
  EXPECT_EQ(made.programs,
            (std::vector<std::string>{"mine: /bin/p??2J --fast", "netsim: TCP ports"}));
}

TEST_F(PlanTest, NamesACaseByItsContentAndTheBuild) {
  const Campaign campaign = Load(CampaignText(5));
  const auto id = [&](const Campaign& of, const std::string& build) {
    return MakePlan(of, build).plan.cases.at(0).id;
  };
  EXPECT_EQ(id(campaign, "b"), id(Load(CampaignText(500)), "b"));
  EXPECT_NE(id(campaign, "b"), id(campaign, "c"));
  const std::string before = id(campaign, "b");
  std::ofstream(tmp_ / "m.toml") << kShortMission << "within_m = 30\n";
  EXPECT_NE(id(campaign, "b"), before);
}

TEST_F(PlanTest, NamesTheCasesWhoseMissionIsWrongAndKeepsTheOthers) {
  const MadePlan made = MakePlan(
      Load("[campaign]\nmission = \"m.toml\"\n[sweep]\n\"comms.comms_range\" = [100, \"far\"]\n"),
      "b");
  EXPECT_EQ(made.errors, std::vector<std::string>{});
  ASSERT_EQ(made.bad_cases.size(), 1U);
  EXPECT_TRUE(made.bad_cases[0].starts_with("case comms.comms_range=\"far\":\n"));
  EXPECT_EQ(made.plan.metrics.size(), 1U);
}

TEST_F(PlanTest, IsNoneWhereEveryCaseIsWrongOrTheMissionIsNotThere) {
  EXPECT_FALSE(
      MakePlan(Load("[campaign]\nmission = \"m.toml\"\n[policy.A]\n\"comms.rnage\" = 1\n"), "b")
          .errors.empty());
  const MadePlan none = MakePlan(Load("[campaign]\nmission = \"none.toml\"\n"), "b");
  ASSERT_EQ(none.errors.size(), 1U);
  EXPECT_NE(none.errors[0].find("none.toml"), std::string::npos);
}

TEST_F(PlanTest, RefusesAStopRuleOnAMetricThatIsNotThere) {
  const MadePlan made = MakePlan(
      Load(CampaignText(100, "[stop]\nmetric = \"cpa\"\nhalf_width = 1\nlooks = [50]\n")), "b");
  ASSERT_EQ(made.errors.size(), 1U);
  EXPECT_NE(made.errors[0].find("neither \"pass\" nor a metric"), std::string::npos);
}

}  // namespace
}  // namespace shoal
