// Warns of missions in which nothing happens that could be judged: no vehicle is deployed, none has
// a task, none can receive another; and of vehicles that touch before they have left.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/mission/file/validate.h"
#include "lib/mission/toml/suggest.h"
#include "lib/vehicle/vehicle/collision_watch.h"

namespace shoal {
namespace {

/// Orders that take a helm out of PARK.
constexpr std::array<std::string_view, 5> kDeploying = {"deploy", "return", "station_keep", "goto",
                                                        "task"};
/// Those of them that move a vehicle which has no task.
constexpr std::array<std::string_view, 2> kMoving = {"return", "goto"};

/// True where an event gives one of these orders, or sends a node message, which may be an order.
template <size_t kCount>
bool EventsOrder(const Mission& mission, const std::array<std::string_view, kCount>& orders) {
  return std::any_of(mission.events.begin(), mission.events.end(), [&](const Event& event) {
    if (std::holds_alternative<MessageEvent>(event.what)) return true;
    const auto* command = std::get_if<CommandEvent>(&event.what);
    return command != nullptr &&
           std::find(orders.begin(), orders.end(), command->command) != orders.end();
  });
}

void WarnWhereNoneMoves(const Mission& mission, const TablePlace& file) {
  if (mission.MayBeSteeredFromOutside()) return;
  const auto is_deployed = [](const Vehicle& vehicle) {
    return vehicle.helm_options.deploy_at_start;
  };
  const auto has_task = [](const Vehicle& vehicle) {
    return !vehicle.tasks.empty() || !vehicle.behaviors.empty();
  };
  const std::vector<Vehicle>& vehicles = mission.vehicles;
  if (!std::any_of(vehicles.begin(), vehicles.end(), is_deployed) &&
      !EventsOrder(mission, kDeploying)) {
    file.Below("mission").Warn(
        "",
        "no vehicle is ever deployed, so every helm stays in PARK: write helm_options = "
        "{deploy_at_start = true} in a [[vehicle]], or an [[event]] with command = \"deploy\"");
  } else if (!std::any_of(vehicles.begin(), vehicles.end(), has_task) &&
             !EventsOrder(mission, kMoving)) {
    file.Below("mission").Warn("",
                               "no vehicle has a task, so those that are deployed keep station: "
                               "write a [[vehicle.task]]");
  }
}

void WarnWhereNoneIsReceived(const Mission& mission, const TablePlace& file) {
  if (mission.broker != Provider::kShoal || mission.vehicles.size() < 2) return;
  const auto num_reporting =
      std::count_if(mission.vehicles.begin(), mission.vehicles.end(),
                    [&](const Vehicle& vehicle) { return mission.IsReported(vehicle); });
  if (num_reporting > 1) return;
  const auto receiver = std::find_if(
      mission.vehicles.begin(), mission.vehicles.end(),
      [&](const Vehicle& vehicle) { return num_reporting == 0 || mission.IsReported(vehicle); });
  file.Below("vehicle", static_cast<size_t>(receiver - mission.vehicles.begin()))
      .Warn("", receiver->name + " will receive no report: no other vehicle has a node_reporter");
}

void WarnOfContactAtTheStart(const Mission& mission, const TablePlace& file) {
  if (mission.collisions == CollisionVerdict::kAllowed) return;
  std::vector<double> lengths_m;
  std::vector<Eigen::Vector3d> positions_m;
  std::vector<uint32_t> simulated;
  for (const Vehicle& vehicle : mission.vehicles) {
    const StartPose& start = vehicle.start;
    if (vehicle.sim == Provider::kShoal)
      simulated.push_back(static_cast<uint32_t>(lengths_m.size()));
    lengths_m.push_back(vehicle.length_m);
    positions_m.emplace_back(start.x_m, start.y_m, start.depth_m);
  }
  CollisionWatch watch(lengths_m);
  const std::span<const Collision> collisions = watch.Look(simulated, positions_m);
  if (collisions.empty()) return;
  const Collision& first = collisions.front();
  file.Below("vehicle", first.second)
      .Warn("start",
            fmt::format("{} starts {:.2f} m from {}, less than {:.2f} m: a collision{}, by "
                        "which the mission fails; start it elsewhere, or write [mission] "
                        "collisions = \"allowed\"",
                        mission.vehicles[first.second].name, first.range_m,
                        mission.vehicles[first.first].name, first.allowed_m,
                        collisions.size() == 1 ? std::string()
                                               : fmt::format(", one of {}", collisions.size())));
}

}  // namespace

void WarnOfConduct(const Mission& mission, const TablePlace& file) {
  if (!file.IsSound()) return;
  WarnWhereNoneMoves(mission, file);
  WarnWhereNoneIsReceived(mission, file);
  WarnOfContactAtTheStart(mission, file);
}

}  // namespace shoal
