// Follows the track of a contact at a distance along it.
#pragma once

#include <string_view>

#include "lib/behaviors/behavior.h"
#include "lib/behaviors/contact_options.h"

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

}  // namespace shoal
