// Keeps clear of one contact, without rules.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/contact_options.h"

namespace shoal {

/// kind = "avoid_collision". Keeps clear of one contact, without rules.
struct AvoidCollisionOptions {
  static constexpr std::string_view kKind = "avoid_collision";

  ContactOptions contact = {};      ///< Which contact, and how it is tracked.
  double pwt_outer_dist = 200;      ///< m; the weight is 0 from here on.
  double pwt_inner_dist = 50;       ///< m; full weight from here to 0.
  double completed_dist = 500;      ///< m; ends at 1.1 times this.
  double min_util_cpa_dist = 10;    ///< m; closer is worth nothing.
  double max_util_cpa_dist = 75;    ///< m; farther is worth no more.
  std::string pwt_grade = "quasi";  ///< linear, quasi or quadratic.
  double time_on_leg = 120;         ///< s; horizon of the closest approach.
  double collision_depth = -1;      ///< m; deeper than this it does not avoid; -1: off.
  bool steady = true;      ///< False, as the original: no memory, danger counts as its distance.
  double widen_per_s = 0;  ///< m by which both distances grow per second of age.

  bool operator==(const AvoidCollisionOptions&) const = default;
};

class AvoidCollisionBehavior final : public BehaviorWith<AvoidCollisionOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  bool is_constraint() const override { return true; }
};

}  // namespace shoal
