#include "lib/vehicle/guidance/path_follower.h"

#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

/// As far as this the lead of a depth looks, on curves of short legs.
constexpr int kMaxLegsOfLead = 8;

}  // namespace

PathFollower::PathFollower(PathFollowParams params, const Eigen::Vector3d& position_m)
    : params_(std::move(params)),
      progress_(BeginPath(params_.path, position_m, params_.waypoint_switch.acceptance_radius_m)),
      alos_(params_.alos) {
  progress_.approaches = progress_.approaches && params_.approach;
}

PathGuidance PathFollower::Update(const Eigen::Vector3d& position_m, double dt_s) {
  const PathLeg leg = CurrentLeg(params_.path, params_.end, progress_, position_m);
  const size_t size = params_.path.points_m.size();
  const bool is_closing = progress_.previous + 1 == size && size > 1;
  PathGuidance guidance{.z_m = leg.to_m.z(),
                        .speed_mps = params_.speed_mps,
                        .next_m = leg.to_m,
                        .psi_rad = leg.psi_rad,
                        .y_e_m = ErrorsOn(leg, position_m).y_e_m,
                        .next = progress_.ended || !is_closing ? progress_.previous + 1 : 0,
                        .laps_done = progress_.laps_done,
                        .done = progress_.ended};
  if (size == 1) guidance.next = progress_.ended ? 1 : 0;
  if (progress_.approaches) guidance.next = 0;
  if (params_.depth_rule == DepthRule::kSlope) Glide(leg, position_m, &guidance);

  const bool holds = params_.end == PathEnd::kHold || params_.end == PathEnd::kReturnToFirst;
  if (progress_.ended && holds) {
    Hold(position_m, dt_s, &guidance);
  } else if (!surfaced_) {
    held_psi_rad_ = Steer(leg, guidance.y_e_m, dt_s);
  }
  guidance.psi_ref_rad = held_psi_rad_;
  guidance.crab_rad = params_.guard_crab ? alos_.crab_rad() : bare_crab_rad_;
  if (progress_.ended && params_.end == PathEnd::kSurface) Surface(position_m, &guidance);

  const PathProgress before = progress_;
  progress_ = Advance(params_.path, params_.waypoint_switch, params_.end, progress_, position_m);
  if (progress_ != before) leg_before_ = leg;
  if (params_.turn_crab) {
    const PathLeg after = CurrentLeg(params_.path, params_.end, progress_, position_m);
    const double turn_rad = WrapPi(after.psi_rad - leg.psi_rad);
    if (turn_rad != 0) {
      alos_.TurnBy(turn_rad);
      bare_crab_rad_ *= Cos(turn_rad);
    }
  }
  return guidance;
}

double PathFollower::Steer(const PathLeg& leg, double y_e_m, double dt_s) {
  if (params_.guard_crab) return alos_.Update(leg.psi_rad, y_e_m, dt_s);
  const AlosStep step = StepAlos(params_.alos, leg.psi_rad, y_e_m, bare_crab_rad_, dt_s);
  bare_crab_rad_ = step.crab_rad;
  return step.heading_rad;
}

// A waypoint is left up to R before it is abeam, where its leg still has a way to glide.
void PathFollower::Glide(const PathLeg& leg, const Eigen::Vector3d& position_m,
                         PathGuidance* guidance) const {
  const bool is_on_leg_before = leg_before_ && ErrorsOn(leg, position_m).x_e_m < 0 &&
                                ErrorsOn(*leg_before_, position_m).x_e_m < leg_before_->length_m;
  PathLeg abeam = is_on_leg_before ? *leg_before_ : leg;
  guidance->z_m = DepthOn(abeam, position_m);
  double x_m = ErrorsOn(abeam, position_m).x_e_m + params_.depth_lead_s * params_.speed_mps;
  PathProgress progress = progress_;
  for (int i = 0; i < kMaxLegsOfLead && x_m > abeam.length_m && !progress.ended; ++i) {
    x_m -= abeam.length_m;
    if (i > 0 || !is_on_leg_before) progress = NextLeg(params_.path, params_.end, progress);
    abeam = CurrentLeg(params_.path, params_.end, progress, position_m);
  }
  guidance->slope = x_m < 0 || x_m > abeam.length_m ? 0 : SlopeOf(abeam);
}

void PathFollower::Hold(const Eigen::Vector3d& position_m, double dt_s, PathGuidance* guidance) {
  const Eigen::Vector3d last_m = Plausible(params_.path.points_m.back());
  const Eigen::Vector3d way_m = last_m - Plausible(position_m);
  const double distance_m = way_m.head<2>().norm();
  const bool is_near = distance_m <= params_.waypoint_switch.acceptance_radius_m;
  if (distance_m > params_.hold_radius_m) goes_back_ = true;
  if (is_near) goes_back_ = false;
  const bool is_off_depth = depth_band_.IsLeft(-way_m.z(), dt_s);
  const bool is_under_way = goes_back_ || is_off_depth;
  // Close to the point it only changes its depth, straight on.
  if (is_under_way && !is_near) held_psi_rad_ = WrapPi(Atan2(way_m.y(), way_m.x()));
  guidance->speed_mps = is_under_way ? params_.speed_mps : 0;
  guidance->next_m = last_m;
  guidance->z_m = last_m.z();
  guidance->y_e_m = 0;
}

void PathFollower::Surface(const Eigen::Vector3d& position_m, PathGuidance* guidance) {
  surfaced_ = surfaced_ || position_m.z() <= params_.surface_depth_m;
  guidance->z_m = 0;
  guidance->next_m.z() = 0;
  guidance->done = surfaced_;
  if (surfaced_) guidance->speed_mps = 0;
}

}  // namespace shoal
