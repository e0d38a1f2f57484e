// muNet's LEADER-REPORT: where the leader is, and how it expects to be at its next waypoint, in 57
// bytes.
//
//   byte  0  type, four letters: LRPT
//         4  group_id
//         5  leader_pos       3 x float32, m
//        17  leader_vel       3 x float32, m/s
//        29  leader_next_pos  3 x float32, m
//        41  leader_next_vel  3 x float32, m/s
//        53  time_stamp       float32, s
//
// Numbers are little-endian. Nothing in it shows whether it was damaged on its way, nor which
// vehicle the leader is: a group has one.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/base/codec/little_endian.h"
#include "lib/comms/swarm/report_message.h"

namespace shoal {

inline constexpr size_t kLeaderReportBytes = 57;
inline constexpr MessageFlag kLeaderReportFlag = {'L', 'R', 'P', 'T'};

/// What a leader reports of itself. Vectors are x East, y North, z down.
struct LeaderMotion {
  Eigen::Vector3f position_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f velocity_mps = Eigen::Vector3f::Zero();
  Eigen::Vector3f next_position_m = Eigen::Vector3f::Zero();  ///< Its next waypoint.
  Eigen::Vector3f next_velocity_mps = Eigen::Vector3f::Zero();

  bool operator==(const LeaderMotion&) const = default;
};

struct LeaderMessage {
  uint8_t group_id = 0;
  LeaderMotion leader = {};
  float time_stamp_s = 0;  ///< Seconds of mission time.

  bool operator==(const LeaderMessage&) const = default;
};

/// Returns kLeaderReportBytes bytes.
[[nodiscard]] std::vector<uint8_t> EncodeLeaderReport(const LeaderMessage& message);

/// Returns the values in the bytes, valid or not; bytes behind the 57th do not matter. Nothing
/// where there are fewer, or where they do not begin with LRPT.
[[nodiscard]] std::optional<LeaderMessage> DecodeLeaderReport(std::span<const uint8_t> bytes);

/// Writes and reads the 48 bytes of a leader's motion. @pre Take: at least 48 bytes are left
void AppendLeaderMotion(const LeaderMotion& leader, std::vector<uint8_t>* bytes);
[[nodiscard]] LeaderMotion TakeLeaderMotion(LittleEndianReader* reader);

}  // namespace shoal
