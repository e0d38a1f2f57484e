// Keeps clear of one contact by the collision regulations, rules 13 to 17.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/contact_options.h"
#include "lib/helm/colregs/colregs_state.h"

namespace shoal {

/// kind = "colregs". Keeps clear of one contact by the collision regulations, rules 13 to 17.
struct ColregsOptions {
  static constexpr std::string_view kKind = "colregs";

  ContactOptions contact = {};       ///< Which contact, and how it is tracked.
  double pwt_outer_dist = 100;       ///< m; the weight is 0 from here on.
  double pwt_inner_dist = 90;        ///< m; full weight from here to 0.
  double completed_dist = 100;       ///< m; ends at 1.1 times this.
  double min_util_cpa_dist = 10;     ///< m.
  double max_util_cpa_dist = 75;     ///< m.
  std::string pwt_grade = "linear";  ///< linear, quasi or quadratic.
  double time_on_leg = 120;          ///< s.
  double turn_radius = 0;            ///< m; own.
  double giveway_bow_dist = -1;      ///< m; -1: from the utility distances.
  bool headon_only = false;          ///< Everything else is avoided without rules.
  bool pts_port_turns_ok = true;     ///< Give-way may turn to port behind the contact.
  bool can_disable = false;
  double widen_per_s = 0;  ///< m by which both distances grow per second of age.
  /// False, as the original: the last decision is forgotten, imminent danger counts no more than
  /// distance, and a vessel that is overtaken may flee.
  bool steady = true;
  double min_dwell = 3;  ///< s that a mode lasts at least, but for in extremis.

  bool operator==(const ColregsOptions&) const = default;
};

/// Roles and preferences: lib/helm/colregs. An iteration without conditions ends the role; it is
/// judged again.
class ColregsBehavior final : public BehaviorWith<ColregsOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;
  bool is_constraint() const override { return true; }

 private:
  ColregsState role_;
};

}  // namespace shoal
