// Copies heading and speed of a contact.
#pragma once

#include <string_view>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/contact_options.h"

namespace shoal {

/// kind = "shadow". Copies heading and speed of a contact.
struct ShadowOptions {
  static constexpr std::string_view kKind = "shadow";

  ContactOptions contact = {};     ///< Which contact, and how it is tracked.
  double pwt_outer_dist = 0;       ///< m; 0: always.
  double heading_peakwidth = 20;   ///< Degrees.
  double heading_basewidth = 160;  ///< Degrees.
  double speed_peakwidth = 0.1;    ///< m/s.
  double speed_basewidth = 2;      ///< m/s.

  bool operator==(const ShadowOptions&) const = default;
};

class ShadowBehavior final : public BehaviorWith<ShadowOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
};

}  // namespace shoal
