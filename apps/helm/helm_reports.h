// What a helm publishes about what it does: HELM_STATE, and of an underwater vehicle GUIDANCE, each
// on change and every state_interval_s.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/vehicle.h"
#include "lib/run/run/status_page.h"
#include "lib/vehicle/guidance/task_runner.h"

namespace shoal {

class Arbiter;
class HelmStates;

/// The words of HELM_STATE, not copied: most steps have nothing new to publish.
struct StateWords {
  std::string_view state;
  std::string_view all_stop;
  std::string_view task = {};
  std::string_view task_kind = {};
};

/// Returns the words after a step. While the helm drives, the arbiter knows why it does not move,
/// and which behavior leads where no task runs.
[[nodiscard]] StateWords WordsOf(const HelmStates& states, const Arbiter& arbiter);

class HelmReports {
 public:
  HelmReports(const Vehicle& vehicle, Bus& bus);

  /// Publishes HELM_STATE where it is due, and notes in `log` what a user wants to know of it.
  /// `guidance`: what is steered by; nullptr: nothing is.
  void PublishState(int64_t utime, const StateWords& words, const Guidance* guidance,
                    const nav_t& nav, StatusLog* log);
  /// Publishes GUIDANCE where it is due: what is steered by, and the pitch and the other values
  /// that the autopilots get.
  void PublishGuidance(int64_t utime, const Guidance& guidance, double pitch_rad,
                       const desired_t& desired);

  /// Returns HELM_STATE as published last.
  const helm_state_t& state() const { return state_; }
  /// Returns GUIDANCE as published last; nullptr: it never was.
  const guidance_t* guidance() const { return how_utime_ ? &how_ : nullptr; }

 private:
  Bus& bus_;
  const int64_t interval_us_;
  const Channel<helm_state_t> state_channel_;
  const Channel<guidance_t> guidance_channel_;
  std::optional<int64_t> state_utime_;
  std::optional<int64_t> how_utime_;
  helm_state_t state_{};
  guidance_t how_{};
};

}  // namespace shoal
