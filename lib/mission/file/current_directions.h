// Which way the components of a current of a file run, and how they are turned to the mission's x
// and y: along the axes of a map, of a curvilinear grid, or East and North.
//
//   Components components = {.east = u, .north = v};
//   const std::string problem = UseDirections(components, DirectionOf(u), DirectionOf(v));
//   TurnToPlane(components, origin);
#pragma once

#include <string>

#include "lib/base/geodesy/local_frame.h"
#include "lib/mission/file/grid_files.h"
#include "lib/mission/netcdf/cf_field.h"
#include "lib/mission/netcdf/cf_variables.h"

namespace shoal {

/// Of one current, at the same places, depths and times.
struct Components {
  CfField east;
  CfField north;
  GridNotes notes = {};
};

/// Finds out what the components run along, and turns them where that is not East and North.
/// Returns what is wrong; empty: nothing.
[[nodiscard]] std::string UseDirections(Components& components, CfDirection east,
                                        CfDirection north);

/// Turns velocities East and North at the points of a projected or curvilinear grid to the plane of
/// the mission, as near a pole they differ from point to point. On a grid in degrees the plane's
/// turn is that at the vehicle (GridMap::TurnToPlane).
void TurnToPlane(Components& components, const GeoPoint& origin);

}  // namespace shoal
