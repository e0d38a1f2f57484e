// Keeps the vessel inside a region, in three zones: core, save and halt.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "op_region". Keeps the vessel inside a region, in three zones: core, save and halt.
struct OpRegionOptions {
  static constexpr std::string_view kKind = "op_region";

  std::vector<Eigen::Vector2d> core_poly = {};  ///< Convex.
  std::vector<Eigen::Vector2d> save_poly = {};  ///< Convex; empty: core_poly grown by save_dist.
  std::vector<Eigen::Vector2d> halt_poly = {};  ///< Convex; empty: core_poly grown by halt_dist.
  double save_dist = -1;                        ///< m; -1: no zone in which it turns back.
  double halt_dist = -1;    ///< m; -1: no border halts; without a save zone, that of the core does.
  double max_depth = 0;     ///< m; 0: off.
  double min_altitude = 0;  ///< m; 0: off.
  double max_time = 0;      ///< s; 0: off.
  double trigger_entry_time = 1;      ///< s inside before leaving counts.
  double trigger_exit_time = 0.5;     ///< s outside before it is a breach.
  bool trigger_on_poly_entry = true;  ///< A start outside is not a breach.
  double turn_rate = 10;              ///< deg/s, for look_ahead; 0: it turns at once.
  double look_ahead = 5;              ///< s; no decision leads out of the region sooner; 0: off.
  bool soft_poly_breach = false;      ///< A breach parks the helm instead of an error.
  double recover_spd = 0.8;           ///< m/s on the way back.
  /// Per cent of course against speed on the way back, 1 to 99; of several, each in one iteration,
  /// by turns.
  std::vector<double> recover_patience = {95};
  bool latch =
      true;  ///< A breach stays an all-stop until the helm is deployed or reset_var is set.
  std::string reset_var = {};                ///< A new setting of it clears a breach and the time.
  std::vector<std::string> save_flag = {};   ///< On leaving the save zone.
  std::vector<std::string> savex_flag = {};  ///< In every iteration outside it.
  std::vector<std::string> breached_poly_flag = {};
  std::vector<std::string> breached_depth_flag = {};
  std::vector<std::string> breached_altitude_flag = {};
  std::vector<std::string> breached_time_flag = {};

  bool operator==(const OpRegionOptions&) const = default;
};

/// Three zones, one in the other: core, save, halt. Inside save it has no preference. Between save
/// and halt, once it has been inside, it prefers the shortest way back to save. After
/// trigger_exit_time outside halt it is breached: an all-stop. Without a halt zone this holds
/// outside core, unless there is a save zone. Limits of depth, altitude and time are breached
/// likewise.
///
/// Once inside, it allows no course and speed that lead out of the halt zone (where there is none:
/// save, or core) within look_ahead, straight on or in the turn to that course, whatever the
/// weights, while there are others; and no depth below max_depth.
///
/// Posts OPREG_ABSOLUTE_PERIM_DIST, OPREG_ABSOLUTE_PERIM_ETA, OPREG_TRAJECTORY_PERIM_DIST,
/// OPREG_TRAJECTORY_PERIM_ETA (whole m and s to the border that breaches; -1: never) and
/// OPREG_TIME_REMAINING.
class OpRegionBehavior final : public BehaviorWith<OpRegionOptions> {
 public:
  explicit OpRegionBehavior(const OpRegionOptions& options);
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  /// Keeps nothing but breaches that last.
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;
  /// Another region: a breach that lasts is over, and entry counts from zero.
  void Reconfigure(const OpRegionOptions& options) override;
  void Clear() override;

 private:
  /// Of one limit: what it states, and the flags that it sets off.
  struct Breach {
    std::string text;
    std::string flag;
  };

  void TakeOver(const OpRegionOptions& options);
  std::optional<Breach> PolygonBreach(const BehaviorInputs& inputs);
  std::optional<Breach> LimitBreach(const BehaviorInputs& inputs) const;
  void AnswerBreach(const std::optional<Breach>& breach, BehaviorAnswer& answer);
  void TurnBack(const BehaviorInputs& inputs, BehaviorAnswer& answer);
  std::vector<double> CoursesBack(const BehaviorInputs& inputs);
  AllowedPart AllowedNow(const BehaviorInputs& inputs) const;
  /// Returns the outermost zone.
  const std::vector<Eigen::Vector2d>& Limit() const {
    return border_m_.empty() ? save_m_ : border_m_;
  }
  void Report(const BehaviorInputs& inputs, BehaviorAnswer& answer) const;

  std::vector<Eigen::Vector2d> save_m_;    ///< Empty: no such zone.
  std::vector<Eigen::Vector2d> border_m_;  ///< Outside it is a breach; empty: none.
  std::optional<double> begun_s_;
  std::optional<double> inside_since_s_;   ///< Of the border.
  std::optional<double> outside_since_s_;  ///< Of the border, after an entry.
  bool has_entered_ = false;               ///< Long enough inside the border.
  bool was_in_save_ = false;
  bool is_saving_ = false;  ///< Outside the save zone.
  int side_ = 0;            ///< Turns to starboard (1) or port (-1) until its bow meets the zone.
  size_t num_iterations_ = 0;
  std::string latched_;    ///< The breach that lasts; empty: none.
  std::string last_text_;  ///< Of the breach in the iteration before.
};

}  // namespace shoal
