// A member of one swarm that receives what another swarm on its network sends.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apps/acomms/acomms_app.h"
#include "apps/acomms/swarm_setup.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/comms/swarm/report_message.h"

namespace shoal::two_swarms_test {

constexpr int64_t kTick_us = 100'000;

/// alpha leads bravo, charlie leads delta, on one network.
Mission TwoSwarms() {
  Mission mission;
  mission.acoustics.is_used = true;
  mission.acoustics.crc = false;
  int address = 1;
  for (const std::string name : {"alpha", "bravo", "charlie", "delta"}) {
    Vehicle vehicle;
    vehicle.name = name;
    vehicle.acoustic_address = address++;
    mission.vehicles.push_back(vehicle);
  }
  mission.swarms.resize(2);
  mission.swarms[0].name = "north";
  mission.swarms[0].leader = "alpha";
  mission.swarms[0].followers = {"bravo"};
  mission.swarms[1].name = "south";
  mission.swarms[1].leader = "charlie";
  mission.swarms[1].followers = {"delta"};
  mission.swarms[1].group_id = "B";
  return mission;
}

/// bravo's acomms, and what it publishes.
class Bravo {
 public:
  Bravo() {
    Subscribe(world_, channels::Swarm("bravo"), [this](const swarm_t& swarm) { swarm_ = swarm; });
    Subscribe(world_, channels::Acomms("bravo"),
              [this](const acomms_t& record) { num_events_ += record.num_events; });
  }

  void Receive(const std::string& source, char group_id, uint32_t id) {
    acoustic_rx_t packet{};
    packet.source = source;
    packet.payload = EncodeReport({.flag = kReportFlag,
                                   .group_id = static_cast<uint8_t>(group_id),
                                   .reporter_id = id,
                                   .position_m = {7, 8, 9},
                                   .velocity_mps = {1, 0, 0},
                                   .time_stamp_s = 0});
    packet.num_bytes = static_cast<int32_t>(packet.payload.size());
    Publish(world_, channels::AcousticRx("bravo"), packet);
    hub_.NextStep();
    hub_.HandleAll();
    app_.Tick(utime_ += kTick_us);
    hub_.NextStep();
    hub_.HandleAll();
  }

  int64_t CountOf(const std::string& by) const {
    const auto found = std::ranges::find(swarm_.counts, by, &swarm_count_t::by);
    return found == swarm_.counts.end() ? 0 : found->count;
  }

  swarm_t swarm_{};
  int64_t num_events_ = 0;
  std::string Page() const { return app_.Status().text; }

 private:
  const Mission mission_ = TwoSwarms();
  MemoryBus hub_;
  Bus& world_ = hub_.Join("world");
  Bus& bus_ = hub_.Join("acomms_bravo");
  AcommsApp app_{mission_, mission_.vehicles[1], bus_};
  int64_t utime_ = 0;
};

TEST(TwoSwarms, KnowOnlyTheirOwnMembers) {
  const Mission mission = TwoSwarms();
  const SwarmReceiver bravo = MakeSwarmReceiver(mission, mission.vehicles[1]);
  EXPECT_EQ(bravo.state.group_id, 'A');
  EXPECT_EQ(bravo.state.target->id, 1U);
  EXPECT_TRUE(bravo.state.members.empty());
  const SwarmReceiver charlie = MakeSwarmReceiver(mission, mission.vehicles[2]);
  EXPECT_EQ(charlie.state.group_id, 'B');
  EXPECT_TRUE(charlie.state.is_leader);
  ASSERT_EQ(charlie.state.members.size(), 1U);
  EXPECT_EQ(charlie.state.members[0].id, 4U);
}

TEST(TwoSwarms, DropAndCountEachOthersMessagesWithoutAnEvent) {
  Bravo bravo;
  bravo.Receive("delta", 'B', 4);
  EXPECT_EQ(bravo.CountOf("of another group"), 1);
  EXPECT_EQ(bravo.num_events_, 0);
  EXPECT_NE(bravo.Page().find("messages of other swarms dropped: 1\n"), std::string::npos)
      << bravo.Page();
  EXPECT_NE(bravo.Page().find("leader alpha, swarm north (group_id A)\n"), std::string::npos);
}

TEST(TwoSwarms, RecordAWrongGroupOfAVehicleOfNoOtherSwarm) {
  Bravo bravo;
  bravo.Receive("alpha", 'B', 1);
  EXPECT_EQ(bravo.CountOf("of another group"), 1);
  EXPECT_EQ(bravo.num_events_, 1);
  EXPECT_NE(bravo.Page().find("messages of other swarms dropped: 0\n"), std::string::npos);
}

}  // namespace shoal::two_swarms_test
