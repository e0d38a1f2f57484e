#include "apps/helm/helm_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace shoal::helm_order_test {

std::string ErrorOf(std::string_view command, std::string_view argument,
                    const std::vector<double>& values) {
  const Result<HelmOrder> order = ReadOrder(command, argument, values);
  return order.ok() ? "" : order.error();
}

TEST(ReadOrder, KnowsEveryOrderByItsName) {
  for (int i = 0; i < kNumOrderKinds; ++i) {
    const auto kind = static_cast<OrderKind>(i);
    const bool has_point = kind == OrderKind::kGoto || kind == OrderKind::kMove;
    const size_t num_values = has_point ? 2 : kind == OrderKind::kSpeed ? 1 : 0;
    const bool has_task = kind == OrderKind::kTask || kind == OrderKind::kMove;
    const char* argument = has_task ? "x" : kind == OrderKind::kSet ? "X=1" : "";
    const Result<HelmOrder> order =
        ReadOrder(Name(kind), argument, std::vector<double>(num_values, 3.0));
    ASSERT_TRUE(order.ok()) << order.error();
    EXPECT_EQ(order->kind, kind);
  }
}

TEST(ReadOrder, TakesThePointTheSpeedAndTheTask) {
  EXPECT_EQ(ReadOrder("goto", "", std::vector{5.0, -7.0})->point_m, Eigen::Vector2d(5, -7));
  EXPECT_EQ(ReadOrder("speed", "", std::vector{2.5})->speed_mps, 2.5);
  EXPECT_EQ(ReadOrder("task", "survey", {})->task, "survey");
  const std::vector<double> places = {1, 2, 3, 4};
  EXPECT_EQ(ReadOrder("move", "survey", places)->task, "survey");
  EXPECT_EQ(ReadOrder("move", "survey", places)->places, places);
}

TEST(ReadOrder, TakesAVariableAndItsValue) {
  EXPECT_EQ(ReadOrder("set", "RETURN = true", {})->setting,
            (VariablePost{.variable = "RETURN", .value = std::string("true")}));
  EXPECT_EQ(ReadOrderText("set=DEPTH=12.5")->setting,
            (VariablePost{.variable = "DEPTH", .value = 12.5}));
  EXPECT_FALSE(ReadOrder("set", "RETURN", {}).ok());
  EXPECT_FALSE(ReadOrder("set", "RETURN = true [to] all", {}).ok());
}

TEST(ReadOrder, StatesWhatIsWrong) {
  EXPECT_EQ(ErrorOf("", "", {}), "unknown command ''");
  EXPECT_EQ(ErrorOf("DEPLOY", "", {}), "unknown command 'DEPLOY'");
  EXPECT_EQ(ErrorOf("goto", "", {1}), "goto takes 2 values and not 1");
  EXPECT_EQ(ErrorOf("deploy", "", {1}), "deploy takes 0 values and not 1");
  EXPECT_EQ(ErrorOf("deploy", "now", {}), "deploy takes no argument");
  EXPECT_EQ(ErrorOf("move", "x", {1, 2, 3}), "move takes x and y of each point and not 3 values");
  EXPECT_EQ(ErrorOf("move", "x", {}), "move takes x and y of each point and not 0 values");
  EXPECT_EQ(ErrorOf("move", "", {1, 2}), "move needs the name of a task as its argument");
  EXPECT_EQ(ErrorOf("all_stop", std::string(101, 'x'), {}),
            "the reason of all_stop has 101 characters; 100 are the most");
  EXPECT_EQ(ErrorOf("task", "", {}), "task needs the name of a task as its argument");
}

TEST(ReadOrder, RefusesInvalidNumbers) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 1e300}) {
    EXPECT_NE(ErrorOf("goto", "", {bad, 0}), "") << bad;
    EXPECT_NE(ErrorOf("goto", "", {0, bad}), "") << bad;
  }
  for (const double bad : {nan, infinity, 0.0, -1.0}) {
    EXPECT_NE(ErrorOf("speed", "", {bad}), "") << bad;
  }
}

TEST(ReadOrderText, KnowsOrdersWithTheirValues) {
  EXPECT_EQ(ReadOrderText("return")->kind, OrderKind::kReturn);
  EXPECT_EQ(ReadOrderText("speed=1.2")->speed_mps, 1.2);
  EXPECT_EQ(ReadOrderText("goto=10,-20.5")->point_m, Eigen::Vector2d(10, -20.5));
  EXPECT_EQ(ReadOrderText("task=survey")->task, "survey");
}

TEST(ReadOrderText, StatesWhatIsWrong) {
  EXPECT_EQ(ReadOrderText("").error(), "unknown command ''");
  EXPECT_EQ(ReadOrderText("speed=").error(), "'speed=' has nothing behind the '='");
  EXPECT_EQ(ReadOrderText("speed=fast").error(), "'fast' is not a number");
  EXPECT_EQ(ReadOrderText("goto=1").error(), "goto takes 2 values and not 1");
  EXPECT_EQ(ReadOrderText("goto=1,,2").error(), "'' is not a number");
  EXPECT_EQ(ReadOrderText("deploy=1").error(), "deploy takes 0 values and not 1");
  EXPECT_FALSE(ReadOrderText("speed=nan").ok());
  EXPECT_FALSE(ReadOrderText("goto=inf,0").ok());
}

TEST(ReadOrder, ShowsOfAnUnknownCommandOnlyPrintableCharacters) {
  EXPECT_EQ(ErrorOf("a\x1b[2J\nb\xff", "", {}), "unknown command 'a?[2J?b?'");
  EXPECT_LT(ErrorOf(std::string(100'000, 'x'), "", {}).size(), 80u);
}

}  // namespace shoal::helm_order_test
