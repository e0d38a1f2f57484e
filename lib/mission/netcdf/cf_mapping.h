// The map projection of a grid, by its grid_mapping ("CF Conventions" 1.11, section 5.6 and
// appendix F).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/base/geodesy/map_projection.h"
#include "lib/mission/netcdf/netcdf_header.h"

namespace shoal {

/// Returns the variable that `grid_mapping` of `variable` names for the axis `x_axis`; null: it
/// names none. An error, to be put after "variable 'u' ", where the file does not have it.
[[nodiscard]] Result<const NetcdfVariable*> FindMapping(const NetcdfHeader& header,
                                                        const NetcdfVariable& variable,
                                                        std::string_view x_axis);

/// Returns the projection that a mapping describes: polar_stereographic, lambert_conformal_conic,
/// mercator, transverse_mercator or rotated_latitude_longitude. `metres` is what 1 of the axes is.
/// Where it has no figure of the Earth (HasFigure) that is a sphere of 6371 km, as in most models.
/// An error likewise: the mapping is another one, or has no number that it needs.
[[nodiscard]] Result<MapProjection> ProjectionOf(const NetcdfVariable& mapping, double metres);

/// Returns how far East of Greenwich the meridian lies from which longitudes of a mapping count, in
/// degrees. An error, to be put after "variable 'u' ": it is named, without that number.
[[nodiscard]] Result<double> PrimeMeridianOf(const NetcdfVariable& mapping);

/// Returns whether a mapping states the figure of the Earth, which moves a grid by up to 20 km: by
/// its numbers, or as WGS84 by a name.
[[nodiscard]] bool HasFigure(const NetcdfVariable& mapping);

}  // namespace shoal
