// One behavior of a helm: what it is given in every iteration, and what it answers.
//
// A behavior is in its own file: a struct of options with its kKind (the word of mission files) and
// a class derived from Behavior. Conditions, flags, durations, updates and spawning are the same
// for all of them: BehaviorSet (behavior_set.h) sees to those and calls Run only where the
// conditions hold.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "lib/helm/behaviors/contact.h"
#include "lib/helm/colregs/encounter_geometry.h"
#include "lib/helm/decision/allowed.h"
#include "lib/helm/decision/objective.h"
#include "lib/helm/modes/variables.h"

namespace shoal {

/// Own vehicle as its navigation has it.
struct OwnMotion {
  VesselMotion motion = {};
  double depth_m = 0;
  double altitude_m = -1;  ///< Above the floor; negative: not known.
};

/// An obstacle that does not move.
struct Obstacle {
  std::string id;
  std::vector<Eigen::Vector2d> polygon_m;  ///< Convex; at least three corners.

  bool operator==(const Obstacle&) const = default;
};

/// What a behavior is given.
struct BehaviorInputs {
  double time_s = 0;  ///< Of the mission; never decreases.
  OwnMotion own = {};
  const Domain* domain = nullptr;
  const Contacts* contacts = nullptr;
  const std::vector<Obstacle>* obstacles = nullptr;
  const Variables* variables = nullptr;
  /// What the helm decided in the iteration before; absent: nothing.
  std::optional<double> last_course_deg = {};
  std::optional<double> last_speed_mps = {};
  bool avoids = false;      ///< In the iteration before it had a contact to keep clear of.
  bool goals_rest = false;  ///< Behaviors that are not constraints are idle: an order steers.
};

/// What a contact behavior judges its contact to be, for pages, logs and scores.
struct ContactRole {
  std::string contact;
  std::string role;  ///< "give-way:stern", "head-on", "avoid", "trail", ...
  std::string rule;  ///< Of the collision regulations: "14"; empty: none.
  double range_m = 0;
  double cpa_m = 0;
  double age_s = 0;
};

/// Things of a behavior that are drawn.
struct BehaviorView {
  std::vector<Eigen::Vector2d> points_m = {};
  bool closed = false;
  std::optional<Eigen::Vector2d> steers_for_m = {};
};

/// What a behavior answers in one iteration.
struct BehaviorAnswer {
  /// Absent: it runs, and has no preference now. Normalised to 0..100 (NormaliseTo100).
  std::optional<Objective> objective = {};
  /// > 0 and at most 1 with an objective. BehaviorSet multiplies it by the priority weight, which
  /// updates change without the behavior's knowledge.
  double relevance = 0;
  double urgency = 1;                    ///< Factor of the weight, in imminent danger; >= 1.
  AllowedPart allowed = {};              ///< What it lets the decision be, whatever the weights.
  std::vector<VariablePost> posts = {};  ///< Its own reports (WPT_INDEX ...), without flags.
  std::vector<std::string> flags = {};  ///< Names of own flag lists that fire now ("wptflag", ...).
  bool completes = false;
  std::string error = {};  ///< Not empty: an all-stop with this reason.
  bool parks = false;      ///< The helm is to park, as by an operator's order.
  double busy_s = 0;       ///< The helm is to be busy for that long, in mission time: test_failure.
  bool crashes = false;    ///< The helm's process is to abort: test_failure.
  std::string warning = {};
  std::string state = {};  ///< For the page: "leg 3", "acquiring", "lane 2".
  std::optional<ContactRole> role = {};
  BehaviorView view = {};
};

class Behavior {
 public:
  virtual ~Behavior() = default;

  /// One iteration in which the conditions hold.
  virtual BehaviorAnswer Run(const BehaviorInputs& inputs) = 0;

  /// One iteration in which they do not.
  virtual BehaviorAnswer Idle(const BehaviorInputs&) { return {}; }

  /// Once, in the iteration in which something else than its answer completes it: its duration, or
  /// that its contact is gone.
  virtual BehaviorAnswer Complete(const BehaviorInputs&) { return {}; }

  /// The operator has given the order to go on: errors that last are over.
  virtual void Clear() {}

  /// True where only a goal behavior beside it makes sense of the decision (avoidance, limits).
  virtual bool is_constraint() const { return false; }
};

/// A behavior with its options. Each behavior derives from this one.
template <class Options>
class BehaviorWith : public Behavior {
 public:
  explicit BehaviorWith(const Options& options) : options_(options) {}

  /// Takes over options that an update at run time changed, and keeps its progress where the change
  /// lets it.
  virtual void Reconfigure(const Options& options) { options_ = options; }

 protected:
  Options options_;
};

}  // namespace shoal
