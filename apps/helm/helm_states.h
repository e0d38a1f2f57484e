// Whether a helm drives, and why not: its modes, and the orders that change them. What it does
// while it drives is asked of its TaskList (task_list.h). Knows of no bus.
//
//                 deploy, return, station_keep, goto, task
//      +------+ ---------------------------------------------> +-------+
//      | PARK |                                                | DRIVE |
//      +------+ <--------------------------------------------- +-------+
//        ^  |                      park                          |   ^
//        |  | all_stop                       all_stop, NAV lost  |   | resume, NAV back
//        |  v                                                    v   |
//        |  +----------------------------------------------------------+
//        +--|                          ALL-STOP                        |
//      park +----------------------------------------------------------+
//      (resume, where it was parked before)
//
// An all-stop by command ends by `resume` or `park` only; until then it refuses every order to
// move. One for want of NAV ends by itself. After either the helm goes on with what it did.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/helm/helm_order.h"
#include "apps/helm/task_list.h"
#include "lib/mission/model/vehicle.h"

namespace shoal {

enum class HelmMode { kPark, kDrive, kAllStop };

/// Returns "PARK", "DRIVE" or "ALL-STOP".
std::string_view Name(HelmMode mode);

class HelmStates {
 public:
  /// In PARK.
  explicit HelmStates(const Vehicle& vehicle);

  /// Executes `order`, or returns why not and changes nothing. An empty text: executed.
  [[nodiscard]] std::string Execute(const HelmOrder& order);

  /// Advances to the time of `fix`. Without a fix nothing moves on; `nav_is_lost`: this has lasted
  /// too long.
  void Advance(const std::optional<Fix>& fix, bool nav_is_lost);

  HelmMode mode() const;
  /// Returns "clear", or why the vessel does not move: "never deployed", "parked", "all_stop
  /// command" or the reason that came with it, "no NAV for 2.0 s".
  std::string_view all_stop() const;
  /// Returns the task that runs or, in ALL-STOP, will go on; nullptr: none.
  const Task* task() const { return parked_ ? nullptr : tasks_.task(); }
  /// Returns what the task asked for in the last Advance, or nothing unless the vessel is driving.
  const std::optional<Guidance>& guidance() const { return tasks_.guidance(); }
  /// Returns the same as one aim, valid until the next Execute or Advance.
  ListAim aim() const;

 private:
  std::string Drive(const HelmOrder& order);

  bool parked_ = true;
  bool was_deployed_ = false;
  bool stopped_by_command_ = false;
  bool nav_is_lost_ = false;
  TaskList tasks_;
  std::string lost_nav_reason_;
  std::string stop_reason_;
};

}  // namespace shoal
