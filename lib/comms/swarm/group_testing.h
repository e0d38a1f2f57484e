// A group for tests: leader 1, followers 2, 3, 4 and 5, of which 3 receives. Every member has
// reported twice, at 5 and 10 s; it is 16 s now.
#pragma once

#include <vector>

#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/swarm_receiver.h"

namespace shoal {

inline constexpr int64_t kTestNow_us = 16'000'000;

inline SwarmContact ReportedContact(uint32_t id) {
  const double east_m = 100.0 * id;
  const Motion first{.position_m = {east_m, 0, 10}, .velocity_mps = {1, 0, 0}};
  const Motion second{.position_m = {east_m + 5, 0, 10}, .velocity_mps = {1.5, 0, 0}};
  SwarmContact contact = PlacedContact(id, 'A', second);
  contact.has_reported = true;
  contact.reported_us = 10'000'000;
  contact.arrived_us = 10'500'000;
  AppendToLog({.time_us = 5'000'000, .motion = first}, &contact.log);
  AppendToLog({.time_us = 10'000'000, .motion = second}, &contact.log);
  return contact;
}

inline SwarmReceiver FollowerThree() {
  return {.state = {.own_id = 3,
                    .members = {ReportedContact(2), ReportedContact(4), ReportedContact(5)},
                    .target = ReportedContact(1),
                    .response_order = {2, 3, 4, 5},
                    .response_start_us = 12'000'000}};
}

inline ReportMessage ReportOfTwo() {
  return {.group_id = 'A',
          .reporter_id = 2,
          .position_m = {210, 1, 11},
          .velocity_mps = {1.25F, 0.5F, 0},
          .time_stamp_s = 15};
}

inline LeaderMessage ReportOfTheLeader() {
  return {.group_id = 'A',
          .leader = {.position_m = {110, 1, 11},
                     .velocity_mps = {2, 0, 0},
                     .next_position_m = {500, 0, 10},
                     .next_velocity_mps = {0, 2, 0}},
          .time_stamp_s = 15};
}

inline BroadcastMessage RequestToFour() {
  BroadcastMessage request{.group_id = 'A',
                           .leader = ReportOfTheLeader().leader,
                           .response_start_s = 17,
                           .time_stamp_s = 15};
  for (const uint32_t id : {2U, 3U, 4U, 5U}) {
    const auto number = static_cast<float>(id);
    request.followers.push_back({.id = id,
                                 .position_m = {100 * number, number, 12},
                                 .velocity_mps = {number, 0, 0},
                                 .reported_s = 10 + number / 2});
  }
  return request;
}

/// What FollowerThree makes of a message at kTestNow_us.
struct Received {
  SwarmReceiver receiver = FollowerThree();
  SwarmReception reception = {};

  const SwarmContact& two() const { return receiver.state.members[0]; }
};

inline Received ReceiveBytes(const std::vector<uint8_t>& bytes, Received received = {}) {
  received.reception = Receive(bytes, kTestNow_us, &received.receiver);
  return received;
}

}  // namespace shoal
