// Which variables of a NetCDF file hold the sea floor, and the current.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/mission/netcdf/netcdf_header.h"

namespace shoal {

/// Returns the name of the variable with depths or elevations: by standard_name
/// (sea_floor_depth..., altitude, ...), else by the names that GEBCO, ETOPO, EMODnet and GDAL use,
/// else the only one with two axes. An error lists those there are; it begins with `file`.
[[nodiscard]] Result<std::string> FindFloorVariable(const NetcdfHeader& header,
                                                    const std::string& file);

/// Returns whether a variable holds depths, positive below the surface, by its attribute `positive`
/// or its standard_name; nothing: the file does not state it.
[[nodiscard]] std::optional<bool> HoldsDepths(const NetcdfVariable& variable);

/// Returns the names of the variables with the eastward and the northward velocity: by
/// standard_name (eastward_sea_water_velocity, ...), else by the names that models use: uo and vo,
/// u and v, water_u and water_v, ... Errors likewise.
[[nodiscard]] Result<std::pair<std::string, std::string>> FindCurrentVariables(
    const NetcdfHeader& header, const std::string& file);

}  // namespace shoal
