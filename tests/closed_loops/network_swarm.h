// A leader on a path and its followers, which know of each other what the acoustic network let
// through: shoal's model, laws, messages, slots and water in the order of muNet's loop. In a step
// each vehicle in turn sends what is due, decides and moves, so that a packet leaves from where its
// sender is at the step's beginning and those before it at its end; then every vehicle receives
// what has arrived.
//
//   NetworkSwarm swarm(setup, start);
//   swarm.Step();
//   swarm.events(), swarm.auv(2).state
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/comms/swarm/schedule.h"
#include "lib/comms/swarm/swarm_receiver.h"
#include "lib/sea/acoustics/acoustic_network.h"
#include "lib/sea/ocean/sea_floor.h"
#include "lib/vehicle/sensors/forward_looking_sonar.h"
#include "tests/closed_loops/munet_auv.h"

namespace shoal {

inline constexpr int64_t kMunetStep_us = 20'000;

/// A message that a member sent or received; ids count from 1, the leader's.
struct SwarmEvent {
  bool is_send = false;
  int64_t utime = 0;
  int id = 0;       ///< The member that sent or received it.
  int channel = 0;  ///< Its id.
  std::vector<uint8_t> bytes = {};
};

struct NetworkSwarmSetup {
  AcousticOptions water = {};
  SlotPlan slots = {};
  VelocityCascade law = {};
  std::vector<Eigen::Vector3d> path_m;
  double rpm = 1200;  ///< The leader's.
  Eigen::Vector3d current_mps = Eigen::Vector3d::Zero();
  double floor_z_m = 200;  ///< It is flat.
  bool has_sonar = false;  ///< Of the followers.
};

class NetworkSwarm {
 public:
  /// `start`: the leader's state and those of the followers.
  NetworkSwarm(NetworkSwarmSetup setup, const std::vector<Remus100State>& start);
  virtual ~NetworkSwarm() = default;

  void Step();

  int num_members() const { return static_cast<int>(auvs_.size()); }
  const MunetAuv& auv(int index) const { return auvs_.at(static_cast<size_t>(index)); }
  const std::vector<SwarmEvent>& events() const { return events_; }
  const ReceptionCounts& counts(int index) const { return ReceiverOf(index).counts; }
  const AcousticNetwork& water() const { return water_; }
  /// As near as anything came that a sonar saw; infinity where nothing did.
  double nearest_echo_m() const { return nearest_echo_m_; }

 protected:
  /// What a follower takes the others to do.
  struct Others {
    Motion target;
    std::vector<Neighbour> group;
  };

  // Members have indices, the leader 0; id = index + 1, which muNet's places are, too.
  virtual std::optional<DueMessage> Due(int index, int64_t now_us);
  /// Called once per step and follower.
  virtual Others Expect(int index, int64_t now_us);
  /// `index` has taken in a message.
  virtual void OnReception(int /*index*/, const SwarmReception& /*reception*/, int64_t /*now_us*/) {
  }

  const SwarmReceiver& ReceiverOf(int index) const {
    return receivers_.at(static_cast<size_t>(index));
  }
  const NetworkSwarmSetup& setup() const { return setup_; }
  /// How the leader will be at its next waypoint.
  Motion NextOfLeader() const;

 private:
  Motion MotionOf(int index) const;
  void Send(int index, const DueMessage& due, int64_t now_us);
  void Ping(int index);
  void Decide(int index, int64_t now_us);
  void Deliver(int64_t now_us);

  NetworkSwarmSetup setup_;
  std::vector<MunetAuv> auvs_;
  AcousticNetwork water_;
  std::vector<SwarmReceiver> receivers_;
  std::vector<SwarmSchedule> schedules_;
  ForwardLookingSonar sonar_{SonarParams{}};
  SeaFloor floor_;
  std::vector<std::vector<SonarEcho>> echoes_;  ///< Of each member's last ping.
  double nearest_echo_m_;
  std::vector<SwarmEvent> events_;
  int64_t step_ = 0;
};

/// Returns all positions in a message, in its order; nothing if it is not one.
[[nodiscard]] std::vector<Eigen::Vector3d> PositionsIn(const std::vector<uint8_t>& bytes);

}  // namespace shoal
