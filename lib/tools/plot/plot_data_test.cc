#include "lib/tools/plot/plot_data.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "lib/bus/bus/seal.h"
#include "lib/tools/analysis/swarm_testing.h"
#include "lib/tools/plot/plot_testing.h"

namespace shoal::plot_data_test {

PlotData DataOf(const std::vector<TestEvent>& events, const PlotSelection& selection = {},
                const PlotSetting& setting = {}) {
  PlotDataBuilder builder(selection, setting);
  for (const TestEvent& event : events) {
    builder.Add({.utime = event.utime, .channel = event.channel, .data = event.data});
  }
  return builder.Build();
}

TEST(PlotData, GathersWhatTheVehiclesPublished) {
  const PlotData data = DataOf(LogOfTwoVehicles());
  ASSERT_EQ(data.vehicles.size(), 2u);
  const VehicleCurves& alpha = data.vehicles[0];
  EXPECT_EQ(alpha.name, "alpha");
  EXPECT_EQ(data.vehicles[1].name, "BRAVO");
  EXPECT_EQ(alpha.start, (CurvePoint{0, 0}));
  EXPECT_EQ(alpha.end, (CurvePoint{120, 0}));
  EXPECT_EQ(alpha.crab_deg.Strokes().at(0).at(0), (CurvePoint{0, 5}));
  EXPECT_EQ(alpha.cross_track_m.Strokes().at(0).at(0), (CurvePoint{0, 1.5}));
  EXPECT_EQ(alpha.steered_for, (std::vector<CurvePoint>{{200, 0}}));
  EXPECT_TRUE(alpha.has_thrust);
  EXPECT_FALSE(alpha.dives);
  EXPECT_EQ(data.first_s, 0);
  EXPECT_EQ(data.last_s, 60);
}

TEST(PlotData, MeasuresTheDistanceToTheNearestAtEveryTime) {
  const PlotData data = DataOf(LogOfTwoVehicles());
  const Stroke distance = data.vehicles[1].nearest_m.Strokes().at(0);
  EXPECT_EQ(distance.front(), (CurvePoint{0, 30}));
  EXPECT_EQ(distance.back().x, 60);
  EXPECT_NEAR(distance.back().y, std::hypot(120, 30), 1e-9);
}

TEST(PlotData, MeasuresTheDistanceToTheTarget) {
  PlotSetting setting;
  setting.vehicles = {{.name = "bravo", .color = "red", .target = "Alpha"}};
  const PlotData data = DataOf(LogOfTwoVehicles(), {}, setting);
  EXPECT_TRUE(data.vehicles[0].target_m.empty());
  EXPECT_EQ(data.vehicles[1].target_m.Strokes().at(0).front(), (CurvePoint{0, 30}));
}

TEST(PlotData, MarksEqualTimes) {
  const PlotData data = DataOf(LogOfTwoVehicles());
  EXPECT_EQ(data.mark_interval_s, 10);
  const std::vector<TimeMark>& marks = data.vehicles[0].marks;
  ASSERT_EQ(marks.size(), 6u);
  EXPECT_EQ(marks[0].time_s, 10);
  EXPECT_NEAR(marks[0].at.x, 20, 1e-9);
  EXPECT_EQ(marks[5].time_s, 60);
}

TEST(PlotData, KeepsToTheVehiclesAndTimesAskedFor) {
  const PlotData data =
      DataOf(LogOfTwoVehicles(), {.vehicles = {"Bravo"}, .from_s = 20, .to_s = 30});
  ASSERT_EQ(data.vehicles.size(), 1u);
  EXPECT_EQ(data.first_s, 20);
  EXPECT_EQ(data.last_s, 30);
  // The distance is to all others, whatever is drawn.
  EXPECT_NEAR(data.vehicles[0].nearest_m.Strokes().at(0).front().y, std::hypot(40, 30), 1e-9);
  EXPECT_EQ(data.seen, (std::set<std::string>{"ALPHA", "BRAVO"}));
}

TEST(PlotData, CountsTimeFromTheMissionsStart) {
  PlotSetting setting;
  setting.start_utime = 10'000'000;
  EXPECT_EQ(DataOf(LogOfTwoVehicles(), {}, setting).last_s, 50);
  const int64_t wall_utime = 1'700'000'000'000'000;
  const PlotData data = DataOf({EventOf("NAV_ALPHA", PlottedNav(wall_utime, 0, 0)),
                                EventOf("NAV_ALPHA", PlottedNav(wall_utime + 2'000'000, 1, 0))});
  EXPECT_TRUE(data.zero_is_first);
  EXPECT_EQ(data.last_s, 2);
}

TEST(PlotData, ReadsSealedMessagesToo) {
  std::vector<TestEvent> events = {EventOf("NAV_ALPHA", PlottedNav(0, 3, 4))};
  AppendSeal({.publisher = "vehicle_sim_alpha", .mission_id = 1, .step = 0, .sequence = 0},
             MissionSecret{}, "NAV_ALPHA", &events[0].data);
  EXPECT_EQ(DataOf(events).vehicles.at(0).start, (CurvePoint{3, 4}));
}

TEST(PlotData, LeavesTheFloorOutWhereItIsNotKnown) {
  nav_t over_ground = PlottedNav(0, 0, 0, 5);
  over_ground.altitude_m = 15;
  nav_t unknown = PlottedNav(100'000, 0, 0, 5);
  nav_t again = over_ground;
  again.utime = 200'000;
  const PlotData data =
      DataOf({EventOf("NAV_A", over_ground), EventOf("NAV_A", unknown), EventOf("NAV_A", again)});
  EXPECT_TRUE(data.vehicles.at(0).dives);
  EXPECT_EQ(data.vehicles[0].floor_m.Strokes(), (std::vector<Stroke>{{{0, 20}}, {{0.2, 20}}}));
}

TEST(PlotData, DrawsTheAgeOfNewsAsTheTeethOfASaw) {
  const auto event = [](int64_t utime, std::vector<swarm_contact_t> contacts) {
    return EventOf("SWARM_BRAVO", SwarmAt(utime, "bravo", std::move(contacts)));
  };
  swarm_contact_t unheard = ContactAt("delta", 0, false);
  unheard.is_heard = 0;
  const PlotData data = DataOf({
      event(1'000'000, {ContactAt("alpha", 500'000), unheard}),
      event(3'000'000, {ContactAt("alpha", 2'500'000), ContactAt("delta", 1'000'000, false)}),
      event(4'000'000, {ContactAt("alpha", 9'000'000), ContactAt("charlie", 3'000'000, false),
                        ContactAt("delta", 1'000'000, false)}),
  });
  ASSERT_EQ(data.vehicles.size(), 1u);
  EXPECT_EQ(data.vehicles[0].target_age_s.Strokes(),
            (std::vector<Stroke>{{{1, 0.5}, {3, 2.5}, {3, 0.5}, {4, 1.5}, {4, 0}}}));
  EXPECT_EQ(data.vehicles[0].other_age_s.Strokes(), (std::vector<Stroke>{{{3, 2}, {4, 3}}}))
      << "the oldest of all that were received";
}

TEST(PlotData, DrawsNoAgeWhileNothingIsReceived) {
  swarm_contact_t unheard = ContactAt("alpha", 0);
  unheard.is_heard = 0;
  const PlotData data = DataOf(
      {EventOf("SWARM_BRAVO", SwarmAt(0, "bravo", {ContactAt("alpha", 0)})),
       EventOf("SWARM_BRAVO", SwarmAt(1'000'000, "bravo", {unheard})),
       EventOf("SWARM_BRAVO", SwarmAt(2'000'000, "bravo", {ContactAt("alpha", 0)})),
       EventOf("SWARM_BRAVO", SwarmAt(3'000'000, "bravo", {ContactAt("alpha", INT64_MIN)}))});
  ASSERT_EQ(data.vehicles.size(), 1u);
  EXPECT_EQ(data.vehicles[0].target_age_s.Strokes(), (std::vector<Stroke>{{{0, 0}}, {{2, 2}}}));
  EXPECT_EQ(data.num_impossible, 1);
}

TEST(PlotData, CountsWhatItCannotDraw) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PlotData data =
      DataOf({EventOf("NAV_A", PlottedNav(std::numeric_limits<int64_t>::max(), 0, 0)),
              EventOf("NAV_A", PlottedNav(0, nan, 1e300, -1e300)),
              {.utime = 0, .channel = "NAV_A", .data = {1, 2, 3}},
              {.utime = 0, .channel = "NAV_", .data = {}},
              {.utime = 0, .channel = "", .data = {}}});
  EXPECT_EQ(data.num_undecodable, 1);
  EXPECT_GE(data.num_impossible, 3);
  EXPECT_FALSE(data.vehicles.at(0).start);
}

RC_GTEST_PROP(PlotData, TakesAnyNumbersAndTimes, ()) {
  const auto number =
      rc::gen::element(0.0, -1.0, 1e8, 1e308, -1e308, std::numeric_limits<double>::infinity(),
                       std::numeric_limits<double>::quiet_NaN(), 1e-320);
  std::vector<TestEvent> events;
  const auto count = *rc::gen::inRange(0, 30);
  for (int i = 0; i < count; ++i) {
    nav_t nav = PlottedNav(*rc::gen::arbitrary<int64_t>(), *number, *number, *number);
    nav.altitude_m = *number;
    nav.heading_deg = *number;
    nav.course_over_ground_deg = *number;
    nav.speed_over_ground_mps = *number;
    events.push_back(EventOf("NAV_" + std::to_string(i % 3), nav));
  }
  const PlotData data = DataOf(events);
  for (const VehicleCurves& vehicle : data.vehicles) {
    for (const ThinnedCurve* curve : {&vehicle.track, &vehicle.nearest_m, &vehicle.crab_deg}) {
      for (const Stroke& stroke : curve->Strokes()) {
        for (const CurvePoint& point : stroke) RC_ASSERT(std::abs(point.y) <= 1e9);
      }
    }
  }
}

}  // namespace shoal::plot_data_test
