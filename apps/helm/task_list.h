// The tasks of one vehicle: its list, what interrupts the list, and the ending. It is one aim,
// which the arbiter (arbiter.h) weighs with those of the behaviors. Knows of no mode and no bus.
//
//   TaskList tasks(vehicle);
//   std::string refusal = tasks.Execute({.kind = OrderKind::kDeploy});
//   tasks.Advance(fix);                       // While the vessel drives; else tasks.Pause().
//   if (tasks.guidance()) ...
//
// Tasks run in the order of the list; then comes the ending ("end_of_tasks", helm_endings.h), and
// `deploy` starts the list again. The next task begins one step after the last was done, so that
// its end is seen. return, station_keep and goto interrupt the list, `deploy` goes on with it where
// it was left.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/helm/helm_endings.h"
#include "apps/helm/helm_order.h"
#include "lib/mission/model/vehicle.h"
#include "lib/vehicle/guidance/task_runner.h"

namespace shoal {

/// What the tasks of a vehicle want in one step, valid until the next.
struct ListAim {
  const Task* task = nullptr;          ///< nullptr: none runs.
  bool is_interruption = false;        ///< The task is by an order, not one of the list.
  const Guidance* guidance = nullptr;  ///< nullptr: it asks for nothing now.
};

class TaskList {
 public:
  explicit TaskList(const Vehicle& vehicle);

  /// Executes deploy, return, station_keep, goto or task. If that is not possible, it returns the
  /// reason and changes nothing. Other orders are not about tasks and change nothing.
  [[nodiscard]] std::string Execute(const HelmOrder& order);
  /// Changes the speed of the task that runs until the next one begins, or returns the reason why
  /// that is not possible.
  /// @pre a task runs
  [[nodiscard]] std::string ChangeSpeed(double speed_mps);

  /// Moves a task of the list, whether it runs or not, or returns why not and changes nothing. One
  /// that runs goes on: TaskRunner::Move.
  [[nodiscard]] std::string Move(std::string_view name, std::span<const double> places);

  /// Advances to the time of `fix`.
  void Advance(const Fix& fix);
  /// Nothing moves on in this step.
  void Pause();

  /// Returns the task that runs or, after a pause, will go on; nullptr: none.
  const Task* task() const;
  /// True where the task is by an order, not one of the list.
  bool is_interrupted() const { return interruption_.has_value() && !ended_; }
  /// Returns what the task asked for in the last Advance; nothing after a pause or without a task.
  const std::optional<Guidance>& guidance() const { return guidance_; }

 private:
  /// A task and how far it has come.
  struct Errand {
    Task task;
    bool was_paused = false;  ///< Something else happened since the last update.
    bool is_done = false;
    bool was_moved = false;                 ///< The runner does not know it yet.
    std::optional<TaskRunner> runner = {};  ///< Absent until there is a fix to start from.
    std::optional<Ending> ending = {};      ///< Present: the task is to follow from that fix.
  };

  void Interrupt(Errand errand);
  void StartListAt(size_t index);
  void EndList();
  void GoOnFrom(const Errand& finished, const Fix& fix);
  Errand* Current();
  const Errand* Current() const;

  std::optional<double> speed_mps_;  ///< By the order `speed`, for the errand that runs.
  std::optional<Guidance> guidance_;
  Guidance last_guidance_;              ///< The last while the vessel was driving.
  std::optional<Errand> listed_;        ///< The task of the list; absent: not begun, or ended.
  std::optional<Errand> interruption_;  ///< Runs instead of it.

  HelmEndings endings_;
  size_t list_index_ = 0;
  std::vector<Task> tasks_;
  ReturnTask return_task_;
  bool ended_ = false;         ///< The interruption is what comes after the list.
  const bool behaviors_lead_;  ///< There are behaviors and no tasks: an empty list is not an end.
};

}  // namespace shoal
