#include "lib/tools/plot/plot_figures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "lib/tools/analysis/swarm_testing.h"
#include "lib/tools/plot/plot_testing.h"

namespace shoal::plot_figures_test {

bool Contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Figures : public ::testing::Test {
 protected:
  void Draw(const std::vector<TestEvent>& events, const PlotSetting& setting) {
    PlotDataBuilder builder({}, setting);
    for (const TestEvent& event : events) {
      builder.Add({.utime = event.utime, .channel = event.channel, .data = event.data});
    }
    figures_ = DrawFigures(builder.Build(), setting, false);
  }
  const Figure& Of(const std::string& name) {
    return *std::find_if(figures_.begin(), figures_.end(),
                         [&](const Figure& figure) { return figure.name == name; });
  }
  static PlotSetting Berta() {
    PlotSetting setting{.title = "berta", .seed = 3};
    setting.vehicles = {
        {.name = "alpha", .color = "dodgerblue", .paths = {{.legs = {{0, 0}, {200, 0}}}}}};
    return setting;
  }

  std::vector<Figure> figures_;
};

TEST_F(Figures, ShowTracksWithEqualAxesPlanAndMarks) {
  Draw(LogOfTwoVehicles(), Berta());
  const Figure& tracks = Of("tracks");
  EXPECT_EQ(tracks.why_left_out, "");
  EXPECT_TRUE(Contains(tracks.script, "set size ratio -1\n"));
  EXPECT_TRUE(Contains(tracks.script, "set title 'Tracks: berta, seed 3'\n"));
  EXPECT_TRUE(Contains(tracks.script, "title 'alpha'"));
  EXPECT_TRUE(Contains(tracks.script, "title 'every 10 s'"));
  EXPECT_TRUE(Contains(tracks.script, "lc rgb '#1e90ff' lw 1.6"));
  EXPECT_TRUE(Contains(tracks.data, "# alpha, plan\n0 0\n200 0\n"));
  EXPECT_TRUE(Contains(tracks.data, "# alpha, start\n0 0\n"));
  EXPECT_TRUE(Contains(tracks.data, "\n20 0 10\n"));
  EXPECT_FALSE(Contains(tracks.script, "$floor"));
}

TEST_F(Figures, LeaveRoomBetweenTheNumbersOfTheHorizontalAxis) {
  // 2,000 m to the North make a figure of 240 pixels and 700 m: numbers of five digits have room
  // every 200 m.
  std::vector<TestEvent> events;
  for (int i = 0; i <= 100; ++i) {
    events.push_back(EventOf("NAV_ALPHA", PlottedNav(i * 100'000, 98'765, 20 * i)));
  }
  Draw(events, {.title = "far"});
  EXPECT_TRUE(Contains(Of("tracks").script, "set xtics 200\n")) << Of("tracks").script;
}

TEST_F(Figures, MarkWhereVehiclesCollideAndRunAground) {
  PlotSetting setting = Berta();
  setting.vehicles = {{.name = "alpha", .color = "red", .length_m = 4, .draught_m = 0.5},
                      {.name = "bravo", .color = "blue", .length_m = 4}};
  std::vector<TestEvent> events;
  for (int i = 0; i <= 100; ++i) {
    const int64_t utime = i * 100'000;
    nav_t alpha =
        PlottedNav(utime, 0.5 * i, 0);  // It passes bravo at 3.5 m, and goes aground at x = 40.
    alpha.altitude_m = i < 80 ? 2 : 0.4;
    events.push_back(EventOf("NAV_ALPHA", alpha));
    nav_t bravo = PlottedNav(utime, 20, 3.5);
    bravo.altitude_m = 0.1;
    events.push_back(EventOf("NAV_BRAVO", bravo));
  }
  Draw(events, setting);
  const Figure& tracks = Of("tracks");
  EXPECT_TRUE(Contains(tracks.data, "# collision\n18.5 0\n")) << tracks.data;
  EXPECT_TRUE(Contains(tracks.data, "# aground\n40 0\n")) << "bravo is not a vessel that can";
  EXPECT_TRUE(Contains(tracks.script, "title 'collision'"));
  EXPECT_TRUE(Contains(tracks.script, "title 'aground'"));
  Draw(LogOfTwoVehicles(), setting);
  EXPECT_FALSE(Contains(Of("tracks").script, "title 'collision'")) << "30 m apart";
}

TEST_F(Figures, ShowWhatProgramsDrew) {
  std::vector<TestEvent> events = LogOfTwoVehicles();
  view_circle_t circle{};
  circle.owner = "planner";
  circle.label = "\"; set output \"evil";
  circle.color = "red";
  circle.radius_m = 20;
  events.push_back(EventOf("VIEW_CIRCLE", circle));
  view_polygon_t box{};
  box.label = "box";
  box.num_points = 3;
  box.x_m = {0, 10, 10};
  box.y_m = {0, 0, 10};
  events.push_back(EventOf("VIEW_POLYGON", box));
  box.label = "gone";
  box.life_s = -1;
  events.push_back(EventOf("VIEW_POLYGON", box));
  Draw(events, Berta());
  const Figure& tracks = Of("tracks");
  EXPECT_TRUE(Contains(tracks.script, "lines lc rgb '#ff0000' lw 1.4"));
  EXPECT_TRUE(Contains(tracks.data, "# drawn: box\n0 0\n10 0\n10 10\n0 0\n"));
  EXPECT_TRUE(Contains(tracks.data, "\n0 20 \"?; set output ?evil\"\n"));
  EXPECT_FALSE(Contains(tracks.data, "gone"));
  EXPECT_FALSE(Contains(tracks.script, "evil"));
}

TEST_F(Figures, LeaveOutPlacesOfDrawingsThatAreNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<TestEvent> events = LogOfTwoVehicles();
  view_polygon_t box{};
  box.label = "box";
  box.num_points = 5;
  box.x_m = {0, kNan, 10, 1e300, 10};
  box.y_m = {0, 5, 0, -1e300, 10};
  events.push_back(EventOf("VIEW_POLYGON", box));
  TestEvent cut = EventOf("VIEW_POLYGON", box);
  cut.data.resize(cut.data.size() - sizeof(double));
  events.push_back(cut);
  view_circle_t circle{};
  circle.label = "circle";
  circle.x_m = std::numeric_limits<double>::infinity();
  circle.radius_m = kNan;
  events.push_back(EventOf("VIEW_CIRCLE", circle));
  Draw(events, Berta());
  const Figure& tracks = Of("tracks");
  EXPECT_TRUE(Contains(tracks.data, "# drawn: box\n0 0\n10 0\n10 10\n0 0\n")) << tracks.data;
  EXPECT_FALSE(Contains(tracks.data, "circle"));
  EXPECT_FALSE(Contains(tracks.data, "nan"));
  EXPECT_FALSE(Contains(tracks.data, "inf"));
  EXPECT_FALSE(Contains(tracks.data, "e+300"));
}

TEST_F(Figures, ShowTheAreaThatIsSurveyedAndTheBandThatIsCovered) {
  PlotSetting setting = Berta();
  setting.areas = {{{-10, -20}, {130, -20}, {130, 20}, {-10, -20}}};
  setting.coverage = {{.vehicle = "Alpha", .width_m = 16}};
  Draw(LogOfTwoVehicles(), setting);
  const Figure& tracks = Of("tracks");
  EXPECT_TRUE(Contains(tracks.data, "# areas\n-10 -20\n130 -20\n130 20\n-10 -20\n"));
  // Discs of 8 m radius, one in every 2 m of the track.
  EXPECT_TRUE(Contains(tracks.data, "# alpha, covered\n0 0 8\n2 0 8\n4 0 8\n"));
  EXPECT_FALSE(Contains(tracks.data, "# bravo, covered"));
  EXPECT_TRUE(Contains(tracks.script, "with circles lc rgb '#c6e3fe' fs solid noborder"));
  EXPECT_TRUE(Contains(tracks.script, "title 'covered'"));
}

TEST_F(Figures, ShowTheWaypointsThatTheHelmPublishedWhereThereIsNoMission) {
  Draw(LogOfTwoVehicles(), {.title = "log"});
  EXPECT_TRUE(Contains(Of("tracks").script, "set title 'Tracks: log'\n"));
  EXPECT_TRUE(Contains(Of("tracks").data, "# alpha, waypoints\n200 0\n"));
}

TEST_F(Figures, ShowTheContourOfAFloorThatIsNotFlat) {
  PlotSetting setting = Berta();
  setting.floor_depth_m = [](double x_m, double) { return 20 + 0.1 * x_m; };
  Draw(LogOfTwoVehicles(), setting);
  EXPECT_TRUE(Contains(Of("tracks").script, "set contour base\n"));
  EXPECT_TRUE(Contains(Of("tracks").script, "plot $floor"));
  setting.floor_depth_m = [](double, double) { return 20; };
  Draw(LogOfTwoVehicles(), setting);
  EXPECT_FALSE(Contains(Of("tracks").script, "$floor"));
}

TEST_F(Figures, LeaveOutWhatTheLogDoesNotHold) {
  Draw(LogOfTwoVehicles(), Berta());
  EXPECT_EQ(Of("depth").why_left_out, "all vehicles stay at the surface");
  Draw({EventOf("NAV_ALPHA", PlottedNav(0, 0, 0, 5))}, Berta());
  EXPECT_EQ(Of("depth").why_left_out, "");
  EXPECT_EQ(Of("distances").why_left_out, "there is one vehicle alone");
  EXPECT_EQ(Of("actuators").why_left_out, "no ACTUATORS of these vehicles in the log");
  Draw({}, Berta());
  for (const Figure& figure : figures_) EXPECT_NE(figure.why_left_out, "") << figure.name;
}

TEST_F(Figures, ShowDistancesThatALawHoldsTo) {
  PlotSetting setting = Berta();
  setting.distances = {{"r_safe", 10}, {"r_inner", 80}};
  Draw(LogOfTwoVehicles(), setting);
  EXPECT_TRUE(Contains(Of("distances").script, "title 'r_inner = 80 m'"));
  EXPECT_TRUE(Contains(Of("distances").data, "\n0 80\n60 80\n"));
}

TEST_F(Figures, CutAHeadingThatGoesThroughNorth) {
  nav_t before = PlottedNav(0, 0, 0);
  before.heading_deg = 359;
  nav_t after = PlottedNav(100'000, 0, 0);
  after.heading_deg = 1;
  Draw({EventOf("NAV_A", before), EventOf("NAV_A", after)}, Berta());
  EXPECT_TRUE(Contains(Of("speed").data, "\n0 359\n\n0.1 1\n"));
}

TEST_F(Figures, ShowHowOldNewsOfTargetsAre) {
  Draw(LogOfTwoVehicles(), Berta());
  EXPECT_EQ(Of("age").why_left_out, "no SWARM of these vehicles in the log");
  std::vector<TestEvent> events = LogOfTwoVehicles();
  for (const int64_t utime : {1'000'000, 2'000'000}) {
    events.push_back(EventOf("SWARM_BRAVO", SwarmAt(utime, "bravo", {ContactAt("alpha", 0)})));
  }
  Draw(events, Berta());
  EXPECT_EQ(Of("age").why_left_out, "");
  EXPECT_TRUE(Contains(Of("age").script, "set ylabel 'age of target information [s]'"));
  EXPECT_FALSE(Contains(Of("age").script, "age of oldest information"))
      << "no contact was received";
  EXPECT_TRUE(Contains(Of("age").data, "\n1 1\n2 2\n"));
}

TEST_F(Figures, ShowHowFarVehiclesAreFromWhereTheyBelieveToBe) {
  Draw(LogOfTwoVehicles(), Berta());
  EXPECT_EQ(Of("navigation").why_left_out, "no NAVIGATION of these vehicles in the log");
  navigation_t navigation{};
  navigation.utime = 1'000'000;
  navigation.x_m = 3;
  navigation.y_m = 4;
  navigation.ellipse_major_m = 7;
  // In a log of a mission it is before NAV of the same time; in others it may come after.
  Draw({EventOf("NAVIGATION_A", navigation), EventOf("NAV_A", PlottedNav(1'000'000, 0, 0)),
        EventOf("NAV_B", PlottedNav(1'000'000, 0, 0)), EventOf("NAVIGATION_B", navigation)},
       Berta());
  EXPECT_EQ(Of("navigation").why_left_out, "");
  for (const std::string name : {"A", "B"}) {
    EXPECT_TRUE(Contains(Of("navigation").data, "# " + name + ", error\n1 5\n")) << name;
    EXPECT_TRUE(Contains(Of("navigation").data, "# " + name + ", 95 % bound\n1 7\n")) << name;
    EXPECT_TRUE(Contains(Of("tracks").data, "# " + name + ", where it believed to be\n3 4\n"));
  }
}

guidance_t GuidanceAt(int64_t utime, double weight) {
  guidance_t guidance{};
  guidance.utime = utime;
  guidance.waypoint_index = 0;
  guidance.depth_m = 12;
  guidance.pitch_deg = -3;
  guidance.crab_deg = 4;
  guidance.u_max_mps = 2;
  guidance_layer_t sonar{};
  sonar.name = "sonar";
  sonar.speed_mps = 1;
  sonar.weight = weight;
  guidance_layer_t other{};
  other.name = "no layer of ours";
  guidance.layers = {sonar, other};
  guidance.num_layers = 2;
  return guidance;
}

TEST_F(Figures, ShowWhatTheGuidanceOfAnUnderwaterVehicleWants) {
  Draw({EventOf("NAV_A", PlottedNav(0, 0, 0, 5)), EventOf("GUIDANCE_A", GuidanceAt(0, 1)),
        EventOf("GUIDANCE_A", GuidanceAt(1'000'000, 0.25))},
       Berta());
  EXPECT_TRUE(Contains(Of("depth").data, "# A, desired depth\n0 12\n1 12\n"));
  EXPECT_TRUE(Contains(Of("depth").data, "# A, desired pitch\n0 -3\n1 -3\n"));
  EXPECT_TRUE(Contains(Of("track_error").data, "# A, crab angle by ALOS\n0 4\n1 4\n"));
  EXPECT_TRUE(Contains(Of("layers").data, "# A, sonar, weight\n0 1\n1 0.25\n"));
  EXPECT_TRUE(Contains(Of("layers").data, "# A, sonar, asks for\n0 0.5\n1 0.5\n"));
  EXPECT_FALSE(Contains(Of("layers").script, "formation")) << "no panel without a curve";
}

TEST_F(Figures, LeaveLayersOutWhereNoTaskHasThem) {
  Draw(LogOfTwoVehicles(), Berta());
  EXPECT_EQ(Of("layers").why_left_out, "no GUIDANCE with layers in the log");
  EXPECT_FALSE(Contains(Of("track_error").data, "by ALOS"));
}

TEST_F(Figures, ShowNoCrabAngleOfAVehicleThatDrifts) {
  nav_t nav = PlottedNav(0, 0, 0, 5);
  nav.speed_over_ground_mps = 0.4;
  nav.course_over_ground_deg = 180;
  Draw({EventOf("NAV_A", nav)}, Berta());
  EXPECT_FALSE(Contains(Of("track_error").data, "crab angle"));
  nav.speed_mps = 1;
  Draw({EventOf("NAV_A", nav)}, Berta());
  EXPECT_TRUE(Contains(Of("track_error").data, "# A, crab angle\n0 180\n"));
}

TEST_F(Figures, ShowNoCrabAngleWhileTheSpeedIsFarFromTheDesiredOne) {
  nav_t nav = PlottedNav(0, 0, 0, 5);
  nav.speed_over_ground_mps = 0.4;
  nav.course_over_ground_deg = 180;
  nav.speed_mps = 0.9;
  desired_t desired{};
  for (const double desired_mps : {0.0, 2.0}) {
    desired.speed_mps = desired_mps;
    Draw({EventOf("DESIRED_A", desired), EventOf("NAV_A", nav)}, Berta());
    EXPECT_FALSE(Contains(Of("track_error").data, "crab angle")) << desired_mps;
  }
  desired.speed_mps = 1.5;
  Draw({EventOf("DESIRED_A", desired), EventOf("NAV_A", nav)}, Berta());
  EXPECT_TRUE(Contains(Of("track_error").data, "# A, crab angle\n0 180\n"));
}

TEST_F(Figures, ShowTheDepthWithTheSeaFloorBelow) {
  nav_t nav = PlottedNav(0, 0, 0, 5);
  nav.altitude_m = 15;
  Draw({EventOf("NAV_A", nav)}, Berta());
  EXPECT_TRUE(Contains(Of("depth").script, "reverse"));
  EXPECT_TRUE(Contains(Of("depth").script, "title 'sea floor below'"));
}

}  // namespace shoal::plot_figures_test
