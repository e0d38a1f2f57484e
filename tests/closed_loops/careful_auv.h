// One AUV as a mission has it, without bus and processes: a Remus 100 with its autopilots, a sonar,
// and a task with layers. For tests of what it keeps clear of.
#pragma once

#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/sea/ocean/sea_floor.h"
#include "lib/vehicle/control/auv_pilot.h"
#include "lib/vehicle/guidance/echo_memory.h"
#include "lib/vehicle/guidance/task_runner.h"
#include "lib/vehicle/sensors/forward_looking_sonar.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal {

/// What there is besides the AUV.
struct SeaAround {
  Eigen::Vector3d current_mps = Eigen::Vector3d::Zero();
  std::vector<SonarTarget> wrecks = {};  ///< They stay where they are.
  std::vector<Polygon> walls_m = {};
  SeaFloor floor = {};
};

class CarefulAuv {
 public:
  static constexpr double kStep_s = 0.05;
  static constexpr int kStepsPerPing = 4;

  CarefulAuv(int id, const TaskRunner::What& task, const Eigen::Vector3d& start_m,
             double heading_rad, double speed_mps, const SeaAround& sea)
      : sea_(sea),
        id_(id),
        memory_s_(MemoryOf(task)),
        runner_(task,
                {.position_m = start_m.head<2>(), .heading_rad = heading_rad, .z_m = start_m.z()}),
        beams_(sonar_.beam_count()) {
    const double psi_rad = PsiFromHeading(heading_rad);
    state_.eta << start_m, 0, 0, psi_rad;
    state_.nu[0] = speed_mps;
    state_.velocity_mps = {speed_mps * std::cos(psi_rad), speed_mps * std::sin(psi_rad), 0};
    pilot_.Start(psi_rad, start_m.z());
  }

  Neighbour neighbour() const {
    return {.id = id_, .position_m = state_.eta.head<3>(), .velocity_mps = state_.velocity_mps};
  }
  const Guidance& guidance() const { return guidance_; }
  const Surroundings& surroundings() const { return around_; }

  /// One step among `others`, the first of which is the target where `follows`.
  void Step(std::vector<Neighbour> others, bool follows = false) {
    others_ = std::move(others);
    time_s_ = ++num_steps_ * kStep_s;
    around_ = {.own = neighbour(), .current_mps = sea_.current_mps};
    if (follows) around_.target = others_.front();
    around_.group = std::span(others_).subspan(follows ? 1 : 0);
    Look();
    around_.sonar = echoes_;
    const AuvMotion motion = {.z_m = state_.eta[2],
                              .theta_rad = state_.eta[4],
                              .psi_rad = state_.eta[5],
                              .q_radps = state_.nu[4],
                              .r_radps = state_.nu[5],
                              .speed_mps = state_.nu.head<3>().norm()};
    guidance_ = runner_.Update({.position_m = state_.eta.head<2>(),
                                .heading_rad = HeadingFromPsi(state_.eta[5]),
                                .time_s = time_s_,
                                .z_m = state_.eta[2],
                                .surroundings = &around_});
    const double psi_rad = PsiFromHeading(guidance_.heading_rad);
    const AuvDeflections fins =
        guidance_.pitch_rad ? pilot_.KeepHeadingAndPitch(motion, psi_rad, *guidance_.pitch_rad,
                                                         DepthBound(), kStep_s)
                            : pilot_.KeepHeadingAndDepth(motion, psi_rad, guidance_.z_m.value_or(0),
                                                         DepthBound(), kStep_s);
    const double rpm = guidance_.speed_mps > 0 ? RpmForSpeed(auv_, guidance_.speed_mps) : 0;
    state_ = shoal::Step(auv_, state_, {fins.rudder_rad, fins.stern_plane_rad, rpm},
                         {.current_mps = sea_.current_mps}, kStep_s);
  }

 private:
  static double MemoryOf(const TaskRunner::What& task) {
    const VelocityCascade* cascade = nullptr;
    if (const auto* path = std::get_if<PathFollowTask>(&task)) cascade = &path->cascade;
    if (const auto* track = std::get_if<TargetTrackTask>(&task)) {
      cascade = std::get_if<VelocityCascade>(&track->track.law);
    }
    double memory_s = 0;
    for (const VelocityLayer& layer : cascade->layers) {
      if (const SurvivalSonarLayer* sonar = SonarOf(layer)) memory_s = sonar->memory_s;
    }
    return memory_s;
  }

  void Look() {
    if (num_steps_ % kStepsPerPing != 0 && num_steps_ != 1) return Recall();
    sonar_.Ping({state_.eta.head<3>(), state_.eta[3], state_.eta[4], state_.eta[5]},
                {.floor = sea_.floor, .vehicles = sea_.wrecks, .walls_m = sea_.walls_m}, num_steps_,
                beams_);
    seen_.clear();
    for (const SonarBeam& beam : beams_) {
      if (beam.is_echo) seen_.push_back({.direction = beam.direction, .range_m = beam.range_m});
    }
    memory_.Take(state_.eta.head<3>(), seen_, time_s_);
    Recall();
  }

  void Recall() {
    echoes_ = seen_;
    if (memory_s_ <= 0) return;
    const auto known = memory_.Recall(state_.eta.head<3>(), time_s_, memory_s_);
    echoes_.insert(echoes_.end(), known.begin(), known.end());
  }

  const SeaAround& sea_;
  int id_;
  double memory_s_;
  Remus100 auv_ = BuildRemus100({});
  AuvPilot pilot_{DefaultRemusPilot()};
  ForwardLookingSonar sonar_{SonarParams{}};
  EchoMemory memory_;
  TaskRunner runner_;
  Remus100State state_;
  Guidance guidance_;
  Surroundings around_;
  std::vector<Neighbour> others_;
  std::vector<SonarEcho> seen_, echoes_;
  std::vector<SonarBeam> beams_;
  int num_steps_ = 0;
  double time_s_ = 0;
};

}  // namespace shoal
