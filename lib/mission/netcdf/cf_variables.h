// Which variables of a NetCDF file hold the sea floor, and the current.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/mission/netcdf/netcdf_header.h"

namespace shoal {

/// Returns the name of the variable with depths or elevations: by standard_name
/// (sea_floor_depth..., altitude, ...), else by the names that GEBCO, ETOPO, EMODnet, GDAL and
/// models use, else the only one with two axes, without those that are OtherThanFloor. An error
/// lists those there are; it begins with `file`.
[[nodiscard]] Result<std::string> FindFloorVariable(const NetcdfHeader& header,
                                                    const std::string& file);

/// What a file states of the numbers of a floor.
struct FloorStatement {
  bool are_depths = false;  ///< Positive below the surface; else elevations.
  std::string by = {};      ///< For messages: "its attribute positive = 'down'".
};

/// Returns what the attribute `positive` or the standard_name of a variable state; nothing: neither
/// does.
[[nodiscard]] std::optional<FloorStatement> StatementOf(const NetcdfVariable& variable);

/// Returns why a variable is not a sea floor: its standard_name or its long_name is that of another
/// quantity, as the height of the sea's surface. Nothing: it may be one.
[[nodiscard]] std::optional<std::string> OtherThanFloor(const NetcdfVariable& variable);

/// Returns why a variable is not a component of a current likewise: it is one of wind, waves or
/// ice.
[[nodiscard]] std::optional<std::string> OtherThanCurrent(const NetcdfVariable& variable);

/// Returns whether a variable has a name that models give to depths: depth, deptho, h, ... It is no
/// statement: elevations are called so too.
[[nodiscard]] bool IsNamedAsDepths(const NetcdfVariable& variable);

/// Returns whether depths count from the reference ellipsoid, which is up to 110 m off the sea.
[[nodiscard]] bool CountsFromEllipsoid(const NetcdfVariable& variable);

/// What a component of a current runs along, by its standard_name, or without one by the word
/// eastward or northward in its long_name.
enum class CfDirection {
  kUnknown,
  kEast,
  kNorth,
  kX,  ///< An axis of the grid, wherever it points.
  kY,
};
[[nodiscard]] CfDirection DirectionOf(const NetcdfVariable& variable);

/// Returns the names of the variables with the eastward and the northward velocity: by
/// standard_name (eastward_sea_water_velocity, ...), else those along the grid's axes
/// (sea_water_x_velocity, ...), else by the names that models use: uo and vo, u and v, water_u and
/// water_v, ... An error likewise where a pair of these is not complete, or there more than once.
[[nodiscard]] Result<std::pair<std::string, std::string>> FindCurrentVariables(
    const NetcdfHeader& header, const std::string& file);

}  // namespace shoal
