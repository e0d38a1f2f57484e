// What a helm is doing and why: its states, its task list, its all-stops. Knows of no bus.
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
//
// Tasks run in the order of the list; then comes the ending ("end_of_tasks", helm_endings.h), and
// `deploy` starts the list again. The next task begins one step after the last was done, so that
// its end is seen. return, station_keep and goto interrupt the list, `deploy` goes on with it where
// it was left.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/helm/helm_endings.h"
#include "apps/helm/helm_order.h"
#include "lib/mission/model/mission.h"
#include "lib/vehicle/guidance/task_runner.h"

namespace shoal {

enum class HelmMode { kPark, kDrive, kAllStop };

/// Returns "PARK", "DRIVE" or "ALL-STOP".
std::string_view Name(HelmMode mode);

class HelmStates {
 public:
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
  const Task* task() const;
  /// True where the task is by an order, not one of the list.
  bool is_interrupted() const { return interruption_.has_value() && !ended_; }
  /// Returns what the task asked for in the last Advance, or nothing unless the vessel is driving.
  const std::optional<Guidance>& guidance() const { return guidance_; }

 private:
  /// A task and how far it has come.
  struct Errand {
    Task task;
    bool was_paused = false;  ///< Something else happened since the last update.
    bool is_done = false;
    std::optional<TaskRunner> runner = {};  ///< Absent until there is a fix to start from.
    std::optional<Ending> ending = {};      ///< Present: the task is to follow from that fix.
  };

  std::string Drive(const HelmOrder& order);
  std::string ChangeSpeed(double speed_mps);
  void Interrupt(Errand errand);
  void StartListAt(size_t index);
  void EndList();
  void GoOnFrom(const Errand& finished, const Fix& fix);
  Errand* Current();
  const Errand* Current() const;

  bool parked_ = true;
  bool was_deployed_ = false;
  bool stopped_by_command_ = false;
  bool nav_is_lost_ = false;
  std::optional<double> speed_mps_;  ///< By the order `speed`, for the errand that runs.
  std::optional<Guidance> guidance_;
  Guidance last_guidance_;              ///< The last while the vessel was driving.
  std::optional<Errand> listed_;        ///< The task of the list; absent: not begun, or ended.
  std::optional<Errand> interruption_;  ///< Runs instead of it.

  HelmEndings endings_;
  size_t list_index_ = 0;
  std::vector<Task> tasks_;
  ReturnTask return_task_;
  std::string lost_nav_reason_;
  std::string stop_reason_;
  bool ended_ = false;         ///< The interruption is what comes after the list.
  const bool behaviors_lead_;  ///< There are behaviors and no tasks: an empty list is no end.
};

}  // namespace shoal
