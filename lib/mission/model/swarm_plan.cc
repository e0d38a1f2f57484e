#include "lib/mission/model/swarm_plan.h"

#include <algorithm>
#include <cmath>

#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/message_frame.h"

namespace shoal {

namespace {

constexpr int64_t kMunetEpisode_us = 5'000'000;
constexpr int64_t kMunetOffset_us = 500'000;
constexpr int64_t kCrcBytes = 4;

int64_t RoundUpToTicks(int64_t time_us, int64_t tick_us) {
  return (time_us + tick_us - 1) / tick_us * tick_us;
}

}  // namespace

const Acoustics& AcousticsOf(const Mission& mission, const MediaChoice& over) {
  for (const std::string& name : over.names) {
    if (name == kAcousticMedium) break;
    const auto medium = std::ranges::find(mission.media, name, &MediumOptions::name);
    if (medium != mission.media.end() && medium->kind == MediumKind::kAcoustic) {
      return medium->acoustics;
    }
  }
  return mission.acoustics;
}

const MediaChoice& PacketsOver(const Mission& mission) {
  static const MediaChoice kDefault = SwarmOptions().over;
  return mission.swarms.empty() ? kDefault : mission.swarms.front().over;
}

const Acoustics& PacketAcousticsOf(const Mission& mission) {
  return AcousticsOf(mission, PacketsOver(mission));
}

SwarmAir SwarmAirOf(const Mission& mission, const SwarmOptions& swarm) {
  const Acoustics& acoustics = AcousticsOf(mission, swarm.over);
  const AcousticOptions& options = acoustics.options;
  return {.num_followers = static_cast<int64_t>(swarm.followers.size()),
          .extra_bytes = (acoustics.crc ? kCrcBytes : 0) +
                         (swarm.frames ? static_cast<int64_t>(kFrameBytes) : 0),
          .data_rate_bps = options.data_rate_bps,
          .sound_speed_mps = options.sound_speed_mps,
          .max_distance_m = swarm.max_distance_m,
          .max_jitter_s = options.jitter == JitterModel::kUniform ? options.max_jitter_s : 0};
}

SwarmScheme SwarmSchemeOf(const Mission& mission, const SwarmOptions& swarm) {
  const std::string& scheduler = swarm.scheduler;
  if (scheduler == "fdma_lf") return SwarmScheme::kFdmaLf;
  if (scheduler == "tdma") return SwarmScheme::kTdma;
  if (scheduler == "tdma_lf") return SwarmScheme::kTdmaLf;
  switch (AcousticsOf(mission, swarm.over).options.access_mode) {
    case AccessMode::kFdma:
      return SwarmScheme::kFdmaLf;
    case AccessMode::kTdmaLf:
      return SwarmScheme::kTdmaLf;
    case AccessMode::kShared:
    case AccessMode::kTdma:
      break;
  }
  return SwarmScheme::kTdma;
}

SwarmSlots PlanSwarm(const Mission& mission, const SwarmOptions& swarm) {
  const SwarmAir air = SwarmAirOf(mission, swarm);
  const SwarmScheme scheme = SwarmSchemeOf(mission, swarm);
  SwarmSlots slots;
  const Result<AirTimes> times = FindAirTimes(air);
  const Result<SlotPlan> shortest = AutoPlan(scheme, mission.tick_us, air);
  if (!times.ok() || !shortest.ok()) {
    slots.problems.push_back({.key = "leader",
                              .at_least_us = 0,
                              .message = times.ok() ? shortest.error() : times.error()});
    return slots;
  }
  SlotPlan& plan = slots.plan = *shortest;
  if (scheme == SwarmScheme::kFdmaLf) {
    plan.episode_us = std::max(plan.episode_us, RoundUpToTicks(kMunetEpisode_us, mission.tick_us));
    plan.offset_us = RoundUpToTicks(kMunetOffset_us, mission.tick_us);
  }
  if (swarm.offset_s >= 0) plan.offset_us = Microseconds(swarm.offset_s);
  if (swarm.broadcast_s >= 0) plan.broadcast_us = Microseconds(swarm.broadcast_s);
  if (swarm.response_s >= 0) plan.response_us = Microseconds(swarm.response_s);
  if (swarm.episode_s >= 0) {
    plan.episode_us = Microseconds(swarm.episode_s);
  } else if (scheme == SwarmScheme::kTdmaLf) {
    plan.episode_us =
        std::max(plan.episode_us, plan.broadcast_us + air.num_followers * plan.response_us);
  } else if (scheme == SwarmScheme::kTdma) {
    plan.episode_us = std::max(plan.episode_us, (air.num_followers + 1) * plan.offset_us);
  }
  slots.problems = FindTimingProblems(plan, air);
  if (scheme == SwarmScheme::kTdmaLf) plan.answer_window_us = SafeAnswerWindow_us(plan, *times);
  return slots;
}

}  // namespace shoal
