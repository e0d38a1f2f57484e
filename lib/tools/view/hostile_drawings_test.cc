// Drawings of programs with hostile numbers, as a recording holds them: in the viewer and in a page
// that is one file. Plots: lib/tools/plot/plot_figures_test.cc.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "lib/tools/view/drawing_book.h"
#include "lib/tools/view/page_recording.h"
#include "lib/tools/view/recorded_testing.h"
#include "shoal/view_circle_t.hpp"
#include "shoal/view_point_t.hpp"
#include "shoal/view_polygon_t.hpp"
#include "shoal/view_text_t.hpp"

namespace shoal::hostile_drawings_test {

using nlohmann::json;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHuge = 1e300;

template <class T>
TestEvent EventOf(const char* channel, const T& message) {
  return {.utime = 1'000'000, .channel = channel, .data = Encoded(message)};
}

view_polygon_t Polygon(const std::string& label, std::vector<double> x_m, std::vector<double> y_m) {
  view_polygon_t polygon{};
  polygon.owner = "planner";
  polygon.label = label;
  polygon.num_points = static_cast<int32_t>(x_m.size());
  polygon.x_m = std::move(x_m);
  polygon.y_m = std::move(y_m);
  return polygon;
}

/// A polygon of which y has fewer values than x.
TestEvent CutPolygon() {
  TestEvent event = EventOf("VIEW_POLYGON", Polygon("cut", {1, 2, 3}, {1, 2, 3}));
  event.data.resize(event.data.size() - sizeof(double));
  return event;
}

std::vector<TestEvent> HostileLog() {
  std::vector<TestEvent> events = TrafficMaker(2).Make(60);
  std::vector<TestEvent> drawings;
  drawings.push_back(EventOf(
      "VIEW_POLYGON", Polygon("odd", {kNan, 5, kInfinity, -kHuge, 7}, {1, 6, 1, kHuge, kNan})));
  drawings.push_back(EventOf("VIEW_POLYGON", Polygon("nowhere", {kNan}, {kNan})));
  drawings.push_back(CutPolygon());
  view_circle_t circle{};
  circle.label = "circle";
  circle.radius_m = kHuge;
  circle.fill = kNan;
  circle.life_s = kInfinity;
  drawings.push_back(EventOf("VIEW_CIRCLE", circle));
  circle.label = "negative";
  circle.radius_m = -5;
  circle.fill = -kInfinity;
  circle.life_s = kNan;
  drawings.push_back(EventOf("VIEW_CIRCLE", circle));
  view_point_t point{};
  point.label = std::string(5'000, '\xff');
  point.color = "</script>";
  point.size_px = kHuge;
  drawings.push_back(EventOf("VIEW_POINT", point));
  view_text_t text{};
  text.x_m = kInfinity;
  text.text = "of no place";
  drawings.push_back(EventOf("VIEW_TEXT", text));
  events.insert(events.begin() + 60, drawings.begin(), drawings.end());
  for (size_t i = 60; i < 60 + drawings.size(); ++i) events[i].utime = events[59].utime;
  return events;
}

/// Every number is finite and within the bounds of drawings.
void ExpectBounded(const json& drawings) {
  ASSERT_EQ(drawings.size(), 4u) << drawings.dump(-1, ' ', false, json::error_handler_t::replace);
  for (const json& drawing : drawings) {
    for (const json& point : drawing["points"]) {
      EXPECT_LE(std::abs(point[0].get<double>()), 1e7);
      EXPECT_LE(std::abs(point[1].get<double>()), 1e7);
    }
    EXPECT_GE(drawing["radius"].get<double>(), 0);
    EXPECT_LE(drawing["radius"].get<double>(), 1e7);
    EXPECT_GE(drawing["fill"].get<double>(), 0);
    EXPECT_LE(drawing["fill"].get<double>(), 1);
    EXPECT_LE(drawing["size"].get<double>(), 100);
    EXPECT_LE(drawing["label"].get<std::string>().size(), 3 * DrawingBook::kMaxText);
  }
}

TEST(HostileDrawings, OfARecordingAreBoundedInTheViewer) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, HostileLog());
  const std::string frame = view->FrameJson(view->end_s());
  ASSERT_TRUE(json::accept(frame));
  const json drawings = json::parse(frame)["drawings"];
  ExpectBounded(drawings);
  for (const json& drawing : drawings) {
    if (drawing["label"] != "odd") continue;
    EXPECT_EQ(drawing["points"], json::parse("[[5, 6]]"));
  }
}

TEST(HostileDrawings, OfARecordingAreBoundedInAPageOfItsOwn) {
  const TestDirectory directory;
  const auto view = OpenTraffic(directory, HostileLog());
  const PageRecording page = RecordForPage(*view, 0, view->end_s(), {.step_s = view->end_s()});
  ASSERT_TRUE(json::accept(page.json));
  const json states = json::parse(page.json)["frames"]["states"];
  const json frame = json::parse(view->FrameJson(0));
  EXPECT_EQ(states[0]["drawings"], frame["drawings"]);
  // The second frame is that of the end, as a change of the first.
  ExpectBounded(states[1]["drawings"][0]);
}

}  // namespace shoal::hostile_drawings_test
