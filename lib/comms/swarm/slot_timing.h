// How long the slots of a swarm have to be: for the bytes on the air, the acoustic travel time,
// the jitter, and the steps in which messages are handled.
//
//   const SwarmAir air = {.num_followers = 9, .max_distance_m = 1000};
//   const Result<SlotPlan> plan = AutoPlan(SwarmScheme::kTdmaLf, tick_us, air);
//   for (const TimingProblem& problem : FindTimingProblems(mine, air)) Print(problem.message);
//
// With a plan without problems, no two messages overlap on a channel at any receiver, and every
// follower has the request when its slot begins.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/comms/swarm/schedule.h"

namespace shoal {

/// As many followers as a request may name.
inline constexpr int64_t kMaxFollowers = 1000;

/// The members' messages and the acoustic link that carries them.
struct SwarmAir {
  int64_t num_followers = 1;
  int64_t extra_bytes = 0;  ///< Of each message: checksum, frame.
  double data_rate_bps = 1000;
  double sound_speed_mps = 1500;
  double max_distance_m = 1000;  ///< No two members are ever farther apart.
  double max_jitter_s = 0.2;
};

/// What each message of the swarm takes at most, rounded up to microseconds.
struct AirTimes {
  int64_t report_us = 0;         ///< REPORT and RESPONSE: from the first byte to the last.
  int64_t leader_report_us = 0;  ///< LEADER-REPORT.
  int64_t request_us = 0;        ///< BROADCAST/REQUEST with all followers.
  int64_t travel_us = 0;         ///< Over the greatest distance.
  int64_t jitter_us = 0;

  bool operator==(const AirTimes&) const = default;
};

/// An error in a plan or in its inputs.
struct TimingProblem {
  std::string key;  ///< What to change: "episode_s", or a member of SwarmAir.
  int64_t at_least_us =
      0;  ///< Where a length is too short, or not of whole steps: the shortest that suffices.
  std::string message;  ///< "episode_s = 5 is too short for 9 followers: ...; use at least ..."
};

/// Returns what each message takes, or the first number that is out of range.
[[nodiscard]] Result<AirTimes> FindAirTimes(const SwarmAir& air);

/// Returns the shortest plan without problems, in whole steps. fdma_lf: members begin evenly spread
/// over the episode.
[[nodiscard]] Result<SlotPlan> AutoPlan(SwarmScheme scheme, int64_t tick_us, const SwarmAir& air);

/// Returns how late an answer may begin and still end within its slot (SlotPlan::answer_window_us);
/// 0 where the slot is too short.
/// @pre FindAirTimes gave `times`.
[[nodiscard]] int64_t SafeAnswerWindow_us(const SlotPlan& plan, const AirTimes& times);

/// Returns all that is wrong; all remedies together fix it. Members have consecutive places.
///   fdma_lf  a member's message is over everywhere before its next begins
///   tdma     a message is over everywhere before the next slot; a frame fits into an episode
///   tdma_lf  the request has been handled everywhere when slot 0 begins, an answer is over before
///            the next slot, a request and all answers fit into an episode
/// Whether members of fdma_lf miss what comes while they send themselves (half duplex) is not
/// checked.
[[nodiscard]] std::vector<TimingProblem> FindTimingProblems(const SlotPlan& plan,
                                                            const SwarmAir& air);

}  // namespace shoal
