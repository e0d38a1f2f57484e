#include "lib/bus/bus/waypoint_arrival.h"

#include <fmt/format.h>

namespace shoal {

std::string ArrivalText(const helm_state_t& before, const helm_state_t& now) {
  const bool is_under_way = before.state == "DRIVE" && now.state == "DRIVE";
  if (!is_under_way || before.task.empty() || before.task != now.task) return {};
  if (before.waypoint_index < 0 || now.waypoint_index < 0) return {};
  if (before.waypoint_index == now.waypoint_index && before.laps_done >= now.laps_done) return {};
  return fmt::format("waypoint {} of {} reached", before.waypoint_index + 1, before.task);
}

}  // namespace shoal
