#include "lib/tools/view/event_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "lib/mission/model/mission.h"
#include "lib/run/verdict/mission_verdict.h"

namespace shoal::event_watch_test {

constexpr int64_t kSecond = 1'000'000;

EventWatch TwoKayaks() { return EventWatch({{"alpha", 3}, {"bravo", 2}}); }

void Meet(EventWatch* watch, int64_t utime, double distance_m, double depth_m = 0) {
  watch->OnNav(0, utime, 10, 20, 0);
  watch->OnNav(1, utime, 10 + distance_m, 20, depth_m);
}

std::vector<EventKind> KindsOf(const EventWatch& watch) {
  std::vector<EventKind> kinds;
  for (const ViewEvent& event : watch.events()) kinds.push_back(event.kind);
  return kinds;
}

int64_t NumOf(const EventWatch& watch, EventKind kind) {
  const std::vector<EventKind> kinds = KindsOf(watch);
  return std::count(kinds.begin(), kinds.end(), kind);
}

TEST(EventWatch, FindsACollisionOncePerEncounter) {
  EventWatch watch = TwoKayaks();
  Meet(&watch, 1 * kSecond, 2.5);
  EXPECT_TRUE(watch.events().empty()) << "the mean of their lengths is not nearer than itself";
  Meet(&watch, 2 * kSecond, 2.4);
  Meet(&watch, 3 * kSecond, 2.6);
  Meet(&watch, 4 * kSecond, 2.4);
  ASSERT_EQ(watch.events().size(), 1U);
  EXPECT_EQ(watch.events()[0].kind, EventKind::kCollision);
  EXPECT_EQ(watch.events()[0].utime, 2 * kSecond);
  EXPECT_EQ(watch.events()[0].vehicles, (std::vector<std::string>{"alpha", "bravo"}));
  EXPECT_EQ(watch.events()[0].text, "alpha and bravo: 2.4 m, less than 2.5 m");
  Meet(&watch, 5 * kSecond, 5.1);
  Meet(&watch, 6 * kSecond, 1);
  EXPECT_EQ(watch.events().size(), 2U) << "they had parted";
}

TEST(EventWatch, FindsWhereAVehicleRunsAground) {
  EventWatch watch({{.name = "auv", .length_m = 1.6, .draught_m = 0},
                    {.name = "ship", .length_m = 50, .draught_m = 4},
                    {.name = "buoy", .length_m = 1}});
  for (size_t vehicle = 0; vehicle < 3; ++vehicle) {
    const double x_m = 100 * static_cast<double>(vehicle);
    watch.OnNav(vehicle, 1 * kSecond, x_m, 0, 0, 4.1);
    watch.OnNav(vehicle, 2 * kSecond, x_m, 0, 0, -1);
    watch.OnNav(vehicle, 3 * kSecond, x_m, 0, 0, vehicle == 0 ? 0 : 3);
    watch.OnNav(vehicle, 4 * kSecond, x_m, 0, 0, 0);
  }
  ASSERT_EQ(KindsOf(watch), (std::vector<EventKind>{EventKind::kAground, EventKind::kAground}));
  EXPECT_EQ(watch.events()[0].text, "auv: aground");
  EXPECT_EQ(watch.events()[1].text, "ship: aground");
  EXPECT_EQ(watch.events()[1].utime, 3 * kSecond);
}

TEST(EventWatch, LooksInThreeDimensions) {
  EventWatch watch = TwoKayaks();
  Meet(&watch, 1 * kSecond, 0, 2.6);
  EXPECT_TRUE(watch.events().empty());
  Meet(&watch, 2 * kSecond, 0, 2.4);
  EXPECT_EQ(watch.events().size(), 1U);
}

TEST(EventWatch, ComparesPositionsOfEqualTimesOnly) {
  EventWatch watch = TwoKayaks();
  watch.OnNav(0, 1 * kSecond, 0, 0, 0);
  watch.OnNav(1, 3 * kSecond, 0, 0, 0);
  watch.OnNav(0, 5 * kSecond, 0, 0, 0);
  watch.Finish();
  EXPECT_TRUE(watch.events().empty());
}

TEST(EventWatch, ComparesThoseThatAreThereWhereOthersAreSilent) {
  EventWatch watch({{"alpha", 3}, {"bravo", 3}, {"silent", 3}});
  Meet(&watch, 1 * kSecond, 1);
  EXPECT_TRUE(watch.events().empty()) << "the third may come yet";
  watch.Finish();
  EXPECT_EQ(watch.events().size(), 1U);
}

TEST(EventWatch, FindsAllPairsOfAFleet) {
  std::vector<WatchedVehicle> fleet;
  for (int i = 0; i < 60; ++i) fleet.push_back({"v" + std::to_string(i), i == 7 ? 20.0 : 1.0});
  EventWatch watch(fleet);
  for (size_t i = 0; i < fleet.size(); ++i) {
    watch.OnNav(i, kSecond, 5 * static_cast<double>(i), 0, 0);
  }
  ASSERT_EQ(watch.events().size(), 4U) << "the long one reaches two on either side";
  for (const ViewEvent& event : watch.events()) {
    EXPECT_TRUE(event.vehicles[0] == "v7" || event.vehicles[1] == "v7") << event.text;
  }
}

TEST(EventWatch, IgnoresPositionsThatAreNotFinite) {
  EventWatch watch = TwoKayaks();
  watch.OnNav(0, 1, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  watch.OnNav(1, 1, std::numeric_limits<double>::infinity(), 0, 0);
  watch.OnNav(2, 1, 0, 0, 0);
  watch.Finish();
  EXPECT_TRUE(watch.events().empty());
}

helm_state_t HelmAt(int64_t utime, const std::string& state, const std::string& all_stop) {
  helm_state_t helm{};
  helm.utime = utime;
  helm.state = state;
  helm.all_stop = all_stop;
  helm.waypoint_index = -1;
  return helm;
}

TEST(EventWatch, ReportsAllStopsAndTheirEnd) {
  EventWatch watch = TwoKayaks();
  watch.OnHelm(0, HelmAt(0, "PARK", "never deployed"));
  EXPECT_TRUE(watch.events().empty()) << "a parked vehicle is no event";
  watch.OnHelm(0, HelmAt(1 * kSecond, "DRIVE", "clear"));
  watch.OnHelm(0, HelmAt(2 * kSecond, "ALL-STOP", "all_stop command"));
  watch.OnHelm(0, HelmAt(3 * kSecond, "ALL-STOP", "all_stop command"));
  watch.OnHelm(0, HelmAt(4 * kSecond, "DRIVE", "clear"));
  watch.OnHelm(9, HelmAt(4 * kSecond, "ALL-STOP", "not there"));
  ASSERT_EQ(KindsOf(watch),
            (std::vector{EventKind::kDeployed, EventKind::kAllStop, EventKind::kCleared}));
  EXPECT_EQ(watch.events()[1].text, "alpha: by command");
  EXPECT_EQ(watch.events()[1].utime, 2 * kSecond);
  EXPECT_EQ(watch.events()[2].vehicles, std::vector<std::string>{"alpha"});
}

TEST(EventWatch, FollowsContactsInEitherDirection) {
  EventWatch watch = TwoKayaks();
  watch.SetStaleTime(5);
  watch.OnFate(0, 1, Cause::kOutOfRange, 0);
  EXPECT_TRUE(watch.events().empty());
  watch.OnFate(0, 1, Cause::kDelivered, 1 * kSecond);
  watch.OnFate(1, 0, Cause::kDamaged, 5 * kSecond);
  watch.OnFate(0, 1, Cause::kOutOfRange, 14'900'000);
  ASSERT_EQ(KindsOf(watch), std::vector{EventKind::kFirstContact});
  watch.OnTime(20 * kSecond);
  watch.OnFate(1, 0, Cause::kDelivered, 30 * kSecond);
  ASSERT_EQ(KindsOf(watch), (std::vector{EventKind::kFirstContact, EventKind::kLostContact,
                                         EventKind::kContactAgain}));
  EXPECT_EQ(watch.events()[1].utime, 15 * kSecond) << "when it was lost, not when it was noticed";
  EXPECT_EQ(watch.events()[1].text, "alpha and bravo: nothing received for 10.0 s");
  EXPECT_EQ(watch.events()[2].utime, 30 * kSecond);
}

TEST(EventWatch, WaitsTwiceTheStaleTimeWhereThatIsLonger) {
  EventWatch watch = TwoKayaks();
  watch.SetStaleTime(20);
  watch.OnFate(0, 1, Cause::kDelivered, 0);
  watch.OnTime(39 * kSecond);
  EXPECT_EQ(watch.events().size(), 1U);
  watch.OnTime(40 * kSecond);
  EXPECT_EQ(watch.events().size(), 2U);
}

TEST(EventWatch, TakesAShorterStaleTimeAtOnce) {
  EventWatch watch = TwoKayaks();
  watch.SetStaleTime(100);
  watch.OnFate(0, 1, Cause::kDelivered, 0);
  watch.SetStaleTime(std::numeric_limits<double>::quiet_NaN());
  watch.OnTime(10 * kSecond);
  EXPECT_EQ(watch.events().size(), 2U);
}

TEST(EventWatch, FindsTheSameLossHoweverOftenItIsAsked) {
  EventWatch seldom({{"a", 1}, {"b", 1}, {"c", 1}});
  EventWatch often = seldom;
  for (int64_t t = 0; t <= 60; ++t) {
    for (EventWatch* watch : {&seldom, &often}) {
      if (t <= 7) watch->OnFate(0, 2, Cause::kDelivered, t * kSecond);
      if (t <= 20) watch->OnFate(1, 2, Cause::kDelivered, t * kSecond);
    }
    often.OnTime(t * kSecond);
  }
  seldom.OnTime(60 * kSecond);
  ASSERT_EQ(often.events().size(), 4U);
  ASSERT_EQ(seldom.events().size(), 4U);
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(seldom.events()[i].utime, often.events()[i].utime);
  EXPECT_EQ(often.events()[2].utime, 17 * kSecond);
  EXPECT_EQ(often.events()[2].vehicles, (std::vector<std::string>{"a", "c"}));
}

TEST(EventWatch, NamesUnregisteredVehiclesAsGiven) {
  EventWatch watch = TwoKayaks();
  EXPECT_EQ(watch.num_names(), 2U);
  watch.SetName(2, "visitor");
  watch.OnFate(2, 1, Cause::kDelivered, 0);
  watch.OnFate(1, 1, Cause::kDelivered, 0);
  watch.OnFate(-1, 1, Cause::kDelivered, 0);
  watch.OnFate(1, 1'000'000'000, Cause::kDelivered, 0);
  ASSERT_EQ(watch.events().size(), 1U);
  EXPECT_EQ(watch.events()[0].vehicles, (std::vector<std::string>{"bravo", "visitor"}));
}

helm_state_t OnLeg(int64_t utime, int waypoint, int laps = 0, const std::string& task = "survey") {
  helm_state_t helm = HelmAt(utime, "DRIVE", "clear");
  helm.task = task;
  helm.waypoint_index = waypoint;
  helm.laps_done = laps;
  return helm;
}

TEST(EventWatch, ReportsEachWaypointThatIsReachedOnce) {
  EventWatch watch = TwoKayaks();
  watch.OnHelm(0, OnLeg(1 * kSecond, 0));
  watch.OnHelm(0, OnLeg(2 * kSecond, 0));
  EXPECT_EQ(NumOf(watch, EventKind::kWaypoint), 0) << "it is on its way";
  watch.OnHelm(0, OnLeg(3 * kSecond, 1));
  watch.OnHelm(0, OnLeg(4 * kSecond, 1));
  watch.OnHelm(0, OnLeg(5 * kSecond, 1, 1));
  watch.OnHelm(0, OnLeg(6 * kSecond, 0, 0, "home"));
  ASSERT_EQ(KindsOf(watch),
            (std::vector{EventKind::kDeployed, EventKind::kTask, EventKind::kWaypoint,
                         EventKind::kWaypoint, EventKind::kTask}));
  EXPECT_EQ(watch.events()[2].text, "alpha: waypoint 1 of survey reached");
  EXPECT_EQ(watch.events()[2].utime, 3 * kSecond);
  EXPECT_EQ(watch.events()[3].text, "alpha: waypoint 2 of survey reached") << "it ends the lap";
}

TEST(EventWatch, LeavesRoomForOtherEventsThanWaypoints) {
  EventWatch watch = TwoKayaks();
  for (int i = 0; i < 6000; ++i) watch.OnHelm(0, OnLeg(i, i));
  EXPECT_EQ(NumOf(watch, EventKind::kWaypoint), static_cast<int64_t>(EventWatch::kMaxArrivals));
  EXPECT_EQ(watch.num_left_out(), 2999);
}

TEST(EventWatch, KeepsABoundedNumberOfEvents) {
  EventWatch watch = TwoKayaks();
  for (int i = 0; i < 11'000; ++i) {
    watch.OnHelm(0, HelmAt(i, "ALL-STOP", "x"));
    watch.OnHelm(0, HelmAt(i, "DRIVE", "clear"));
  }
  EXPECT_EQ(watch.events().size(), EventWatch::kMaxEvents);
  EXPECT_EQ(watch.num_left_out(), 2000);
}

TEST(EventWatch, ReportsWhatAHelmBegins) {
  EventWatch watch = TwoKayaks();
  watch.OnHelm(0, HelmAt(0, "PARK", "never deployed"));
  helm_state_t helm = HelmAt(1 * kSecond, "DRIVE", "clear");
  helm.task = "survey";
  watch.OnHelm(0, helm);
  watch.OnHelm(0, helm);
  helm.utime = 2 * kSecond;
  helm.task = "home";
  watch.OnHelm(0, helm);
  watch.OnHelm(0, HelmAt(3 * kSecond, "PARK", "parked"));
  ASSERT_EQ(KindsOf(watch), (std::vector<EventKind>{EventKind::kDeployed, EventKind::kTask,
                                                    EventKind::kTask, EventKind::kParked}));
  EXPECT_EQ(watch.events()[0].text, "alpha: deployed");
  EXPECT_EQ(watch.events()[2].text, "alpha: task home");
}

TEST(EventWatch, ReportsADiverThatComesUp) {
  EventWatch watch({{.name = "auv", .length_m = 2, .draught_m = 0},
                    {.name = "boat", .length_m = 3, .draught_m = 0.3}});
  for (const double z_m : {0.1, 1.0, 0.1, 20.0, 0.3, 0.1}) {
    watch.OnNav(0, 1 * kSecond, 0, 0, z_m);
    watch.OnNav(1, 1 * kSecond, 90, 0, z_m);
  }
  ASSERT_EQ(KindsOf(watch), std::vector<EventKind>{EventKind::kSurfaced});
  EXPECT_EQ(watch.events()[0].text, "auv: at the surface");
}

TEST(EventWatch, ReportsAFixAfterThereWasNone) {
  EventWatch watch = TwoKayaks();
  navigation_t navigation{};
  navigation.has_gps_fix = 1;
  watch.OnNavigation(0, navigation);
  EXPECT_TRUE(watch.events().empty()) << "it had one from the start";
  navigation.has_gps_fix = 0;
  watch.OnNavigation(0, navigation);
  navigation.has_gps_fix = 1;
  watch.OnNavigation(0, navigation);
  watch.OnNavigation(0, navigation);
  EXPECT_EQ(KindsOf(watch), std::vector<EventKind>{EventKind::kFix});
}

TEST(EventWatch, ReportsAPartTowardAContactWhenItChanges) {
  EventWatch watch = TwoKayaks();
  helm_decision_t decision{};
  decision.utime = kSecond;
  decision.aims.resize(1);
  decision.aims[0].contact = "bravo";
  decision.aims[0].role = "stand-on";
  decision.aims[0].rule = "17";
  decision.aims[0].range_m = 48.2;
  watch.OnDecision(0, decision);
  decision.utime = 2 * kSecond;
  watch.OnDecision(0, decision);
  ASSERT_EQ(watch.events().size(), 1U);
  EXPECT_EQ(watch.events()[0].text, "alpha: stand-on toward bravo (rule 17), 48.2 m");
  EXPECT_EQ(watch.events()[0].vehicles, (std::vector<std::string>{"alpha", "bravo"}));
  decision.aims[0].role = "give-way:stern";
  watch.OnDecision(0, decision);
  EXPECT_EQ(watch.events().size(), 2U);
  decision.utime = 90 * kSecond;
  watch.OnDecision(0, decision);
  EXPECT_EQ(watch.events().size(), 3U) << "another encounter";
}

TEST(EventWatch, ReportsWhatBecameOfAMessage) {
  EventWatch watch = TwoKayaks();
  FateView fate{.facts = {.utime = kSecond, .number = 3, .kind = Kind::kMessage},
                .source = "alpha",
                .destination = "bravo"};
  watch.OnMessage(0, 1, fate);
  fate.facts.cause = Cause::kOutOfRange;
  fate.facts.range_m = 312.4F;
  fate.facts.limit_m = 250;
  watch.OnMessage(0, 1, fate);
  ASSERT_EQ(KindsOf(watch), (std::vector<EventKind>{EventKind::kMessage, EventKind::kMessageLost}));
  EXPECT_EQ(watch.events()[1].text,
            "message 3 of alpha to bravo: out of range, 312.4 m of 250.0 m");
  for (size_t i = 0; i < 2 * EventWatch::kMaxOfKind; ++i) watch.OnMessage(0, 1, fate);
  EXPECT_LE(watch.events().size(), EventWatch::kMaxOfKind + 1) << "others keep their room";
  EXPECT_GT(watch.num_left_out(), 0);
}

TEST(EventWatch, ReportsTheMissionsOwnEventsWhenTheyAreDue) {
  Mission mission;
  mission.start_utime = 100 * kSecond;
  mission.vehicles.emplace_back().name = "alpha";
  mission.events = {{.at_s = 10, .what = CommandEvent{"alpha", "deploy", "", {}}},
                    {.at_s = 20, .what = CommandEvent{"all", "all_stop", "", {}}}};
  EventWatch watch(WatchedVehiclesOf(mission), PlannedEventsOf(mission));
  watch.OnTime(109 * kSecond);
  EXPECT_TRUE(watch.events().empty());
  watch.OnTime(115 * kSecond);
  ASSERT_EQ(KindsOf(watch), std::vector<EventKind>{EventKind::kMission});
  EXPECT_EQ(watch.events()[0].utime, 110 * kSecond) << "also where it is noticed later";
  EXPECT_EQ(watch.events()[0].text, "deploy to alpha");
  watch.OnTime(500 * kSecond);
  EXPECT_EQ(watch.events().at(1).text, "all_stop to all");
  EXPECT_TRUE(watch.events().at(1).vehicles.empty());
}

TEST(EventsOf, HasEachExpectationAtTheEnd) {
  const auto events =
      EventsOf({.result = "FAIL",
                .end_s = 60,
                .lines = {{.passed = true, .text = "no two closer", .numbers = "7.2 m"},
                          {.passed = false, .text = "alpha there", .numbers = "never"}}},
               100 * kSecond);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].utime, 160 * kSecond);
  EXPECT_EQ(events[0].text, "met: no two closer: 7.2 m");
  EXPECT_EQ(events[1].kind, EventKind::kMissed);
}

TEST(EventWatch, KeepsWhereUpdatesAndOrdersMoveAPlan) {
  BehaviorOptions behavior;
  behavior.name = "loiter_a";
  behavior.updates = "UPDATES";
  behavior.what = WaypointOptions();
  const std::vector<Task> tasks = {{.name = "way", .what = WaypointsTask{.points_m = {{0, 0}}}}};
  EventWatch watch({{.name = "alpha", .length_m = 3, .plan = PlanWatch({behavior}, tasks)}});
  helm_decision_t decision{};
  decision.utime = 5 * kSecond;
  decision.events = {"mode: ACTIVE", "update: loiter_a: points = 1,2:3,4",
                     "update: other: points = 1,2"};
  decision.num_events = 3;
  watch.OnDecision(0, decision);
  ASSERT_EQ(NumOf(watch, EventKind::kReplanned), 1);
  EXPECT_EQ(watch.events()[0].text, "alpha: update: loiter_a: points = 1,2:3,4");
  EXPECT_NE(watch.events()[0].plan.find(R"("points":[[1,2],[3,4]])"), std::string::npos)
      << watch.events()[0].plan;
  watch.OnDecision(0, decision);
  EXPECT_EQ(NumOf(watch, EventKind::kReplanned), 1) << "nothing lies elsewhere by it";

  helm_command_t command{};
  command.command = "move";
  command.argument = "way";
  command.values = {7, 8};
  command.num_values = 2;
  watch.OnCommand(0, command, 6 * kSecond);
  ASSERT_EQ(NumOf(watch, EventKind::kReplanned), 2);
  EXPECT_NE(watch.events()[1].plan.find(R"({"name":"way","parts":[)"), std::string::npos);
  command.values = {7};
  command.num_values = 1;
  watch.OnCommand(0, command, 7 * kSecond);
  watch.OnCommand(9, command, 7 * kSecond);
  EXPECT_EQ(NumOf(watch, EventKind::kReplanned), 2) << "what a helm refuses moves nothing";
}

}  // namespace shoal::event_watch_test
