#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/behaviors/helm_testing.h"
#include "lib/helm/decision/decide.h"

namespace shoal::behavior_decision_test {

TEST(AllStop, ForWantOfADecisionWaitsOneIteration) {
  TestHelm helm;
  helm.Add("survey").condition = {"GO = true"};
  helm.answers["survey"] = Wants90;
  EXPECT_TRUE(helm.TickWith("GO", "true").has_decision);
  HelmOutcome outcome = helm.TickWith("GO", "false");
  EXPECT_EQ(outcome.all_stop, "NothingToDo");
  EXPECT_TRUE(outcome.keeps_last);
  EXPECT_TRUE(HasEvent(outcome, "all_stop", "NothingToDo"));
  outcome = helm.Tick();
  EXPECT_FALSE(outcome.keeps_last);
  EXPECT_FALSE(HasEvent(outcome, "all_stop", "NothingToDo"));
  outcome = helm.TickWith("GO", "true");
  EXPECT_TRUE(HasEvent(outcome, "all_stop", "clear"));
}

TEST(AllStop, IsNotPutOffByAReasonThatChanges) {
  TestHelm helm;
  helm.Add("survey");
  bool has_course = true;
  helm.answers["survey"] = [&](const BehaviorInputs&) {
    BehaviorAnswer answer;
    if (!has_course) return answer;
    answer.objective = Objective{.course = PeakOverCourse(45, 10, 170)};
    answer.relevance = 1;
    return answer;
  };
  HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.all_stop, "MissingDecVars:speed");
  EXPECT_TRUE(outcome.keeps_last);
  has_course = false;
  outcome = helm.Tick();
  EXPECT_EQ(outcome.all_stop, "NothingToDo");
  EXPECT_FALSE(outcome.keeps_last);
}

TEST(AllStop, ByAnErrorIsAtOnceAndLastsAsLongAsTheError) {
  TestHelm helm;
  helm.Add("region");
  helm.Add("survey");
  helm.answers["survey"] = Wants90;
  bool is_outside = true;
  helm.answers["region"] = [&](const BehaviorInputs&) {
    BehaviorAnswer answer;
    if (is_outside) answer.error = "outside";
    return answer;
  };
  HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.all_stop, "BehaviorError:region: outside");
  EXPECT_FALSE(outcome.keeps_last);
  EXPECT_FALSE(outcome.has_decision);
  EXPECT_EQ(outcome.commands, HelmPoint());
  is_outside = false;
  outcome = helm.Tick();
  EXPECT_EQ(outcome.all_stop, "clear");
  EXPECT_TRUE(outcome.has_decision);
}

TEST(AllStop, ByABehaviorThatEndsWithItsErrorLastsUntilTheOperatorClearsIt) {
  TestHelm helm;
  helm.Add("crash");
  helm.Add("survey");
  helm.answers["survey"] = Wants90;
  helm.answers["crash"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer;
    answer.error = "crashed";
    answer.completes = true;
    return answer;
  };
  helm.Tick();
  HelmOutcome outcome = helm.TickFor(5);
  EXPECT_EQ(outcome.all_stop, "BehaviorError:crash: crashed");
  EXPECT_FALSE(outcome.has_decision);
  helm.set->Clear();
  EXPECT_TRUE(helm.Tick().has_decision);
}

TEST(AllStop, MeetsPreferencesThatAreNoNumbers) {
  TestHelm helm;
  helm.Add("survey");
  helm.answers["survey"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer = Wants(90, 2);
    answer.objective->course.at(17) = std::numeric_limits<double>::quiet_NaN();
    return answer;
  };
  EXPECT_EQ(helm.Tick().all_stop, "BehaviorError:survey: its preferences are not finite numbers");
  helm.answers["survey"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer = Wants(90, 2);
    answer.objective->speed.pop_back();
    return answer;
  };
  EXPECT_FALSE(helm.Tick().has_decision);
}

TEST(AllStop, MeetsConstraintsWithoutAGoalWhereGoalsAreMandatory) {
  for (const bool mandatory : {true, false}) {
    TestHelm helm;
    helm.setup.goals_mandatory = mandatory;
    helm.Add("limit");
    helm.answers["limit"] = Wants90;
    EXPECT_EQ(helm.Tick().all_stop, mandatory ? "NoGoalBehavior" : "clear");
    helm.task = TaskAim{.name = "home", .kind = "return", .course_deg = 10, .speed_mps = 1};
    EXPECT_EQ(helm.Tick().all_stop, "clear");
  }
}

TEST(Decision, DoesNotDependOnTheOrderOfTheFile) {
  std::vector<HelmPoint> points;
  for (const bool reversed : {false, true}) {
    TestHelm helm;
    std::vector<std::string> names = {"a", "b", "c"};
    if (reversed) names = {"c", "b", "a"};
    for (const std::string& name : names) helm.Add(name).pwt = name == "a" ? 100 : 73;
    helm.answers["a"] = [](const BehaviorInputs&) { return Wants(20, 1); };
    helm.answers["b"] = [](const BehaviorInputs&) { return Wants(100, 2.5); };
    helm.answers["c"] = [](const BehaviorInputs&) { return Wants(300, 4); };
    points.push_back(helm.Tick().commands);
  }
  EXPECT_EQ(points[0], points[1]);
}

TEST(Decision, IgnoresABehaviorWithoutWeight) {
  TestHelm helm;
  helm.Add("survey");
  helm.Add("other").pwt = 0;
  helm.answers["survey"] = Wants90;
  helm.answers["other"] = [](const BehaviorInputs&) { return Wants(270, 0.5); };
  const HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.commands, (HelmPoint{.course_deg = 90, .speed_mps = 2}));
  EXPECT_EQ(outcome.aims.at(1).weight, 0);
  EXPECT_EQ(outcome.aims.at(1).state, "running");
}

TEST(Decision, StatesWhatEachLost) {
  TestHelm helm;
  helm.Add("east").pwt = 200;
  helm.Add("west");
  helm.answers["east"] = Wants90;
  helm.answers["west"] = [](const BehaviorInputs&) { return Wants(270, 2); };
  const HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.commands.course_deg, 90);
  EXPECT_EQ(outcome.aims.at(1).best.course_deg, 270);
  EXPECT_NEAR(outcome.aims[1].value, 50, 1e-9);
  EXPECT_NEAR(outcome.aims[1].loss, 5000, 1e-6);
  EXPECT_NEAR(outcome.utility, 200 * 100 + 100 * 50, 1e-6);
}

TEST(Decision, OfTheTaskAloneIsTheTasksOwn) {
  TestHelm helm;
  BehaviorOptions& survey = helm.Add("survey");
  survey.condition = {"GO = true"};
  survey.pwt = 300;
  helm.answers["survey"] = Wants90;
  helm.task = TaskAim{.name = "legs", .kind = "waypoints", .course_deg = 33.4, .speed_mps = 1.23};
  HelmOutcome outcome = helm.Tick();
  EXPECT_TRUE(outcome.only_task);
  EXPECT_TRUE(outcome.is_task_point);
  EXPECT_EQ(outcome.commands.course_deg, 33);
  EXPECT_NEAR(*outcome.commands.speed_mps, 1.2, 1e-9);
  EXPECT_EQ(outcome.aims.at(0).name, "legs");
  outcome = helm.TickWith("GO", "true");
  EXPECT_FALSE(outcome.only_task);
  EXPECT_FALSE(outcome.is_task_point);
}

TEST(Decision, LetsATaskWithoutWeightLeadOnlyWhereNothingElseDoes) {
  TestHelm helm;
  helm.Add("survey").condition = {"GO = true"};
  helm.answers["survey"] = Wants90;
  helm.task =
      TaskAim{.name = "legs", .kind = "waypoints", .pwt = 0, .course_deg = 33, .speed_mps = 1};
  EXPECT_TRUE(helm.Tick().only_task);
  const HelmOutcome outcome = helm.TickWith("GO", "true");
  EXPECT_FALSE(outcome.only_task);
  EXPECT_EQ(outcome.commands, (HelmPoint{.course_deg = 90, .speed_mps = 2}));
}

TEST(Decision, AgreesWithATaskBesideABehaviorThatDoesNotMind) {
  TestHelm helm;
  helm.Add("limit");
  helm.answers["limit"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer;
    answer.objective = Objective{.speed = AtMost(Domain().speed_mps, 2, 0.5)};
    answer.relevance = 1;
    return answer;
  };
  helm.task = TaskAim{.name = "legs", .kind = "waypoints", .course_deg = 359.7, .speed_mps = 1.23};
  const HelmOutcome outcome = helm.Tick();
  EXPECT_FALSE(outcome.only_task);
  EXPECT_TRUE(outcome.is_task_point);
  EXPECT_EQ(outcome.commands.course_deg, 0);
}

TEST(ObjectiveOfATask, IsGreatestAtTheGridPointNearestToItsCommands) {
  const Domain domain = {.depth_m = {.first = 0, .step = 1, .count = 101}};
  for (const double course_deg : {0.0, 0.4, 90.6, 179.5, 359.6}) {
    for (const double speed_mps : {0.0, 0.04, 0.26, 1.5, 3.97, 9.0}) {
      const TaskAim task = {.name = "",
                            .kind = "",
                            .course_deg = course_deg,
                            .speed_mps = speed_mps,
                            .depth_m = 12.3};
      const std::vector<WeightedObjective> alone = {{1, ObjectiveOf(task, domain)}};
      const GridDecision decision = Decide(domain, alone);
      EXPECT_EQ(decision.point.speed, domain.speed_mps.Nearest(speed_mps));
      EXPECT_EQ(decision.point.depth, 12);
      EXPECT_NEAR(decision.utility, 100, 1e-6);
      if (speed_mps == 0) {
        EXPECT_FALSE(decision.point.course.has_value());
      } else {
        const int nearest = static_cast<int>(std::ceil(course_deg - 0.5)) % 360;
        EXPECT_EQ(decision.point.course, nearest) << course_deg << " " << speed_mps;
      }
    }
  }
}

}  // namespace shoal::behavior_decision_test
