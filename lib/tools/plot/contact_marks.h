// Where vehicles of a mission collide and run aground, for marks in figures. As the verdict counts
// them (lib/run/verdict/judge.h), but for obstacles.
//
//   ContactMarks marks(setting.vehicles);
//   if (marks.Move("ALPHA", position_m, altitude_m)) ...    // it has just run aground
//   for (const std::string& name : marks.EndOfStep()) ...   // they have just collided
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/plot/plot_setting.h"
#include "lib/vehicle/vehicle/collision_watch.h"
#include "lib/vehicle/vehicle/grounding_watch.h"

namespace shoal {

class ContactMarks {
 public:
  explicit ContactMarks(const std::vector<PlannedVehicle>& vehicles);

  /// Takes where a vehicle is, x East, y North, z down; names in upper case. `altitude_m` above the
  /// floor; negative: not known. Returns true where it has just run aground. Vehicles that the
  /// mission does not have are passed over. @pre a finite position
  bool Move(std::string_view name, const Eigen::Vector3d& position_m, double altitude_m);

  /// Compares those that moved since the last call. Returns the names, in upper case, of those that
  /// have just collided, the first of each pair.
  std::vector<std::string> EndOfStep();

 private:
  std::vector<std::string> names_;
  std::map<std::string, uint32_t, std::less<>> numbers_;
  std::vector<std::optional<double>> draughts_m_;
  std::vector<Eigen::Vector3d> positions_m_;
  std::vector<uint32_t> moved_;
  CollisionWatch collisions_;
  GroundingWatch groundings_;
};

}  // namespace shoal
