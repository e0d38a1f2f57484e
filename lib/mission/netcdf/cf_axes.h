// What the axes of a NetCDF file are ("CF Conventions" 1.11, chapter 4).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lib/base/check/enum_table.h"
#include "lib/mission/netcdf/netcdf_header.h"

namespace shoal {

/// In the order in which a field has them, the last varies fastest.
enum class CfRole { kTime, kDepth, kNorth, kEast };
inline constexpr size_t kNumCfRoles = kNumEnumerators<CfRole>;

struct CfAxisKind {
  CfRole role = CfRole::kEast;
  bool is_geographic = false;  ///< Of kNorth and kEast: degrees; else metres,
  bool is_rotated = false;     ///< or degrees about another pole than the Earth's.
};

/// Returns what a coordinate variable counts: by its units, its standard_name, its attributes
/// `axis` and `positive`, and last by its name. Nothing where none of these shows it.
[[nodiscard]] std::optional<CfAxisKind> AxisKindOf(const NetcdfVariable& coordinate);

/// Returns whether models give this name to the dimension of x, of y, or to neither: xi_rho, x, i,
/// nlon; eta_rho, y, j, nlat.
[[nodiscard]] std::optional<CfRole> RoleOfDimension(std::string_view name);

/// An axis with its points in ascending order.
struct CfAxis {
  std::vector<double> points;
  std::vector<size_t> source;  ///< Where in the file the value of each point stands.
};

/// Returns the points in ascending order; nothing where they neither rise nor fall throughout, or
/// are not finite. Longitudes go on where they pass 180 or 360 degrees, and an axis that goes round
/// the Earth has its first meridian once more at its end.
[[nodiscard]] std::optional<CfAxis> Ascending(std::vector<double> points, bool are_longitudes);

}  // namespace shoal
