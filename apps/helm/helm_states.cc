#include "apps/helm/helm_states.h"

#include <fmt/format.h>

namespace shoal {

std::string_view Name(HelmMode mode) {
  switch (mode) {
    case HelmMode::kPark:
      return "PARK";
    case HelmMode::kDrive:
      return "DRIVE";
    case HelmMode::kAllStop:
      return "ALL-STOP";
  }
  return "";
}

HelmStates::HelmStates(const Vehicle& vehicle)
    : tasks_(vehicle),
      lost_nav_reason_(fmt::format("no NAV for {:.1f} s", vehicle.helm_options.nav_timeout_s)) {}

HelmMode HelmStates::mode() const {
  if (stopped_by_command_) return HelmMode::kAllStop;
  if (parked_) return HelmMode::kPark;
  return nav_is_lost_ ? HelmMode::kAllStop : HelmMode::kDrive;
}

std::string_view HelmStates::all_stop() const {
  if (stopped_by_command_) return stop_reason_;
  if (parked_) return was_deployed_ ? "parked" : "never deployed";
  return nav_is_lost_ ? std::string_view(lost_nav_reason_) : "clear";
}

ListAim HelmStates::aim() const {
  return {.task = task(),
          .is_interruption = tasks_.is_interrupted(),
          .guidance = guidance() ? &*guidance() : nullptr};
}

std::string HelmStates::Execute(const HelmOrder& order) {
  switch (order.kind) {
    case OrderKind::kAllStop:
      stopped_by_command_ = true;
      stop_reason_ = order.reason.empty() ? "all_stop command" : order.reason;
      return {};
    case OrderKind::kResume:
      if (!stopped_by_command_) return "resume: there is no all-stop by command";
      stopped_by_command_ = false;
      return {};
    case OrderKind::kPark:
      stopped_by_command_ = false;
      parked_ = true;
      return {};
    case OrderKind::kMove:  // It changes what comes, not whether the vehicle moves.
      return tasks_.Move(order.task, order.places);
    default:
      if (stopped_by_command_) {
        return fmt::format("{}: all-stop by command, send resume or park first", Name(order.kind));
      }
      return Drive(order);
  }
}

std::string HelmStates::Drive(const HelmOrder& order) {
  if (order.kind == OrderKind::kSpeed) {
    return task() == nullptr ? "speed: no task runs" : tasks_.ChangeSpeed(order.speed_mps);
  }
  std::string refusal = tasks_.Execute(order);
  if (!refusal.empty()) return refusal;
  parked_ = false;
  was_deployed_ = true;
  return {};
}

void HelmStates::Advance(const std::optional<Fix>& fix, bool nav_is_lost) {
  nav_is_lost_ = nav_is_lost;
  if (mode() == HelmMode::kDrive && fix) {
    tasks_.Advance(*fix);
  } else {
    tasks_.Pause();
  }
}

}  // namespace shoal
