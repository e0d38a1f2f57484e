// Whether vehicles start in the ground of the mission's own map, or are sent into it.
#include "lib/mission/file/validate_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/vehicle/guidance/survey_lanes.h"

namespace shoal {

namespace {

/// Ways are looked at every metre; those of long tasks in this many places.
constexpr double kMaxLooks = 20'000;
/// A vehicle that speeds up, turns and is pushed aside takes this much longer than its way at its
/// speed.
constexpr double kSlower = 1.5;

/// The first place of a way where the floor lies at the keel or above it.
struct Touch {
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero();  ///< z: as deep as the way is there.
  double floor_m = 0;
  double way_m = 0;  ///< From where the vehicle starts.
};

std::optional<Touch> FirstTouch(const SeaFloor& floor, std::span<const Eigen::Vector3d> points_m,
                                double draught_m) {
  double length_m = 0;
  for (size_t i = 1; i < points_m.size(); ++i) length_m += (points_m[i] - points_m[i - 1]).norm();
  const double step_m = std::max(1.0, length_m / kMaxLooks);
  double passed_m = 0;
  for (size_t i = 1; i < points_m.size(); ++i) {
    const Eigen::Vector3d leg_m = points_m[i] - points_m[i - 1];
    const auto num_looks = static_cast<int>(std::ceil(leg_m.norm() / step_m));
    for (int k = 1; k <= num_looks; ++k) {
      Touch touch = {.place_m = points_m[i - 1] + leg_m * k / num_looks,
                     .way_m = passed_m + leg_m.norm() * k / num_looks};
      // A vehicle that dives to the depth of its next point is no deeper than the deeper end, and
      // no less deep than the other.
      touch.place_m.z() = std::min(points_m[i - 1].z(), points_m[i].z());
      touch.floor_m = floor.DepthAt(touch.place_m.head<2>());
      if (touch.floor_m <= touch.place_m.z() + draught_m) return touch;
    }
    passed_m += leg_m.norm();
  }
  return std::nullopt;
}

std::string FloorText(double floor_m) {
  return floor_m <= 0 ? std::string("the map has land")
                      : fmt::format("the floor is at {:.4g} m", floor_m);
}

/// How deep a vehicle reaches there, for messages.
std::string KeelText(const Vehicle& vehicle, double depth_m) {
  const double draught_m = DraughtOf(vehicle);
  return draught_m > 0 ? fmt::format("with a draught of {:g} m", draught_m)
                       : fmt::format("at {:.4g} m depth", depth_m);
}

constexpr char kRemedy[] = "or write [mission] grounding = \"allowed\"";

class GroundCheck {
 public:
  GroundCheck(const Mission& mission, const SeaFloor& floor) : mission_(mission), floor_(floor) {}

  void CheckStart(const Vehicle& vehicle, const TablePlace& place) const {
    const Eigen::Vector3d start_m = StartOf(vehicle);
    const double floor_m = floor_.DepthAt(start_m.head<2>());
    if (floor_m > start_m.z() + DraughtOf(vehicle)) return;
    Note(place, "start", true,
         fmt::format("{} starts aground: at ({:g}, {:g}) {}, {}; start it elsewhere, {}",
                     vehicle.name, start_m.x(), start_m.y(), KeelText(vehicle, start_m.z()),
                     FloorText(floor_m), kRemedy));
  }

  void CheckTasks(const Vehicle& vehicle, const TablePlace& place) const {
    Eigen::Vector3d from_m = StartOf(vehicle);
    double before_s = 0;
    bool is_sure = vehicle.helm == Provider::kShoal && vehicle.helm_options.deploy_at_start &&
                   vehicle.behaviors.empty() && mission_.events.empty();
    for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
      const TablePlace table = place.Below("task", k);
      const std::optional<TaskWay> way = table.IsSound() ? WayOf(vehicle.tasks[k]) : std::nullopt;
      if (!way || way->points_m.empty()) {
        is_sure = false;  // Where the vehicle is when this task is over is not known.
        continue;
      }
      std::vector<Eigen::Vector3d> points_m = {from_m};
      points_m.insert(points_m.end(), way->points_m.begin(), way->points_m.end());
      if (const auto touch = FirstTouch(floor_, points_m, DraughtOf(vehicle))) {
        const double time_s = before_s + kSlower * touch->way_m / std::max(way->speed_mps, 1e-3);
        NoteTouch(vehicle, place, table, *way, *touch, is_sure && time_s <= mission_.duration_s);
        return;
      }
      for (size_t i = 1; i < points_m.size(); ++i) {
        before_s +=
            kSlower * (points_m[i] - points_m[i - 1]).norm() / std::max(way->speed_mps, 1e-3);
      }
      from_m = points_m.back();
    }
  }

 private:
  static Eigen::Vector3d StartOf(const Vehicle& vehicle) {
    return {vehicle.start.x_m, vehicle.start.y_m, vehicle.start.depth_m};
  }

  void NoteTouch(const Vehicle& vehicle, const TablePlace& place, const TablePlace& table,
                 const TaskWay& way, const Touch& touch, bool is_sure) const {
    const bool is_land = touch.floor_m <= 0;
    const std::string where = fmt::format(
        "{}'s way to here leads {} at ({:.1f}, {:.1f}){}", vehicle.name,
        is_land ? "over land" : KeelText(vehicle, touch.place_m.z()), touch.place_m.x(),
        touch.place_m.y(), is_land ? std::string() : ", where " + FloorText(touch.floor_m));
    const auto* auv = std::get_if<Remus100Options>(&vehicle.model);
    if (auv != nullptr && touch.floor_m > auv->seabed_clearance_m && auv->seabed_clearance_m > 0) {
      // A user who writes the clearance wants the vehicle to follow the floor.
      if (place.Below("remus100").Has("seabed_clearance_m")) return;
      table.Warn(
          way.key,
          fmt::format("{}: it stays seabed_clearance_m = {:g} above the floor; write that key "
                      "in [vehicle.remus100] if you mean it",
                      where, auv->seabed_clearance_m));
      return;
    }
    Note(table, way.key, is_sure,
         fmt::format("{}: it runs aground; lead it around, {}", where, kRemedy));
  }

  void Note(const TablePlace& place, std::string_view key, bool is_sure, std::string text) const {
    if (is_sure && mission_.grounding == GroundingVerdict::kFail) {
      place.WarnOfFailure(key, std::move(text));
    } else {
      place.Warn(key, std::move(text));
    }
  }

  const Mission& mission_;
  const SeaFloor& floor_;
};

}  // namespace

void ValidateGround(const Mission& mission, const SeaFloor& floor, const TablePlace& file) {
  const GroundCheck check(mission, floor);
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    const TablePlace place = file.Below("vehicle", i);
    if (vehicle.sim == Provider::kNone || !FactsOfModel(vehicle.model).passive.empty()) continue;
    if (!place.IsSound()) continue;
    check.CheckStart(vehicle, place);
    check.CheckTasks(vehicle, place);
  }
}

}  // namespace shoal
