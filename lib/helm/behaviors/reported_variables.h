// Variables of a helm that no file has to set: behaviors report them, or they state where the
// vessel is.
#pragma once

#include <array>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

struct OwnVariable {
  std::string_view name;
  double (*value)(const OwnMotion& own);
};

/// Where the vessel is, for conditions: metres, degrees in [0, 360), m/s.
inline constexpr std::array<OwnVariable, 5> kOwnVariables = {{
    {"NAV_X", [](const OwnMotion& own) { return own.motion.position_m.x(); }},
    {"NAV_Y", [](const OwnMotion& own) { return own.motion.position_m.y(); }},
    {"NAV_HEADING", [](const OwnMotion& own) { return own.motion.heading_deg; }},
    {"NAV_SPEED", [](const OwnMotion& own) { return own.motion.speed_mps; }},
    {"NAV_DEPTH", [](const OwnMotion& own) { return own.depth_m; }},
}};

/// Returns true for a variable that a helm with the right behaviors has by itself. Behaviors may
/// have a suffix (`WPT_INDEX_LEG`); the vessel's own have no other form: NAV_YAW is unknown.
[[nodiscard]] bool IsReportedVariable(std::string_view name);

}  // namespace shoal
