// Whole missions of encounters: no vessel touches another, and each keeps to the rules.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "apps/shoal_encounters/encounters_command.h"
#include "lib/base/check/result.h"

namespace shoal::encounters_test {

struct Trials {
  int code = 0;
  std::string rows;
  std::string summary;
};

Trials RunAll(const std::string& set, bool others_hold) {
  EncounterTrialsOptions options;
  options.choice.set = set;
  options.choice.mission.others_hold = others_hold;
  options.num_seeds = 1;
  std::ostringstream out;
  std::ostringstream err;
  const int code = RunEncounterTrials(options, out, err);
  return {code, out.str(), err.str()};
}

TEST(EncounterTrials, PassInEveryCaseOfImazuWhereAllVesselsKeepTheRules) {
  const Trials trials = RunAll("imazu", false);
  EXPECT_EQ(trials.code, kExitOk);
  EXPECT_EQ(trials.summary, "22 trials, 22 without collision, 22 passed\n") << trials.rows;
}

TEST(EncounterTrials, PassInEveryEncounterWithASingleTarget) {
  const Trials trials = RunAll("single", false);
  EXPECT_EQ(trials.code, kExitOk);
  EXPECT_EQ(trials.summary, "21 trials, 21 without collision, 21 passed\n") << trials.rows;
}

TEST(EncounterTrials, HaveNoCollisionWhereTheOthersHoldCourse) {
  EXPECT_EQ(RunAll("imazu", true).code, kExitOk);
  EXPECT_EQ(RunAll("single", true).code, kExitOk);
}

}  // namespace shoal::encounters_test
