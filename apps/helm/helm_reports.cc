#include "apps/helm/helm_reports.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "apps/helm/arbiter.h"
#include "apps/helm/helm_states.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/waypoint_arrival.h"

namespace shoal {

namespace {

/// Where it steers for, as HELM_STATE has it.
struct StateNumbers {
  int waypoint_index = -1;
  int laps_done = 0;
  Eigen::Vector3d waypoint_m = Eigen::Vector3d::Zero();
  double distance_m = 0;
  double cross_track_error_m = 0;
};

StateNumbers NumbersOf(const Guidance& guidance) {
  return {
      .waypoint_index = guidance.waypoint_index,
      .laps_done = guidance.laps_done,
      .waypoint_m = {guidance.waypoint_m.x(), guidance.waypoint_m.y(), guidance.z_m.value_or(0)},
      .distance_m = guidance.distance_m,
      .cross_track_error_m = guidance.cross_track_error_m};
}

StateNumbers NumbersOf(const helm_state_t& state) {
  return {.waypoint_index = state.waypoint_index,
          .laps_done = state.laps_done,
          .waypoint_m = {state.waypoint_x_m, state.waypoint_y_m, state.waypoint_z_m},
          .distance_m = state.distance_m,
          .cross_track_error_m = state.cross_track_error_m};
}

/// True where the next HELM_STATE differs from `last` in more than follows from NAV.
bool HasNews(const StateWords& words, const StateNumbers& numbers, const helm_state_t& last) {
  return words.state != last.state || words.task != last.task ||
         words.task_kind != last.task_kind || words.all_stop != last.all_stop ||
         numbers.waypoint_index != last.waypoint_index || numbers.laps_done != last.laps_done ||
         numbers.waypoint_m.x() != last.waypoint_x_m ||
         numbers.waypoint_m.y() != last.waypoint_y_m || numbers.waypoint_m.z() != last.waypoint_z_m;
}

}  // namespace

StateWords WordsOf(const HelmStates& states, const Arbiter& arbiter) {
  const HelmMode mode = states.mode();
  const bool drives = mode == HelmMode::kDrive;
  StateWords words{.state = Name(mode), .all_stop = states.all_stop()};
  if (drives) words.all_stop = arbiter.all_stop();
  if (const Task* task = states.task()) {
    words.task = task->name;
    words.task_kind = KindOf(*task);
  } else if (const HelmAim* leading = drives ? arbiter.Leading() : nullptr) {
    words.task = leading->name;
    words.task_kind = leading->kind;
  }
  return words;
}

HelmReports::HelmReports(const Vehicle& vehicle, Bus& bus)
    : bus_(bus),
      interval_us_(Microseconds(vehicle.helm_options.state_interval_s)),
      state_channel_(channels::HelmState(vehicle.name)),
      guidance_channel_(channels::Guidance(vehicle.name)) {
  state_.vehicle = vehicle.name;
  how_.vehicle = vehicle.name;
}

void HelmReports::PublishState(int64_t utime, const StateWords& words, const Guidance* guidance,
                               const nav_t& nav, StatusLog* log) {
  StateNumbers numbers;
  if (guidance != nullptr) {
    numbers = NumbersOf(*guidance);
  } else if (!words.task.empty() && words.task == state_.task) {
    numbers = NumbersOf(state_);
  }
  if (state_utime_ && !HasNews(words, numbers, state_) && utime - *state_utime_ < interval_us_) {
    return;
  }
  if (words.state != state_.state || words.task != state_.task ||
      words.all_stop != state_.all_stop) {
    log->Event(utime, fmt::format("{} {} ({})", words.state, words.task, words.all_stop));
  }
  const helm_state_t before = state_;
  state_utime_ = utime;
  state_.utime = utime;
  state_.state = words.state;
  state_.all_stop = words.all_stop;
  state_.task = words.task;
  state_.task_kind = words.task_kind;
  state_.waypoint_index = numbers.waypoint_index;
  state_.laps_done = numbers.laps_done;
  state_.waypoint_x_m = numbers.waypoint_m.x();
  state_.waypoint_y_m = numbers.waypoint_m.y();
  state_.waypoint_z_m = numbers.waypoint_m.z();
  state_.distance_m = numbers.distance_m;
  state_.cross_track_error_m = numbers.cross_track_error_m;
  Publish(bus_, state_channel_, state_);
  if (const std::string arrival = ArrivalText(before, state_); !arrival.empty()) {
    const double miss_m = (Eigen::Vector2d(before.waypoint_x_m, before.waypoint_y_m) -
                           Eigen::Vector2d(nav.x_m, nav.y_m))
                              .norm();
    log->Event(utime, fmt::format("{}, {:.1f} m from it", arrival, miss_m));
  }
}

void HelmReports::PublishGuidance(int64_t utime, const Guidance& guidance, double pitch_rad,
                                  const desired_t& desired) {
  const bool is_news = !how_utime_ || how_.task != state_.task ||
                       how_.waypoint_index != guidance.waypoint_index ||
                       how_.layers.size() != guidance.layers.size();
  if (!is_news && utime - *how_utime_ < interval_us_) return;
  how_utime_ = utime;
  how_.utime = utime;
  how_.task = state_.task;
  how_.task_kind = state_.task_kind;
  how_.waypoint_index = guidance.waypoint_index;
  how_.heading_deg = desired.heading_deg;
  how_.speed_mps = desired.speed_mps;
  how_.depth_m = desired.depth_m;
  how_.pitch_deg = RadToDeg(pitch_rad);
  how_.crab_deg = RadToDeg(guidance.crab_rad);
  how_.cross_track_error_m = guidance.cross_track_error_m;
  how_.u_max_mps = guidance.u_max_mps;
  how_.layers.clear();
  for (const LayerShare& share : guidance.layers) {
    guidance_layer_t layer{};
    layer.name = share.name;
    layer.east_mps = share.velocity_mps.x();
    layer.north_mps = share.velocity_mps.y();
    layer.descent_mps = share.velocity_mps.z();
    layer.speed_mps = share.velocity_mps.norm();
    layer.weight = share.weight;
    how_.layers.push_back(layer);
  }
  how_.num_layers = static_cast<int32_t>(how_.layers.size());
  Publish(bus_, guidance_channel_, how_);
}

}  // namespace shoal
