// Closes in on a contact.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/contact_options.h"

namespace shoal {

/// kind = "cut_range". Closes in on a contact.
struct CutRangeOptions {
  static constexpr std::string_view kKind = "cut_range";

  ContactOptions contact = {};  ///< Which contact, and how it is tracked.
  double pwt_outer_dist = 50;   ///< m.
  double pwt_inner_dist = 0;    ///< m.
  double giveup_dist = 0;       ///< m; 0: never gives up.
  double patience = 0;          ///< Per cent, 0 to 85.
  double time_on_leg = 15;      ///< s.
  std::vector<std::string> pursueflag = {};
  std::vector<std::string> giveupflag = {};

  bool operator==(const CutRangeOptions&) const = default;
};

class CutRangeBehavior final : public BehaviorWith<CutRangeOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;

 private:
  bool pursues_ = false;
};

}  // namespace shoal
