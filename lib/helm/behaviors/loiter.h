// Goes round a convex polygon.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/behavior.h"
#include "lib/vehicle/guidance/route_rounds.h"
#include "lib/vehicle/guidance/waypoint_capture.h"

namespace shoal {

/// kind = "loiter". Goes round a convex polygon.
struct LoiterOptions {
  static constexpr std::string_view kKind = "loiter";

  std::vector<Eigen::Vector2d> polygon = {};  ///< Convex; at least three corners.
  double speed = 0;                           ///< m/s.
  double speed_alt = -1;  ///< m/s, instead of speed where use_alt_speed; -1: none.
  bool use_alt_speed = false;
  std::string clockwise =
      "true";                ///< "true", "false" or "best" (decided when it acquires the polygon).
  double radius = 3;         ///< m; a vertex is reached closer than this.
  double slip_radius = 15;   ///< m.
  double acquire_dist = 10;  ///< m from the polygon; beyond, it (re)acquires a vertex.
  bool center_activate = false;  ///< Its centre moves to where the vessel is when it begins to run.
  double spiral_factor =
      -2;                 ///< Reserved by others; 0 or less: off. Radius grows by it each round.
  double patience = 50;   ///< Per cent of course against speed, 1 to 99.
  double slingshot = -1;  ///< Degrees gone round after which it ends; -1: never.
  std::string post_suffix = {};
  std::string ipf_type = "zaic";  ///< zaic or zaic_spd.

  bool operator==(const LoiterOptions&) const = default;
};

/// Outside by more than acquire_dist it chooses in every iteration the vertex which it meets most
/// tangentially; else it goes from vertex to vertex. Posts LOITER_INDEX, LOITER_MODE,
/// LOITER_ACQUIRE, LOITER_DIST_TO_POLY and LOITER_ETA_TO_POLY, each with post_suffix.
///
/// Modes, by the distance to the polygon (negative inside) and acquire_dist:
///
///   acquiring_external   outside by more, before it was ever stable; recovering_external after
///   acquiring_internal   inside by more, alike
///   stable               in between
class LoiterBehavior final : public BehaviorWith<LoiterOptions> {
 public:
  explicit LoiterBehavior(const LoiterOptions& options);
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;
  /// Another polygon or direction: acquires again. Else it goes on.
  void Reconfigure(const LoiterOptions& options) override;

 private:
  void Begin(const BehaviorInputs& inputs);
  /// Puts the corners into the direction of travel.
  void Arrange(bool clockwise);
  size_t TangentialVertex(const Eigen::Vector2d& position_m) const;
  void GoRound(const BehaviorInputs& inputs);
  void Spiral();
  std::string Mode(double distance_m) const;
  void Report(const BehaviorInputs& inputs, double distance_m, BehaviorAnswer& answer) const;

  std::vector<Eigen::Vector2d> polygon_m_;   ///< As given, or moved to where it was activated.
  std::vector<Eigen::Vector2d> vertices_m_;  ///< In the direction of travel.
  bool clockwise_ = true;
  bool is_new_ = true;                      ///< Since it was idle or has got another polygon.
  bool is_acquired_ = false;                ///< Was stable since.
  RouteRounds rounds_;                      ///< Of the vertices.
  std::optional<WaypointCapture> capture_;  ///< Absent: while it acquires.
  std::optional<double> bearing_deg_;       ///< From the centre, while it goes round.
  double gone_round_deg_ = 0;
};

}  // namespace shoal
