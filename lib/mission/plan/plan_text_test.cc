#include "lib/mission/plan/plan_text.h"

#include <gtest/gtest.h>

namespace shoal::plan_text_test {

constexpr std::string_view kText = R"(# A mission – with a dash of three bytes.
[mission]
duration_s = 60
op_area = [[0, 0], [100, 0], [100, 100]]

[[vehicle]]
name = "älpha"  # two bytes in one letter
start = {x_m = 1, y_m = -2.5, heading_deg = 90}

[[vehicle.task]]
kind = "waypoints"
points = [
  [10, 20],   # the first
  [30, 40]
]

[[vehicle.task]]
name = "away"
kind = "loiter"
points_frame = "start"
center = [5, 5]

[[vehicle]]
name = "bravo"

[[vehicle.behavior]]
name = "loiter_b"
kind = "loiter"
polygon = "radial:: x=0, y=0, radius=30, pts=8"

[[obstacle]]
id = "rock"
polygon = [[0, 0], [1, 0], [1, 1]]
)";

std::string_view Part(TextSpan span) { return kText.substr(span.begin, span.end - span.begin); }

TEST(PlanText, FindsThePlacesAndWhereTheirNumbersStand) {
  const auto plan = ReadPlan(kText);
  ASSERT_TRUE(plan.has_value());
  std::vector<std::string> found;
  for (const PlanHandle& handle : plan->handles) {
    found.push_back(handle.vehicle + "/" + handle.kind + "/" + handle.key);
  }
  EXPECT_EQ(found, (std::vector<std::string>{"/op_area/op_area", "älpha/start/start",
                                             "älpha/waypoints/points", "bravo/start/start",
                                             "/obstacle/polygon"}));
  const PlanHandle& way = plan->handles[2];
  EXPECT_EQ(way.shape, PlanShape::kLine);
  ASSERT_EQ(way.points.size(), 2u);
  EXPECT_EQ(Part(way.points[0].whole), "[10, 20]");
  EXPECT_EQ(Part(way.points[1].x), "30");
  EXPECT_EQ(Part(way.points[1].y), "40");
  EXPECT_EQ(way.points[1].y_m, 40);
  EXPECT_EQ(Part(plan->handles[1].points[0].y), "-2.5");
  EXPECT_TRUE(plan->handles[3].points[0].x.empty()) << "bravo has no start in the file";
}

TEST(PlanText, KnowsWhereATableOfAVehicleCanBeAdded) {
  const auto plan = ReadPlan(kText);
  ASSERT_TRUE(plan.has_value());
  ASSERT_EQ(plan->vehicles.size(), 2u);
  EXPECT_EQ(kText.substr(plan->vehicles[0].end, 13), "\n[[vehicle]]\n");
  EXPECT_EQ(kText.substr(plan->vehicles[1].end, 14), "\n[[obstacle]]\n");
  EXPECT_EQ(kText.substr(*plan->mission_keys, 10), "duration_s");
  EXPECT_EQ(plan->vehicles[0].task_names, (std::vector<std::string>{"waypoints", "away"}));
}

TEST(PlanText, OfWhatIsNotTomlIsNone) {
  EXPECT_FALSE(ReadPlan("[mission").has_value());
  EXPECT_FALSE(ReadPlan("\xff\xfe").has_value());
  EXPECT_TRUE(ReadPlan("")->handles.empty());
  EXPECT_TRUE(ReadPlan("vehicle = 3\nmission = [1]\nobstacle = [[1]]\n")->handles.empty());
}

TEST(TomlText, FindsTheEndOfEveryValue) {
  const std::string_view text =
      "a = [1, '#]', \"\\\"]\"] # x\nb = {c = [2]}\nd = '''x\n]'''\ne = -1.5e3,";
  const TomlText toml(text);
  const auto at = [&](std::string_view begin) {
    const TextSpan span = toml.ValueAt(text.find(begin));
    return text.substr(span.begin, span.end - span.begin);
  };
  EXPECT_EQ(at("[1"), "[1, '#]', \"\\\"]\"]");
  EXPECT_EQ(at("{c"), "{c = [2]}");
  EXPECT_EQ(at("'''x"), "'''x\n]'''");
  EXPECT_EQ(at("-1.5"), "-1.5e3");
}

}  // namespace shoal::plan_text_test
