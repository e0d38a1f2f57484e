// Two or three acomms on one bus, and a test that carries their packets.
#include "apps/acomms/acomms_app.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/comms/swarm/broadcast_message.h"

namespace shoal::acomms_app_test {

constexpr int64_t kTick_us = 100'000;

Mission TwoInFdma() {
  Mission mission;
  mission.acoustics.is_used = true;
  mission.acoustics.crc = false;
  int address = 1;
  for (const std::string name : {"alpha", "bravo", "charlie"}) {
    Vehicle vehicle;
    vehicle.name = name;
    vehicle.acoustic_address = address++;
    vehicle.reporter = Provider::kHand;  // The broker is taken to know it from the start.
    vehicle.start = {.x_m = 100.0 * address, .heading_deg = 90, .speed_mps = 1};
    mission.vehicles.push_back(vehicle);
  }
  mission.swarms.resize(1);
  mission.swarms[0].leader = "alpha";
  mission.swarms[0].followers = {"bravo"};
  return mission;
}

/// The acomms of all members of a swarm. What one sends reaches all others in the next step but
/// one, as the broker would have it without loss and travel time; unless the test takes it away.
class Members {
 public:
  explicit Members(const Mission& mission) : mission_(mission) {
    Subscribe(world_, channels::AcousticTx(), [this](const acoustic_tx_t& packet) {
      sent_.push_back(packet);
      if (in_air_is_quiet_) return;
      for (const Vehicle& vehicle : mission_.vehicles) {
        if (vehicle.name != packet.source) Hand(vehicle.name, packet.source, packet.payload);
      }
    });
    for (const Vehicle& vehicle : mission_.vehicles) {
      if (mission_.SwarmOf(vehicle) != nullptr) Start(vehicle);
    }
  }

  void Start(const Vehicle& vehicle) {
    // A restarted process joins under a new name, since a name can join the bus once.
    Bus& bus = hub_.Join("acomms_" + vehicle.name + std::to_string(num_started_++));
    Subscribe(
        world_, channels::Swarm(vehicle.name),
        [this, name = vehicle.name](const swarm_t& swarm) { swarms_[name].push_back(swarm); });
    Subscribe(
        world_, channels::Acomms(vehicle.name),
        [this, name = vehicle.name](const acomms_t& record) { records_[name].push_back(record); });
    apps_[vehicle.name] = {&bus, std::make_unique<AcommsApp>(mission_, vehicle, bus)};
  }

  void Hand(const std::string& to, const std::string& from, const std::vector<uint8_t>& bytes) {
    acoustic_rx_t packet{};
    packet.utime = utime_;
    packet.source = from;
    packet.payload = bytes;
    packet.num_bytes = static_cast<int32_t>(bytes.size());
    Publish(world_, channels::AcousticRx(to), packet);
  }
  void PublishNav(const std::string& vehicle, double x_m, double y_m) {
    nav_t nav{};
    nav.utime = utime_;
    nav.x_m = x_m;
    nav.y_m = y_m;
    nav.z_m = 10;
    nav.speed_over_ground_mps = 1;
    nav.course_over_ground_deg = 90;
    Publish(world_, channels::Nav(vehicle), nav);
  }

  void Run(double seconds, bool with_nav = true) {
    const auto num_steps = static_cast<int>(seconds * 1e6 / kTick_us + 0.5);
    for (int i = 0; i < num_steps; ++i) {
      for (const Vehicle& vehicle : mission_.vehicles) {
        const double x_m = vehicle.start.x_m + Seconds(utime_);
        if (with_nav) PublishNav(vehicle.name, x_m, 0);
      }
      if (before_step_) before_step_(utime_, world_);
      hub_.NextStep();
      for (auto& [name, app] : apps_) hub_.Handle(*app.first);
      for (auto& [name, app] : apps_) app.second->Tick(utime_);
      hub_.NextStep();
      hub_.Handle(world_);
      utime_ += kTick_us;
    }
  }

  std::vector<int64_t> TimesOf(const std::string& source) const {
    std::vector<int64_t> times;
    for (const acoustic_tx_t& packet : sent_) {
      if (packet.source == source) times.push_back(packet.utime / kTick_us);
    }
    return times;
  }
  const swarm_t& LastOf(const std::string& vehicle) { return swarms_[vehicle].back(); }
  AcommsApp& app(const std::string& vehicle) { return *apps_.at(vehicle).second; }

  bool in_air_is_quiet_ = false;
  std::function<void(int64_t utime, Bus& world)> before_step_;
  std::vector<acoustic_tx_t> sent_;
  std::map<std::string, std::vector<swarm_t>> swarms_;
  std::map<std::string, std::vector<acomms_t>> records_;

 private:
  Mission mission_;
  MemoryBus hub_;
  Bus& world_ = hub_.Join("world");
  std::map<std::string, std::pair<Bus*, std::unique_ptr<AcommsApp>>> apps_;
  int num_started_ = 0;
  int64_t utime_ = 0;
};

TEST(Acomms, SendsOnceInEachEpisodeInItsSlot) {
  Members members(TwoInFdma());
  members.Run(11);
  EXPECT_EQ(members.TimesOf("alpha"), (std::vector<int64_t>{0, 50, 100}));
  EXPECT_EQ(members.TimesOf("bravo"), (std::vector<int64_t>{5, 55, 105}));
  EXPECT_TRUE(DecodeLeaderReport(members.sent_[0].payload));
  EXPECT_TRUE(DecodeReport(members.sent_[1].payload));
}

TEST(Acomms, PublishesForItsHelmWhatTheLeaderSent) {
  Members members(TwoInFdma());
  members.Run(0.1);
  ASSERT_EQ(members.LastOf("bravo").num_contacts, 1);
  const swarm_contact_t before = members.LastOf("bravo").contacts[0];
  EXPECT_EQ(before.name, "alpha");
  EXPECT_TRUE(before.is_target);
  EXPECT_FALSE(before.is_heard);
  EXPECT_TRUE(before.is_known) << "the mission names its start";
  EXPECT_EQ(before.x_m, 200);

  members.Run(1);
  const swarm_contact_t after = members.LastOf("bravo").contacts[0];
  EXPECT_TRUE(after.is_heard);
  EXPECT_EQ(after.report_utime, 0);
  EXPECT_EQ(after.x_m, 200);
  EXPECT_EQ(after.x_mps, 1);
  EXPECT_TRUE(after.has_next);
  EXPECT_EQ(after.num_recovered, 0);
}

TEST(Acomms, ReportsTheSpeedAtTheNextWaypointByTheRateOfALeadersRevolutions) {
  for (const double rate_rpmps : {0.0, 10.0}) {
    Mission mission = TwoInFdma();
    mission.vehicles[0].model =
        Remus100Options{.parameters = "munet", .max_propeller_rate_rpmps = rate_rpmps};
    Members members(mission);
    members.before_step_ = [&](int64_t utime, Bus& world) {
      helm_state_t helm{};
      helm.waypoint_index = 0;
      helm.waypoint_x_m = 300;
      helm.waypoint_z_m = 10;
      Publish(world, channels::HelmState("alpha"), helm);
      actuators_t actuators{};
      actuators.utime = utime;
      actuators.propeller_rpm = 500 + 1e-5 * static_cast<double>(utime);
      Publish(world, channels::Actuators("alpha"), actuators);
    };
    members.Run(6);
    const std::optional<LeaderMessage> report = DecodeLeaderReport(members.sent_[2].payload);
    ASSERT_TRUE(report);
    const LeaderMotion& leader = report->leader;
    // 95 m to go at 1 m/s, and n = 10 rpm/s on muNet's map.
    const double squared = 1 + 2 * 0.0016922 * rate_rpmps * (300 - leader.position_m.x());
    EXPECT_NEAR(leader.next_velocity_mps.norm(), std::sqrt(squared), 1e-5) << rate_rpmps;
  }
}

TEST(Acomms, CountsWhatBecameOfEachSendersPackets) {
  Members members(TwoInFdma());
  members.Run(1);
  members.Hand("bravo", "charlie", {1, 2, 3});
  members.Hand("bravo", "outsider", {});
  members.Run(0.2);
  const swarm_t& swarm = members.LastOf("bravo");
  ASSERT_EQ(swarm.num_sources, 3);
  EXPECT_EQ(swarm.sources[0].name, "alpha");
  EXPECT_EQ(swarm.sources[0].clean, 1);
  EXPECT_EQ(swarm.sources[1].name, "charlie");
  EXPECT_EQ(swarm.sources[1].rejected, 1);
  EXPECT_EQ(swarm.sources[2].name, SwarmWriter::kOthers);
  int64_t rejected = 0;
  for (const swarm_count_t& count : swarm.counts) {
    if (count.outcome == "rejected") rejected += count.count;
  }
  EXPECT_EQ(rejected, 2);
  EXPECT_NE(members.app("bravo").Status().text.find("rejected 2 times"), std::string::npos)
      << members.app("bravo").Status().text;
}

TEST(Acomms, ReportsWhichFieldsWereDamagedAndHowTheyWereRecovered) {
  Mission mission = TwoInFdma();
  Members members(mission);
  members.Run(1);
  LeaderMessage damaged = *DecodeLeaderReport(members.sent_[0].payload);
  damaged.time_stamp_s = 0.9F;
  damaged.leader.position_m.x() = std::numeric_limits<float>::quiet_NaN();
  members.Hand("bravo", "alpha", EncodeLeaderReport(damaged));
  members.Run(0.2);
  const swarm_contact_t& contact = members.LastOf("bravo").contacts[0];
  EXPECT_EQ(contact.recovered, (std::vector<std::string>{"leader_pos predict"}));
  EXPECT_NEAR(contact.x_m, 200.9, 0.01) << "where it was, and its speed since";
  EXPECT_EQ(members.LastOf("bravo").sources[0].recovered, 1);
}

TEST(Acomms, RecordsWhichFieldWasDamagedAndWhatWasWrongWithIt) {
  Members members(TwoInFdma());
  members.Run(1);
  ASSERT_EQ(members.records_["bravo"].size(), 1U) << "once, as nothing changed since";
  LeaderMessage damaged = *DecodeLeaderReport(members.sent_[0].payload);
  damaged.time_stamp_s = 0.9F;
  damaged.leader.position_m.x() = 2e5F;
  members.Hand("bravo", "alpha", EncodeLeaderReport(damaged));
  members.Hand("bravo", "charlie", {1, 2});
  members.Run(0.2);
  ASSERT_EQ(members.records_["bravo"].size(), 2U);
  const acomms_t& record = members.records_["bravo"].back();
  ASSERT_EQ(record.num_events, 2);
  EXPECT_EQ(record.events[0].outcome, "recovered");
  EXPECT_EQ(record.events[0].source, "alpha");
  EXPECT_EQ(record.events[0].field, "leader_pos");
  EXPECT_EQ(record.events[0].fault, "farther than the limit");
  EXPECT_EQ(record.events[0].by, "predict");
  EXPECT_EQ(record.events[1].outcome, "rejected");
  EXPECT_EQ(record.events[1].reason, "shorter than a flag");
  EXPECT_NE(members.app("bravo").Status().text.find("message of alpha recovered: leader_pos is "
                                                    "farther than the limit, by predict"),
            std::string::npos)
      << members.app("bravo").Status().text;
}

TEST(Acomms, RecordsWhichFieldIsBeyondRecovery) {
  Mission mission = TwoInFdma();
  mission.vehicles[1].recovery.of(SwarmField::kLeaderPos) = {RecoveryStrategy::kSkip};
  Members members(mission);
  members.Run(1);
  LeaderMessage damaged = *DecodeLeaderReport(members.sent_[0].payload);
  damaged.leader.position_m.x() = std::numeric_limits<float>::quiet_NaN();
  members.Hand("bravo", "alpha", EncodeLeaderReport(damaged));
  members.Run(0.2);
  const acomms_t& record = members.records_["bravo"].back();
  ASSERT_EQ(record.num_events, 1);
  EXPECT_EQ(record.events[0].reason, "damaged beyond recovery");
  EXPECT_EQ(record.events[0].field, "leader_pos");
  EXPECT_EQ(record.events[0].fault, "not a finite number");
}

TEST(Acomms, RecordsAnswersAndFramesOfTheOthersAndItsUnusedSlots) {
  Mission mission = TwoInFdma();
  mission.acoustics.options.access_mode = AccessMode::kTdmaLf;
  mission.swarms[0].frames = true;
  Members members(mission);
  members.Run(4);
  ASSERT_EQ(members.records_["alpha"].back().num_members, 1);
  const acomms_member_t& bravo = members.records_["alpha"].back().members[0];
  EXPECT_EQ(bravo.name, "bravo");
  EXPECT_FALSE(members.records_["alpha"].front().members[0].has_answered);
  EXPECT_TRUE(std::any_of(members.records_["alpha"].begin(), members.records_["alpha"].end(),
                          [](const acomms_t& each) { return each.members[0].has_answered != 0; }));
  EXPECT_EQ(bravo.frames_received, static_cast<int64_t>(members.TimesOf("bravo").size()));
  EXPECT_GE(bravo.frames_received, 1);
  members.Run(20, false);
  EXPECT_GE(members.records_["alpha"].back().num_without_nav, 1);
}

TEST(Acomms, ChecksByTheLimitsOfItsMission) {
  Mission mission = TwoInFdma();
  mission.swarms[0].limits.max_position_m = 150;
  mission.swarms[0].neutral.position_m = {5, 6, 7};
  mission.vehicles[1].recovery.of(SwarmField::kLeaderPos) = {RecoveryStrategy::kNeutral};
  mission.vehicles[0].start.x_m = 100;
  Members members(mission);
  members.Run(1);
  LeaderMessage far = *DecodeLeaderReport(members.sent_[0].payload);
  far.time_stamp_s = 0.9F;
  far.leader.position_m.x() = 151;
  members.Hand("bravo", "alpha", EncodeLeaderReport(far));
  members.Run(0.2);
  const swarm_contact_t& contact = members.LastOf("bravo").contacts[0];
  EXPECT_EQ(contact.recovered, std::vector<std::string>{"leader_pos neutral"});
  EXPECT_EQ(contact.x_m, 5);
}

TEST(Acomms, MarksWhatIsNotKnownByTheSentinelOfItsMission) {
  Mission mission = TwoInFdma();
  mission.swarms[0].sentinel.position_m = 2e6;
  mission.vehicles[1].recovery.of(SwarmField::kLeaderPos) = {RecoveryStrategy::kSentinel};
  Members members(mission);
  members.Run(1);
  EXPECT_TRUE(members.LastOf("bravo").contacts[0].is_known);
  LeaderMessage damaged = *DecodeLeaderReport(members.sent_[0].payload);
  damaged.time_stamp_s = 0.9F;
  damaged.leader.position_m.x() = std::numeric_limits<float>::quiet_NaN();
  members.Hand("bravo", "alpha", EncodeLeaderReport(damaged));
  members.Run(0.2);
  EXPECT_FALSE(members.LastOf("bravo").contacts[0].is_known);
}

TEST(Acomms, FollowsTheRecoveryPlanOfItsVehicle) {
  Mission mission = TwoInFdma();
  mission.vehicles[1].recovery.of(SwarmField::kLeaderPos) = {RecoveryStrategy::kSkip};
  Members members(mission);
  members.Run(1);
  LeaderMessage damaged = *DecodeLeaderReport(members.sent_[0].payload);
  damaged.leader.position_m.x() = std::numeric_limits<float>::quiet_NaN();
  members.Hand("bravo", "alpha", EncodeLeaderReport(damaged));
  members.Run(0.2);
  EXPECT_EQ(members.LastOf("bravo").sources[0].rejected, 1);
}

TEST(Acomms, ShowsWhichMembersHaveBeenSilentForLong) {
  Mission mission = TwoInFdma();
  mission.swarms[0].silent_after_s = 7;
  Members members(mission);
  members.Run(5.5);
  members.in_air_is_quiet_ = true;
  members.Run(5);
  EXPECT_FALSE(members.LastOf("bravo").contacts[0].is_silent);
  members.Run(5);
  EXPECT_TRUE(members.LastOf("bravo").contacts[0].is_silent);
  EXPECT_NE(members.app("bravo").Status().text.find("silent"), std::string::npos);
}

TEST(Acomms, KeepsTheFirstSlotForTheFirstNav) {
  for (const AccessMode mode : {AccessMode::kFdma, AccessMode::kTdma, AccessMode::kTdmaLf}) {
    Mission mission = TwoInFdma();
    mission.acoustics.options.access_mode = mode;
    Members members(mission);
    members.Run(0.1, false);
    EXPECT_TRUE(members.sent_.empty());
    members.Run(1);
    ASSERT_FALSE(members.TimesOf("alpha").empty());
    EXPECT_EQ(members.TimesOf("alpha")[0], 1) << "in the step of its first NAV";
    EXPECT_TRUE(members.app("alpha").Status().run_warnings.empty());
  }
}

TEST(Acomms, HasAnAnswerToARequestThatWasKept) {
  Mission mission = TwoInFdma();
  mission.acoustics.options.access_mode = AccessMode::kTdmaLf;
  Members members(mission);
  members.Run(0.1, false);
  members.Run(5);
  ASSERT_GE(members.TimesOf("alpha").size(), 2U);
  ASSERT_FALSE(members.TimesOf("bravo").empty());
  EXPECT_LT(members.TimesOf("bravo")[0], members.TimesOf("alpha")[1]);
  EXPECT_TRUE(members.LastOf("alpha").contacts[0].is_heard);
}

TEST(Acomms, KeepsTheFirstSlotForTheFirstReports) {
  Mission mission = TwoInFdma();
  for (Vehicle& vehicle : mission.vehicles) vehicle.reporter = Provider::kShoal;
  Members members(mission);
  members.Run(6);
  EXPECT_EQ(members.TimesOf("alpha"), (std::vector<int64_t>{5, 50})) << "reports at 2 Hz";
  EXPECT_EQ(members.TimesOf("bravo"), (std::vector<int64_t>{5, 55}));
}

TEST(Acomms, AsksForLaterAnswersWhereItAsksLater) {
  Mission mission = TwoInFdma();
  mission.acoustics.options.access_mode = AccessMode::kTdmaLf;
  for (Vehicle& vehicle : mission.vehicles) vehicle.reporter = Provider::kShoal;
  Members members(mission);
  members.Run(8);
  ASSERT_GE(members.TimesOf("alpha").size(), 2U);
  EXPECT_EQ(members.TimesOf("alpha")[0], 5);
  const auto first = DecodeBroadcast(members.sent_[0].payload);
  ASSERT_TRUE(first);
  ASSERT_GE(members.TimesOf("bravo").size(), 2U);
  EXPECT_NEAR(first->response_start_s, 0.1 * static_cast<double>(members.TimesOf("bravo")[0]),
              1e-3);
  EXPECT_EQ(members.TimesOf("bravo")[1] - members.TimesOf("bravo")[0],
            members.TimesOf("alpha")[1] - 5);
}

TEST(Acomms, LetsASlotPassWhoseNavComesTooLate) {
  Members members(TwoInFdma());
  members.Run(1.1, false);
  members.Run(0.5);
  EXPECT_TRUE(members.TimesOf("alpha").empty());
  EXPECT_EQ(members.TimesOf("bravo"), (std::vector<int64_t>{11})) << "its slot came at 0.5 s";
}

TEST(Acomms, KeepsNoSlotOnceNavHasCome) {
  Members members(TwoInFdma());
  members.Run(1);
  members.Run(4.3, false);
  members.Run(4.7);
  EXPECT_EQ(members.TimesOf("alpha"), (std::vector<int64_t>{0}))
      << "NAV was older than two seconds at 5 s";
}

TEST(Acomms, LetsSlotsPassWithoutNav) {
  Members members(TwoInFdma());
  members.Run(6.1, false);
  EXPECT_TRUE(members.sent_.empty());
  EXPECT_FALSE(members.app("alpha").Status().run_warnings.empty());
  members.Run(5);
  EXPECT_EQ(members.TimesOf("alpha"), (std::vector<int64_t>{100}));
  EXPECT_TRUE(members.app("alpha").Status().run_warnings.empty());
}

TEST(Acomms, AnswersARequestInItsSlotAndTheLeaderReceivesIt) {
  Mission mission = TwoInFdma();
  mission.acoustics.options.access_mode = AccessMode::kTdmaLf;
  mission.swarms[0].followers = {"charlie", "bravo"};
  Members members(mission);
  members.Run(10);
  const std::vector<int64_t> alpha = members.TimesOf("alpha");
  const std::vector<int64_t> bravo = members.TimesOf("bravo");
  const std::vector<int64_t> charlie = members.TimesOf("charlie");
  ASSERT_GE(alpha.size(), 2U);
  ASSERT_FALSE(bravo.empty());
  ASSERT_FALSE(charlie.empty());
  EXPECT_TRUE(DecodeBroadcast(members.sent_[0].payload));
  EXPECT_LT(alpha[0], charlie[0]);
  EXPECT_LT(charlie[0], bravo[0]) << "in the order of [swarm] followers";
  EXPECT_LT(bravo[0], alpha[1]) << "all within the episode";
  const swarm_t& leader = members.LastOf("alpha");
  ASSERT_EQ(leader.num_contacts, 2);
  EXPECT_TRUE(leader.contacts[0].is_heard);
  EXPECT_TRUE(leader.contacts[1].is_heard);
  EXPECT_GT(members.LastOf("bravo").contacts[1].report_utime, 0)
      << "bravo knows of charlie by the leader's second request";
}

TEST(Acomms, ThatIsStartedAgainGoesOnWithItsNextSlot) {
  const Mission mission = TwoInFdma();
  Members members(mission);
  members.Run(12);
  members.Start(mission.vehicles[1]);
  members.Run(10);
  EXPECT_EQ(members.TimesOf("bravo"), (std::vector<int64_t>{5, 55, 105, 155, 205}));
  EXPECT_TRUE(members.LastOf("bravo").contacts[0].is_heard);
}

TEST(Acomms, ThatIsStartedAgainTakesWhatCameBeforeItsFirstStepAtThatStepsTime) {
  const Mission mission = TwoInFdma();
  Members members(mission);
  members.Run(50);
  const std::vector<uint8_t> report = [&] {
    for (auto it = members.sent_.rbegin(); it != members.sent_.rend(); ++it) {
      if (it->source == "alpha") return it->payload;
    }
    return std::vector<uint8_t>();
  }();
  members.in_air_is_quiet_ = true;
  members.Start(mission.vehicles[1]);
  members.Hand("bravo", "alpha", report);
  members.Run(0.1);
  const swarm_contact_t& contact = members.LastOf("bravo").contacts[0];
  EXPECT_TRUE(contact.is_heard);
  EXPECT_EQ(contact.heard_utime, 50'000'000);
  EXPECT_EQ(contact.report_utime, 45'000'000) << "as in its time stamp";
  EXPECT_EQ(contact.num_recovered, 0);
  EXPECT_FALSE(contact.is_silent);
}

TEST(Acomms, SendsNoNextWaypointThatIsASentinel) {
  Mission mission = TwoInFdma();
  mission.vehicles[1].recovery.of(SwarmField::kLeaderNextPos) = {RecoveryStrategy::kSentinel};
  Members members(mission);
  members.Run(1);
  EXPECT_TRUE(members.LastOf("bravo").contacts[0].has_next);
  LeaderMessage damaged = *DecodeLeaderReport(members.sent_[0].payload);
  damaged.time_stamp_s = 0.9F;
  damaged.leader.next_position_m.x() = std::numeric_limits<float>::infinity();
  members.Hand("bravo", "alpha", EncodeLeaderReport(damaged));
  members.Run(0.2);
  const swarm_contact_t& contact = members.LastOf("bravo").contacts[0];
  EXPECT_EQ(contact.recovered, std::vector<std::string>{"leader_next_pos sentinel"});
  EXPECT_FALSE(contact.has_next);
  EXPECT_EQ(contact.next_x_m, 0);
}

TEST(Acomms, SurvivesAnyBytes) {
  Members members(TwoInFdma());
  members.Run(1);
  for (int length = 0; length < 400; length += 7) {
    std::vector<uint8_t> bytes;
    for (int i = 0; i < length; ++i) bytes.push_back(static_cast<uint8_t>(i * 37 + length));
    members.Hand("bravo", "alpha", bytes);
    bytes.insert(bytes.begin(), {'B', 'C', 'R', 'Q', 'A'});
    members.Hand("alpha", "bravo", bytes);
  }
  members.Run(0.3);
  int64_t received = 0;
  for (const swarm_source_t& source : members.LastOf("bravo").sources) {
    EXPECT_EQ(source.received, source.clean + source.recovered + source.rejected);
    received += source.received;
  }
  EXPECT_GE(received, 57);
}

}  // namespace shoal::acomms_app_test
