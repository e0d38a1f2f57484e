#include "lib/tools/analysis/decision_words.h"

#include <gtest/gtest.h>

namespace shoal::decision_words_test {

helm_aim_t Aim(const char* name, double weight, double best_course_deg, double loss) {
  helm_aim_t aim{};
  aim.name = name;
  aim.kind = "waypoint";
  aim.state = "active";
  aim.weight = weight;
  aim.best_course_deg = best_course_deg;
  aim.best_speed_mps = 2;
  aim.best_depth_m = -1;
  aim.value = 100 - loss;
  aim.loss = weight * loss;
  aim.range_m = aim.cpa_m = aim.age_s = -1;
  return aim;
}

helm_decision_t GivesWay() {
  helm_decision_t decision{};
  decision.utime = 53'000'000;
  decision.vehicle = "alpha";
  decision.course_deg = 74;
  decision.speed_mps = 2;
  decision.depth_m = -1;
  decision.all_stop = "clear";
  decision.aims = {Aim("survey", 100, 40, 18.9), Aim("avd_ben", 143, 74, 0)};
  helm_aim_t& avoid = decision.aims[1];
  avoid.kind = "colregs";
  avoid.contact = "ben";
  avoid.role = "give-way:stern";
  avoid.rule = "15/16";
  avoid.range_m = 48.2;
  avoid.cpa_m = 3.1;
  avoid.age_s = 0.4;
  decision.num_aims = 2;
  return decision;
}

TEST(DecisionWords, NamesTheChoiceTheAimsAndTheRuleThatTurnedTheVessel) {
  EXPECT_EQ(DecisionWords(GivesWay()),
            "alpha at 53.000 s: course 74 deg, speed 2.0 m/s\n"
            "  survey (waypoint, active): weight 100, wants course 40 deg, speed 2.0 m/s, has 81.1 "
            "of 100 here\n"
            "  avd_ben (colregs, active): weight 143, wants course 74 deg, speed 2.0 m/s, has "
            "100.0 of 100 here; give-way:stern toward ben (rule 15/16), range 48.2 m, CPA 3.1 m if "
            "both hold on, known 0.4 s ago\n"
            "survey wanted course 40 deg, speed 2.0 m/s and gave up 18.9 of 100 for avd_ben, which "
            "is give-way:stern toward ben by rule 15/16.\n");
}

TEST(DecisionWords, StatesThatAllAgreeWhereNothingIsGivenUp) {
  helm_decision_t decision = GivesWay();
  decision.aims = {Aim("survey", 100, 74, 0)};
  decision.num_aims = 1;
  EXPECT_TRUE(DecisionWords(decision).ends_with("Every behavior got what it wanted most.\n"));
}

TEST(DecisionWords, StatesWhyNothingIsDecided) {
  helm_decision_t decision = GivesWay();
  decision.all_stop = "NothingToDo";
  EXPECT_TRUE(DecisionLine(decision).ends_with("It stands still: NothingToDo."));
}

TEST(DecisionWords, MakesTextOfOthersPrintable) {
  helm_decision_t decision = GivesWay();
  decision.vehicle = "a\x1b[31m";
  decision.events = {"mode: \n\t"};
  decision.num_events = 1;
  const std::string text = DecisionWords(decision);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(text.find('\t'), std::string::npos);
}

TEST(DecisionWords, NameAllBehaviorsWhoseSumWonInFull) {
  helm_decision_t decision = GivesWay();
  const std::string long_name = "avoid_" + std::string(60, 'x');
  decision.aims.push_back(Aim(long_name.c_str(), 100, 70, 5));
  decision.aims.push_back(Aim("lost_too", 10, 300, 80));
  decision.num_aims = 4;
  const std::string line = DecisionLine(decision);
  EXPECT_NE(line.find("for avd_ben, which is give-way:stern toward ben by rule 15/16; " +
                      long_name + "."),
            std::string::npos)
      << line;
  EXPECT_EQ(line.find("lost_too"), std::string::npos) << line;
}

TEST(IsChange, LeavesOutSmallSteps) {
  const helm_decision_t last = GivesWay();
  helm_decision_t next = last;
  next.course_deg = 78.9;
  next.speed_mps = 2.1;
  next.aims[0].loss = 1700;
  EXPECT_FALSE(IsChange(next, last));
  next.course_deg = 79;
  EXPECT_TRUE(IsChange(next, last));
  next = last;
  next.speed_mps = 2.25;
  EXPECT_TRUE(IsChange(next, last));
  next = last;
  next.aims[1].role = "cpa";
  EXPECT_TRUE(IsChange(next, last));
}

}  // namespace shoal::decision_words_test
