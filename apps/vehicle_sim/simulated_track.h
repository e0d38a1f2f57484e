// A recorded track (lib/mission/track) as vehicle_sim replays it: it goes by the mission's time
// alone.
#pragma once

#include <string>
#include <utility>

#include "apps/vehicle_sim/simulated_craft.h"
#include "lib/mission/file/track_of.h"

namespace shoal {

class SimulatedTrack : public SimulatedCraft {
 public:
  explicit SimulatedTrack(MissionTrack track) : track_(std::move(track)) {}

  /// It goes on from where the track has it at water.time_s, whatever the pose.
  void Reset(const StartPose& pose, const Water& water) override;
  bool Execute(const actuators_t& actuators) override;
  void Rest() override {}
  void Step(const Water& water, double dt_s) override;
  Eigen::Vector3d position_m() const override { return state_.position_m; }
  /// Roll and pitch are 0. The velocity relative to the water is that over ground less the water's.
  void Show(const Water& water, nav_t* nav) const override;
  std::string ActuatorsText() const override;

 private:
  MissionTrack track_;
  ReplayState state_;
};

}  // namespace shoal
