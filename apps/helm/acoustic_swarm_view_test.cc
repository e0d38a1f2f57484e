// What a helm knows of its swarm by the acoustic network.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "apps/helm/swarm_testing.h"
#include "lib/base/time/seconds.h"

namespace shoal::acoustic_swarm_view_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The same swarm, which knows of each other by the acoustic network.
Mission AcousticSwarm() {
  Mission mission = Swarm();
  for (Vehicle& vehicle : mission.vehicles) {
    for (Task& task : vehicle.tasks) {
      std::get<TargetTrackTask>(task.what).swarm = SwarmKnowledge::kAcoustic;
    }
  }
  mission.swarms = {
      {.leader = "alpha", .followers = {"bravo", "charlie", "delta"}, .silent_after_s = 20}};
  return mission;
}

swarm_contact_t ContactOf(const std::string& name, double x_m, double x_mps, int64_t report_utime) {
  swarm_contact_t contact{};
  contact.name = name;
  contact.is_heard = contact.is_known = 1;
  contact.x_m = x_m;
  contact.x_mps = x_mps;
  contact.report_utime = contact.heard_utime = report_utime;
  return contact;
}

swarm_t SwarmWith(const std::vector<swarm_contact_t>& contacts) {
  swarm_t swarm{};
  swarm.contacts = contacts;
  swarm.num_contacts = static_cast<int32_t>(contacts.size());
  return swarm;
}

nav_t OwnAt(int64_t utime) {
  nav_t own = At(0, 0);
  own.utime = utime;
  return own;
}

TEST(AcousticSwarmView, SubscribesToNoNav) {
  const Mission mission = AcousticSwarm();
  EXPECT_TRUE(SwarmView(mission, mission.vehicles[1]).names().empty());
}

TEST(AcousticSwarmView, PredictsEveryMemberFromTheTimeOfItsReport) {
  const Mission mission = AcousticSwarm();
  SwarmView view(mission, mission.vehicles[1]);
  swarm_contact_t leader = ContactOf("alpha", 100, 2, 1'000'000);
  leader.is_target = leader.has_next = 1;
  leader.next_x_m = 104;
  leader.next_x_mps = 2;
  view.OnSwarm(SwarmWith({leader, ContactOf("charlie", 50, 1, 3'000'000)}));
  const Surroundings* seen = view.Look(&mission.vehicles[1].tasks[0], OwnAt(4'000'000));
  ASSERT_TRUE(seen != nullptr && seen->target.has_value());
  EXPECT_NEAR(seen->target->position_m.x(), 106, 1e-9) << "3 s at 2 m/s, past its waypoint";
  ASSERT_EQ(seen->group.size(), 1U);
  EXPECT_NEAR(seen->group[0].position_m.x(), 51, 1e-9);
}

/// bravo's view after alpha's second report put it 30 m north of where it was expected, at 10 s.
SwarmView AfterNews(const Mission& mission) {
  SwarmView view(mission, mission.vehicles[1]);
  const Task* task = &mission.vehicles[1].tasks[0];
  view.OnSwarm(SwarmWith({ContactOf("alpha", 100, 2, 0)}));
  EXPECT_NEAR(view.Look(task, OwnAt(10'000'000))->target->position_m.x(), 120, 1e-9);
  swarm_contact_t news = ContactOf("alpha", 120, 2, 10'000'000);
  news.y_m = 30;
  view.OnSwarm(SwarmWith({news}));
  return view;
}

TEST(AcousticSwarmView, MovesTheTargetToWhereNewsPutsItAtABoundedSpeed) {
  Mission mission = AcousticSwarm();
  std::get<TargetTrackTask>(mission.vehicles[1].tasks[0].what).smoothing_mps = 1.5;
  SwarmView view = AfterNews(mission);
  const Task* task = &mission.vehicles[1].tasks[0];
  double before_m = 0;
  for (int64_t utime = 10'100'000; utime < 31'000'000; utime += 100'000) {
    const Neighbour target = *view.Look(task, OwnAt(utime))->target;
    const double elapsed_s = Seconds(utime - 10'000'000);
    EXPECT_NEAR(target.position_m.x(), 120 + 2 * elapsed_s, 1e-6);
    // The first look after the news comes with the way of a step still to go.
    EXPECT_NEAR(target.position_m.y(), std::min(30.0, 1.5 * (elapsed_s - 0.1)), 1e-6);
    EXPECT_LE(target.position_m.y() - before_m, 0.15 + 1e-9);
    before_m = target.position_m.y();
  }
  EXPECT_EQ(before_m, 30);
}

TEST(AcousticSwarmView, TakesNewsAtOnceWithoutSmoothing) {
  Mission mission = AcousticSwarm();
  std::get<TargetTrackTask>(mission.vehicles[1].tasks[0].what).smoothing_mps = 0;
  SwarmView view = AfterNews(mission);
  EXPECT_EQ(view.Look(&mission.vehicles[1].tasks[0], OwnAt(10'100'000))->target->position_m.y(),
            30);
}

TEST(AcousticSwarmView, TakesNewsAtOnceWhenItBeginsToFollow) {
  const Mission mission = AcousticSwarm();
  SwarmView view = AfterNews(mission);
  const Task* task = &mission.vehicles[1].tasks[0];
  EXPECT_EQ(view.Look(task, OwnAt(13'000'000))->target->position_m.y(), 30) << "after a pause";
}

TEST(AcousticSwarmView, KnowsNoMemberOfWhichItReceivedNothing) {
  const Mission mission = AcousticSwarm();
  SwarmView view(mission, mission.vehicles[1]);
  TakeNav(&view, "alpha", At(1, 2));  // The truth counts for nothing here.
  swarm_contact_t unknown = ContactOf("charlie", 50, 1, 0);
  unknown.is_known = 0;
  view.OnSwarm(SwarmWith({unknown, ContactOf("outsider", 1, 1, 0)}));
  const Surroundings* seen = view.Look(&mission.vehicles[1].tasks[0], OwnAt(0));
  EXPECT_FALSE(seen->target.has_value());
  EXPECT_TRUE(seen->group.empty());
}

TEST(AcousticSwarmView, CallsATargetSilentOfWhichNothingWasReceivedForTooLong) {
  const Mission mission = AcousticSwarm();
  SwarmView view(mission, mission.vehicles[1]);
  view.OnSwarm(SwarmWith({ContactOf("alpha", 100, 2, 0)}));
  const Task* task = &mission.vehicles[1].tasks[0];
  EXPECT_FALSE(view.Look(task, OwnAt(20'000'000))->target_is_silent);
  EXPECT_TRUE(view.Look(task, OwnAt(20'000'001))->target_is_silent);
}

TEST(AcousticSwarmView, CallsATargetSilentThatWasHeardAtTheEarliestTimeThereIs) {
  const Mission mission = AcousticSwarm();
  SwarmView view(mission, mission.vehicles[1]);
  view.OnSwarm(SwarmWith({ContactOf("alpha", 100, 2, std::numeric_limits<int64_t>::min())}));
  EXPECT_TRUE(view.Look(&mission.vehicles[1].tasks[0], OwnAt(1))->target_is_silent);
}

TEST(AcousticSwarmView, CallsATargetSilentAlsoWhereItsLastReportCannotBeUsed) {
  const Mission mission = AcousticSwarm();
  SwarmView view(mission, mission.vehicles[1]);
  swarm_contact_t unusable = ContactOf("alpha", 0, 0, 0);
  unusable.is_known = 0;
  view.OnSwarm(SwarmWith({unusable}));
  const Surroundings* seen = view.Look(&mission.vehicles[1].tasks[0], OwnAt(30'000'000));
  EXPECT_FALSE(seen->target.has_value());
  EXPECT_TRUE(seen->target_is_silent);
}

TEST(AcousticSwarmView, PassesOverInvalidContacts) {
  const Mission mission = AcousticSwarm();
  SwarmView view(mission, mission.vehicles[1]);
  view.OnSwarm(SwarmWith({ContactOf("alpha", kNan, 2, 0)}));
  swarm_contact_t leader = ContactOf("alpha", 0, 0, 0);
  leader.next_y_mps = kNan;
  view.OnSwarm(SwarmWith({leader}));
  EXPECT_FALSE(view.Look(&mission.vehicles[1].tasks[0], OwnAt(0))->target.has_value());
  view.OnSwarm(SwarmWith({ContactOf("alpha", 5, 0, INT64_MIN)}));
  const Surroundings* seen = view.Look(&mission.vehicles[1].tasks[0], OwnAt(1'000'000));
  EXPECT_TRUE(seen->target->position_m.allFinite());
}

}  // namespace shoal::acoustic_swarm_view_test
