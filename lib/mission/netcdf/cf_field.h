// A variable of a NetCDF file on its axes, by the CF conventions: unpacked, in one order of
// dimensions, with gaps marked.
//
//   Result<CfField> field = ReadCfField(SourceOf(file), "elevation");
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/geodesy/map_projection.h"
#include "lib/mission/netcdf/netcdf_header.h"

namespace shoal {

class NetcdfFile;

/// A file: what it holds, and how the values of a variable are read.
struct CfSource {
  std::string name;  ///< For messages.
  const NetcdfHeader& header;
  std::function<Result<std::vector<double>>(const NetcdfVariable&)> read;
};

/// @pre `file` outlives what is returned
[[nodiscard]] CfSource SourceOf(const NetcdfFile& file);

struct CfField {
  std::string variable;
  bool is_geographic = false;  ///< x and y are longitudes and latitudes; else metres.
  /// What x and y are coordinates of, by grid_mapping. Of a rotated pole they are degrees.
  std::optional<MapProjection> projection = {};
  /// Of a curvilinear grid, where each point lies, in rows along x; x and y count points. Else
  /// empty.
  std::vector<double> lats_deg = {};
  std::vector<double> lons_deg = {};
  /// Its dimensions have axes or names that show which of them is x; else that is the last.
  bool is_x_known = true;
  std::vector<double> x;               ///< Ascending; longitudes may exceed 360.
  std::vector<double> y;               ///< Ascending.
  std::vector<double> depths_m = {0};  ///< Ascending, positive below the surface.
  std::vector<double> times_s = {0};   ///< Ascending, seconds since 1970, UTC.
  bool has_time = false;               ///< Else it is steady, and times_s means nothing.
  /// Of each time each depth, of each depth each row from South to North, of each row from West to
  /// East: metres, or metres per second. NaN: no data.
  std::vector<float> values = {};
  /// What is read, and probably meant otherwise, to be put after "variable 'u' ".
  std::vector<std::string> warnings = {};

  bool is_curvilinear() const { return !lats_deg.empty(); }
};

/// What a variable counts, and so which units it may have.
enum class CfQuantity {
  kMetres,           ///< "m" or "km", or no units.
  kMetresPerSecond,  ///< "m s-1" or "cm s-1" in their spellings, or no units.
};

/// Reads a variable with axes for x and y, and perhaps depth and time, in any order. Other
/// dimensions must have the length 1. Where the points lie is shown by axes of latitude and
/// longitude, by a grid_mapping, by latitudes and longitudes of two dimensions (a curvilinear
/// grid), or else by metres. An error names file, variable and remedy: there is no such variable;
/// an axis is of no known kind, or neither rises nor falls; units, calendar or map are unknown.
[[nodiscard]] Result<CfField> ReadCfField(const CfSource& source, std::string_view variable,
                                          CfQuantity quantity);

}  // namespace shoal
