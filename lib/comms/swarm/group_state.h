// What one vehicle knows of its group: its own, not shared.
//
//   GroupState state{.own_id = 3, .group_id = 'A', .target = SwarmContact{.id = 1}};
//   state.members.push_back({.id = 2});
//   ... Receive(bytes, utime, &receiver) fills it ...
//   if (const auto second = PredictContact(state.members[0], utime)) KeepClearOf(*second);
//
// Members are those of the mission's list: a message brings no new ones. Nothing moves between
// messages; where a contact is now is worked out when it is asked for, from the time stamp of its
// last report.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "lib/comms/swarm/response_request.h"
#include "lib/vehicle/guidance/motion_prediction.h"

namespace shoal {

struct TimedMotion {
  int64_t time_us = 0;  ///< The report's time stamp.
  Motion motion = {};
};

/// Where a contact was, oldest first, times growing.
struct MotionLog {
  static constexpr size_t kFirstCapacity = 512;
  /// muNet's logs double for ever; at one report in 5 s this one holds the last 45 hours.
  static constexpr size_t kMaxCapacity = 32'768;

  std::deque<TimedMotion> entries = {};
  size_t capacity = kFirstCapacity;
};

/// Adds an entry. A full log doubles its capacity, up to kMaxCapacity; then the oldest goes. An
/// entry that is as old as the newest replaces it; one that is older is left out.
void AppendToLog(const TimedMotion& entry, MotionLog* log);

/// Sets the capacity. The newest entries that fit are kept, in their order. @pre capacity > 0
void ResizeLog(size_t capacity, MotionLog* log);

/// Returns the last n entries, oldest first; all where there are fewer.
[[nodiscard]] std::vector<TimedMotion> LastEntries(const MotionLog& log, size_t n);

/// What the strategy `sentinel` writes in place of a value: a place and a speed that no vehicle
/// has.
struct SentinelValues {
  double position_m = -999'999;  ///< Each coordinate.
  double speed_mps = -999;       ///< Each component.

  bool operator==(const SentinelValues&) const = default;
};
/// The sentinel of times; that of a mission cannot be another, as every time below 0 means it.
inline constexpr double kSentinelTime_s = -1;

/// What the strategy `neutral` puts in place of a position or a velocity.
struct NeutralValues {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();

  bool operator==(const NeutralValues&) const = default;
};

/// One vehicle of the group, as another knows it.
struct SwarmContact {
  uint32_t id = 0;
  uint8_t group_id = 'A';
  bool is_known = false;  ///< `report` holds something: its start by the mission file, or a report.
  bool has_reported = false;  ///< It has reported, itself or by its leader.
  bool has_answered = false;  ///< It has reported itself since the leader's last request.
  MotionReport report = {};   ///< Only leaders report `next`.
  int64_t reported_us = 0;    ///< The report's own time stamp.
  int64_t arrived_us = 0;     ///< When it came.
  MotionLog log = {};
  SentinelValues sentinel = {};  ///< In `report`, of what is not known.
};

struct GroupState {
  uint32_t own_id = 0;
  uint8_t group_id = 'A';
  bool is_leader = false;
  std::vector<SwarmContact> members = {};   ///< The followers, without oneself; never the leader.
  std::optional<SwarmContact> target = {};  ///< The leader. A leader has none.

  int64_t episode_us = 5'000'000;               ///< From one report of a vehicle to its next.
  std::vector<int64_t> response_order = {};     ///< Ids, of the last request.
  int64_t response_start_us = 0;                ///< Of the last request; 0: none came.
  std::optional<ResponseRequest> request = {};  ///< The last one, if it asks this vehicle.
  SentinelValues sentinel = {};                 ///< Of its contacts, too.
  NeutralValues neutral = {};
};

[[nodiscard]] bool operator==(const TimedMotion& a, const TimedMotion& b);
[[nodiscard]] bool operator==(const SwarmContact& a, const SwarmContact& b);
[[nodiscard]] bool operator==(const GroupState& a, const GroupState& b);

/// Returns a contact that is to be expected there at the beginning of the mission.
[[nodiscard]] SwarmContact PlacedContact(uint32_t id, uint8_t group_id, const Motion& motion);

/// Returns nothing for an id that is not in the group's list.
[[nodiscard]] const SwarmContact* FindMember(const GroupState& state, int64_t id);
[[nodiscard]] SwarmContact* FindMember(GroupState* state, int64_t id);

/// Returns whether position, velocity and time of the last report can be used: there is one, and
/// none of them is a sentinel.
[[nodiscard]] bool IsUsable(const SwarmContact& contact);

/// Returns whether the contact has reported its next waypoint, and how it will move there: leaders
/// do, and neither is a sentinel.
[[nodiscard]] bool KnowsNext(const SwarmContact& contact);

/// Returns where the contact is now: its last report and constant velocity since. Nothing unless
/// IsUsable.
[[nodiscard]] std::optional<Motion> PredictContact(const SwarmContact& contact, int64_t now_us);

}  // namespace shoal
