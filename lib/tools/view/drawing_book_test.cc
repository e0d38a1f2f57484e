#include "lib/tools/view/drawing_book.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/bus/bus/channels.h"
#include "lib/tools/view/recorded_testing.h"

namespace shoal::drawing_book_test {

using nlohmann::json;

view_circle_t CircleOf(const std::string& owner, const std::string& label, double life_s = 0) {
  view_circle_t circle{};
  circle.owner = owner;
  circle.label = label;
  circle.color = "orange";
  circle.life_s = life_s;
  circle.x_m = 10;
  circle.radius_m = 50;
  return circle;
}

view_polygon_t PolygonOf(size_t num_points) {
  view_polygon_t polygon{};
  polygon.owner = "planner";
  polygon.label = "box";
  polygon.fill = 0.2;
  for (size_t i = 0; i < num_points; ++i) {
    polygon.x_m.push_back(static_cast<double>(i));
    polygon.y_m.push_back(-1);
  }
  polygon.num_points = static_cast<int32_t>(num_points);
  return polygon;
}

TEST(Drawing, IsReadOfEachType) {
  view_point_t point{};
  point.label = "mine";
  point.x_m = 1;
  point.y_m = 2;
  point.size_px = 8;
  const auto read_point = ReadDrawing("VIEW_POINT", Encoded(point));
  ASSERT_TRUE(read_point);
  EXPECT_EQ(read_point->points_m, (std::vector<std::pair<double, double>>{{1, 2}}));
  EXPECT_EQ(read_point->size_px, 8);
  const auto polygon = ReadDrawing("VIEW_POLYGON", Encoded(PolygonOf(3)));
  ASSERT_TRUE(polygon);
  EXPECT_EQ(polygon->points_m.size(), 3);
  EXPECT_EQ(polygon->fill, 0.2);
  view_seglist_t line{};
  line.num_points = 2;
  line.x_m = {0, 5};
  line.y_m = {1, 6};
  line.width_px = 3;
  const auto seglist = ReadDrawing("VIEW_SEGLIST", Encoded(line));
  ASSERT_TRUE(seglist);
  EXPECT_EQ(seglist->points_m[1], std::pair(5.0, 6.0));
  view_text_t text{};
  text.text = "start here";
  const auto read_text = ReadDrawing("VIEW_TEXT", Encoded(text));
  ASSERT_TRUE(read_text);
  EXPECT_EQ(read_text->text, "start here");
  EXPECT_EQ(ReadDrawing("VIEW_CIRCLE", Encoded(CircleOf("a", "b")))->radius_m, 50);
}

TEST(Drawing, IsNoneOfOtherBytesOrOfNoPlace) {
  EXPECT_FALSE(ReadDrawing("VIEW_POINT", Encoded(CircleOf("a", "b"))));
  EXPECT_FALSE(ReadDrawing("NAV_ALPHA", Encoded(CircleOf("a", "b"))));
  Bytes cut = Encoded(PolygonOf(3));
  cut.pop_back();
  EXPECT_FALSE(ReadDrawing("VIEW_POLYGON", cut));
  EXPECT_FALSE(ReadDrawing("VIEW_POLYGON", Encoded(PolygonOf(0))));
  view_circle_t far = CircleOf("a", "b");
  far.x_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(ReadDrawing("VIEW_CIRCLE", Encoded(far)));
  far.x_m = 1.1e7;
  EXPECT_FALSE(ReadDrawing("VIEW_CIRCLE", Encoded(far)));
}

TEST(Drawing, OfAMillionPointsKeepsItsShapeInFew) {
  const auto polygon = ReadDrawing("VIEW_POLYGON", Encoded(PolygonOf(1'000'000)));
  ASSERT_TRUE(polygon);
  EXPECT_LE(polygon->points_m.size(), DrawingBook::kMaxPoints);
  EXPECT_GT(polygon->points_m.size(), DrawingBook::kMaxPoints / 2);
  EXPECT_GT(polygon->points_m.back().first, 999'000);
}

TEST(DrawingBook, ReplacesWhatHasTheSameOwnerAndLabel) {
  DrawingBook book;
  EXPECT_TRUE(book.Take("VIEW_CIRCLE", Encoded(CircleOf("a", "x")), 0));
  EXPECT_TRUE(book.Take("VIEW_CIRCLE", Encoded(CircleOf("a", "x")), 1));
  EXPECT_TRUE(book.Take("VIEW_CIRCLE", Encoded(CircleOf("b", "x")), 2));
  ASSERT_EQ(book.At(3).size(), 2);
  EXPECT_EQ(book.At(3)[0]->utime, 1);
}

TEST(DrawingBook, ForgetsAtTheEndOfALifeAndWhenAsked) {
  DrawingBook book;
  book.Take("VIEW_CIRCLE", Encoded(CircleOf("a", "short", 2)), 1'000'000);
  book.Take("VIEW_CIRCLE", Encoded(CircleOf("a", "long", 0)), 1'000'000);
  EXPECT_EQ(book.At(3'000'000).size(), 2);
  EXPECT_EQ(book.At(3'000'001).size(), 1);
  book.Take("VIEW_CIRCLE", Encoded(CircleOf("a", "long", -1)), 4'000'000);
  EXPECT_TRUE(book.At(4'000'000).empty());
}

TEST(DrawingBook, KeepsTheNewestOfVeryMany) {
  DrawingBook book;
  for (int i = 0; i < 600; ++i) {
    book.Take("VIEW_CIRCLE", Encoded(CircleOf("a", std::to_string(i))), i);
  }
  const auto drawn = book.At(600);
  ASSERT_EQ(drawn.size(), DrawingBook::kMaxDrawings);
  for (const MapDrawing* drawing : drawn) EXPECT_GE(drawing->utime, 100);
}

TEST(DrawingBook, OfALogIsThatOfTheMomentHoweverItIsReached) {
  const TestDirectory directory;
  std::vector<TestEvent> events = TrafficMaker(1).Make(600);
  std::vector<TestEvent> all;
  for (const TestEvent& event : events) {
    all.push_back(event);
    if (event.channel != "NAV_ALPHA") continue;
    const int64_t step = event.utime / 100'000;
    if (step == 100) {
      all.push_back({event.utime, "VIEW_CIRCLE", Encoded(CircleOf("a", "stays"))});
      all.push_back({event.utime, "VIEW_CIRCLE", Encoded(CircleOf("a", "5 s", 5))});
    }
    if (step == 400)
      all.push_back({event.utime, "VIEW_CIRCLE", Encoded(CircleOf("a", "stays", -1))});
  }
  const auto view = OpenTraffic(directory, all);
  const auto labels = [&](double t_s) {
    std::string text;
    const json frame = json::parse(view->FrameJson(t_s));
    for (const json& drawing : frame["drawings"]) {
      text += drawing["label"].get<std::string>() + ";";
    }
    return text;
  };
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(labels(50), "");
    EXPECT_EQ(labels(9), "");
    EXPECT_EQ(labels(12), "5 s;stays;");
    EXPECT_EQ(labels(39), "stays;");
    EXPECT_EQ(labels(16), "stays;");
  }
}

}  // namespace shoal::drawing_book_test
