// muNet's BROADCAST/REQUEST: a leader sends all it knows of its group and asks for answers, in 65 +
// 32 N bytes for N followers.
//
//   byte  0        type, four letters: BCRQ
//         4        group_id
//         5        leader_pos, leader_vel, leader_next_pos, leader_next_vel: as in LEADER-REPORT
//        53        num_followers    uint32, N
//        57        followers_pos    N x 3 x float32, m
//        57 + 12 N followers_vel    N x 3 x float32, m/s
//        57 + 24 N followers_rspn   N x float32, s: when the follower last reported; 0: never
//        57 + 28 N rspn_sched       N x uint32: ids, in the order in which they are to answer
//        57 + 32 N rspn_start       float32, s: when the first answer is to begin
//        61 + 32 N time_stamp       float32, s
//
// Numbers are little-endian. The i-th position, velocity and time belong to the i-th id of
// rspn_sched.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "lib/comms/swarm/leader_message.h"
#include "lib/comms/swarm/report_message.h"

namespace shoal {

inline constexpr MessageFlag kBroadcastFlag = {'B', 'C', 'R', 'Q'};
inline constexpr size_t kNumFollowersOffset = 53;

/// Returns how long a BROADCAST/REQUEST for that many followers is.
[[nodiscard]] constexpr uint64_t BroadcastBytes(uint64_t num_followers) {
  return 65 + 32 * num_followers;
}

/// What a leader knows of a follower.
struct BroadcastFollower {
  uint32_t id = 0;
  Eigen::Vector3f position_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f velocity_mps = Eigen::Vector3f::Zero();
  float reported_s = 0;  ///< The time stamp of its last report; 0: it never reported.

  bool operator==(const BroadcastFollower&) const = default;
};

struct BroadcastMessage {
  uint8_t group_id = 0;
  LeaderMotion leader = {};
  std::vector<BroadcastFollower> followers = {};  ///< In the order in which they are to answer.
  float response_start_s = 0;                     ///< When the first of them is to begin.
  float time_stamp_s = 0;                         ///< Seconds of mission time.

  bool operator==(const BroadcastMessage&) const = default;
};

/// Returns BroadcastBytes(N) bytes.
[[nodiscard]] std::vector<uint8_t> EncodeBroadcast(const BroadcastMessage& message);

/// Returns the values in the bytes, valid or not; bytes behind the last do not matter. Nothing
/// where there are fewer than its number of followers asks for, or where they do not begin with
/// BCRQ.
[[nodiscard]] std::optional<BroadcastMessage> DecodeBroadcast(std::span<const uint8_t> bytes);

}  // namespace shoal
