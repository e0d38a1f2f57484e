// Follows the track of a contact at a distance along it.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/contact_options.h"

namespace shoal {

/// kind = "convoy". Follows the track of a contact at a distance along it.
struct ConvoyOptions {
  static constexpr std::string_view kKind = "convoy";

  ContactOptions contact = {};  ///< Which contact, and how it is tracked.
  double range = 25;            ///< m along its track.
  double radius = 3;            ///< m; a mark of the track is reached closer than this.
  double nm_radius = 9;         ///< m.
  double mark_spacing = 5;      ///< m between the marks that the contact leaves.
  double spd_gain = 0.05;       ///< 1/s; speed per m of error in range.
  double spd_max = -1;          ///< m/s; -1: the domain's.

  bool operator==(const ConvoyOptions&) const = default;
};

/// The contact leaves a mark every mark_spacing of its reported way; own ship runs from mark to
/// mark and holds `range` along them.
class ConvoyBehavior final : public BehaviorWith<ConvoyOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  /// Forgets the marks.
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;

 private:
  void Leave(const Eigen::Vector2d& position_m);
  void Reach(const Eigen::Vector2d& own_m);

  std::deque<Eigen::Vector2d> marks_m_;
  double closest_m_ = -1;  ///< To the next mark; < 0: not known yet.
};

}  // namespace shoal
