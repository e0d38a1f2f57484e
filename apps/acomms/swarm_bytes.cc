#include "apps/acomms/swarm_bytes.h"

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/broadcast_message.h"
#include "lib/comms/swarm/leader_message.h"
#include "lib/comms/swarm/report_message.h"

namespace shoal {

namespace {

float FloatSeconds(int64_t time_us) { return static_cast<float>(Seconds(time_us)); }

bool IsEncodable(const Motion& motion, const FieldLimits& limits) {
  return motion.position_m.allFinite() && motion.velocity_mps.allFinite() &&
         motion.position_m.cwiseAbs().maxCoeff() <= limits.max_position_m &&
         motion.velocity_mps.cwiseAbs().maxCoeff() <= limits.max_speed_mps;
}

LeaderMotion LeaderMotionOf(const SwarmMessageInputs& inputs) {
  return {.position_m = inputs.own.position_m.cast<float>(),
          .velocity_mps = inputs.own.velocity_mps.cast<float>(),
          .next_position_m = inputs.next.position_m.cast<float>(),
          .next_velocity_mps = inputs.next.velocity_mps.cast<float>()};
}

ReportMessage ReportOf(const SwarmMessageInputs& inputs, MessageFlag flag) {
  return {.flag = flag,
          .group_id = inputs.state.group_id,
          .reporter_id = inputs.state.own_id,
          .position_m = inputs.own.position_m.cast<float>(),
          .velocity_mps = inputs.own.velocity_mps.cast<float>(),
          .time_stamp_s = FloatSeconds(inputs.now_us)};
}

BroadcastMessage BroadcastOf(const SwarmMessageInputs& inputs, int64_t response_start_us) {
  BroadcastMessage message = {.group_id = inputs.state.group_id,
                              .leader = LeaderMotionOf(inputs),
                              .followers = {},
                              .response_start_s = FloatSeconds(response_start_us),
                              .time_stamp_s = FloatSeconds(inputs.now_us)};
  for (const SwarmContact& member : inputs.state.members) {
    const bool is_usable = IsUsable(member);
    message.followers.push_back(
        {.id = member.id,
         .position_m = is_usable ? Eigen::Vector3f(member.report.now.position_m.cast<float>())
                                 : Eigen::Vector3f::Zero(),
         .velocity_mps = is_usable ? Eigen::Vector3f(member.report.now.velocity_mps.cast<float>())
                                   : Eigen::Vector3f::Zero(),
         .reported_s = member.has_reported && is_usable ? FloatSeconds(member.reported_us) : 0});
  }
  return message;
}

}  // namespace

std::optional<Motion> MotionOf(const nav_t& nav, const FieldLimits& limits) {
  const Eigen::Vector2d over_ground_mps =
      nav.speed_over_ground_mps * UnitVector(DegToRad(nav.course_over_ground_deg));
  const Motion motion = {
      .position_m = {nav.x_m, nav.y_m, nav.z_m},
      .velocity_mps = {over_ground_mps.x(), over_ground_mps.y(), nav.descent_mps}};
  if (!IsEncodable(motion, limits)) return std::nullopt;
  return motion;
}

Motion NextOf(const Motion& own, const helm_state_t& helm, const SpeedPlan& plan,
              const FieldLimits& limits) {
  const Eigen::Vector3d waypoint_m(helm.waypoint_x_m, helm.waypoint_y_m, helm.waypoint_z_m);
  if (helm.waypoint_index < 0) return own;
  const Motion next = waypoint_m.allFinite() ? PredictAtPoint(own, waypoint_m, plan) : own;
  return IsEncodable(next, limits) ? next : own;
}

std::vector<uint8_t> SwarmBytes(const DueMessage& due, const SwarmMessageInputs& inputs) {
  switch (due.message) {
    case SwarmMessage::kReport:
      return EncodeReport(ReportOf(inputs, kReportFlag));
    case SwarmMessage::kResponse:
      return EncodeReport(ReportOf(inputs, kResponseFlag));
    case SwarmMessage::kLeaderReport:
      return EncodeLeaderReport({.group_id = inputs.state.group_id,
                                 .leader = LeaderMotionOf(inputs),
                                 .time_stamp_s = FloatSeconds(inputs.now_us)});
    case SwarmMessage::kBroadcastRequest:
      break;
  }
  return EncodeBroadcast(BroadcastOf(inputs, due.response_start_us));
}

}  // namespace shoal
