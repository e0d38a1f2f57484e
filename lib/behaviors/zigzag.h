// Zigzags about a course.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/behaviors/behavior.h"

namespace shoal {

/// kind = "zigzag". Zigzags about a course.
struct ZigzagOptions {
  static constexpr std::string_view kKind = "zigzag";

  double stem_hdg = 0;             ///< Degrees.
  bool stem_on_active = false;     ///< The heading when it begins instead.
  double speed = 0;                ///< m/s.
  bool speed_on_active = false;    ///< The speed when it begins instead.
  double zig_angle = 45;           ///< Degrees; 1 to 90.
  std::string zig_first = "port";  ///< port or starboard.
  double hdg_thresh = 5;           ///< Degrees.
  int max_zig_legs = 2;            ///< Ends after these; 0: never.
  double max_stem_odo = -1;        ///< m along the stem; -1: off.
  bool fierce_zigging =
      false;  ///< The set course follows the heading until the new leg is reached.
  std::vector<std::string> zigflag = {};  ///< Each leg to port.
  std::vector<std::string> zagflag = {};  ///< Each leg to starboard.

  bool operator==(const ZigzagOptions&) const = default;
};

}  // namespace shoal
