#include "apps/helm/task_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "lib/run/run/status_page.h"
#include "lib/vehicle/guidance/moved_task.h"

namespace shoal {

TaskList::TaskList(const Vehicle& vehicle)
    : endings_(vehicle),
      tasks_(vehicle.tasks),
      return_task_(vehicle.return_task),
      behaviors_lead_(!vehicle.behaviors.empty() && vehicle.tasks.empty()) {}

const Task* TaskList::task() const {
  const Errand* current = Current();
  return current == nullptr ? nullptr : &current->task;
}

std::string TaskList::Execute(const HelmOrder& order) {
  switch (order.kind) {
    case OrderKind::kDeploy:
      if (interruption_) speed_mps_.reset();
      interruption_.reset();
      if (!listed_) StartListAt(0);
      break;
    case OrderKind::kReturn:
      Interrupt({.task = {.name = "return", .what = return_task_}});
      break;
    case OrderKind::kStationKeep:
      Interrupt(
          {.task = {.name = "station_keep", .what = StationKeepTask{}}, .ending = Ending::kHold});
      break;
    case OrderKind::kGoto: {
      WaypointsTask way;
      way.points_m = {order.point_m};
      way.speed_mps = return_task_.speed_mps;
      Interrupt({.task = {.name = "goto", .what = way}});
      break;
    }
    case OrderKind::kTask: {
      const auto found = std::find_if(tasks_.begin(), tasks_.end(),
                                      [&](const Task& task) { return task.name == order.task; });
      if (found == tasks_.end()) {
        return fmt::format("task: there is no task '{}'", Printable(order.task));
      }
      interruption_.reset();
      StartListAt(static_cast<size_t>(found - tasks_.begin()));
      break;
    }
    default:
      break;
  }
  return {};
}

std::string TaskList::ChangeSpeed(double speed_mps) {
  if (const auto* track = std::get_if<TargetTrackTask>(&task()->what)) {
    return fmt::format(
        "speed: the task '{}' takes its speed from its law; order the speed of {}, which it "
        "follows",
        task()->name, track->target);
  }
  speed_mps_ = speed_mps;
  return {};
}

std::string TaskList::Move(std::string_view name, std::span<const double> places) {
  const auto found = std::find_if(tasks_.begin(), tasks_.end(),
                                  [&](const Task& task) { return task.name == name; });
  if (found == tasks_.end()) return fmt::format("move: there is no task '{}'", Printable(name));
  Result<Task> moved = MovedTask(*found, places);
  if (!moved.ok()) return fmt::format("move: {}", moved.error());
  *found = std::move(*moved);
  if (listed_ && list_index_ == static_cast<size_t>(found - tasks_.begin())) {
    listed_->task = *found;
    listed_->was_moved = listed_->runner.has_value();
  }
  return {};
}

void TaskList::Interrupt(Errand errand) {
  if (listed_) listed_->was_paused = true;
  interruption_ = std::move(errand);
  ended_ = false;
  speed_mps_.reset();
}

void TaskList::StartListAt(size_t index) {
  speed_mps_.reset();
  list_index_ = index;
  if (index == tasks_.size()) {
    EndList();
  } else {
    listed_ = Errand{.task = tasks_[index]};
  }
}

void TaskList::EndList() {
  const Ending ending = endings_.AfterList(tasks_.empty() ? nullptr : &tasks_.back());
  listed_.reset();
  if (behaviors_lead_) return;
  Interrupt(
      {.task = {.name = std::string(kEndOfTasks), .what = StationKeepTask{}}, .ending = ending});
  ended_ = true;
}

// `finished` is the current errand, and does not outlive this call.
void TaskList::GoOnFrom(const Errand& finished, const Fix& fix) {
  if (!interruption_) {
    StartListAt(list_index_ + 1);
    return;
  }
  // Of the interruptions only the way to a point ever ends.
  const Eigen::Vector2d& point_m = std::get<WaypointsTask>(finished.task.what).points_m.front();
  Interrupt({.task = {.name = finished.task.name, .what = endings_.HoldAt(point_m, fix)}});
}

TaskList::Errand* TaskList::Current() {
  if (interruption_) return &*interruption_;
  return listed_ ? &*listed_ : nullptr;
}

const TaskList::Errand* TaskList::Current() const { return const_cast<TaskList*>(this)->Current(); }

void TaskList::Pause() {
  guidance_.reset();
  if (Errand* paused = Current()) paused->was_paused = true;
}

void TaskList::Advance(const Fix& fix) {
  guidance_.reset();
  const bool is_ending = interruption_ && ended_;  // An ending has nothing after it.
  if (const Errand* finished = Current(); finished != nullptr && finished->is_done && !is_ending) {
    GoOnFrom(*finished, fix);
  }
  Errand* current = Current();
  if (current == nullptr) return;
  if (!current->runner) {
    if (current->ending) {
      current->task.what = endings_.TaskFor(*current->ending, fix, last_guidance_);
    }
    current->runner.emplace(endings_.AtItsDepth(current->task.what), fix);
  } else if (current->was_moved) {
    current->runner->Move(endings_.AtItsDepth(current->task.what), fix);
  } else if (current->was_paused) {
    current->runner->Rejoin(fix);
  }
  current->was_moved = false;
  current->was_paused = false;
  guidance_ = current->runner->Update(fix);
  current->is_done = guidance_->done;
  if (speed_mps_ && guidance_->speed_mps > 0) {
    guidance_->speed_mps = *speed_mps_;
    guidance_->propeller_rpm.reset();  // The revolutions are those of the speed.
  }
  const Guidance before = std::exchange(last_guidance_, *guidance_);
  if (last_guidance_.speed_mps <= 0) {  // At its end: what counts is how it was under way.
    last_guidance_.speed_mps = before.speed_mps;
    last_guidance_.propeller_rpm = before.propeller_rpm;
  }
}

}  // namespace shoal
