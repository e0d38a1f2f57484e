#include "lib/mission/netcdf/cf_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/netcdf/cf_words.h"

namespace shoal {

namespace {

constexpr CfAxisKind kLatitude = {.role = CfRole::kNorth, .is_geographic = true};
constexpr CfAxisKind kLongitude = {.role = CfRole::kEast, .is_geographic = true};
constexpr CfAxisKind kRotatedY = {.role = CfRole::kNorth, .is_rotated = true};
constexpr CfAxisKind kRotatedX = {.role = CfRole::kEast, .is_rotated = true};
constexpr CfAxisKind kX = {.role = CfRole::kEast};
constexpr CfAxisKind kY = {.role = CfRole::kNorth};
constexpr CfAxisKind kDepth = {.role = CfRole::kDepth};
constexpr CfAxisKind kTime = {.role = CfRole::kTime};

using Row = std::pair<std::string_view, CfAxisKind>;

/// All spellings that CF allows (sections 4.1 and 4.2), in lower case.
constexpr std::array<Row, 12> kAngleUnits = {{{"degrees_north", kLatitude},
                                              {"degree_north", kLatitude},
                                              {"degree_n", kLatitude},
                                              {"degrees_n", kLatitude},
                                              {"degreen", kLatitude},
                                              {"degreesn", kLatitude},
                                              {"degrees_east", kLongitude},
                                              {"degree_east", kLongitude},
                                              {"degree_e", kLongitude},
                                              {"degrees_e", kLongitude},
                                              {"degreee", kLongitude},
                                              {"degreese", kLongitude}}};

constexpr std::array<Row, 13> kStandardNames = {{{"latitude", kLatitude},
                                                 {"longitude", kLongitude},
                                                 {"grid_latitude", kRotatedY},
                                                 {"grid_longitude", kRotatedX},
                                                 {"projection_x_coordinate", kX},
                                                 {"projection_y_coordinate", kY},
                                                 {"depth", kDepth},
                                                 {"height", kDepth},
                                                 {"altitude", kDepth},
                                                 {"depth_below_geoid", kDepth},
                                                 {"height_above_geoid", kDepth},
                                                 {"height_above_mean_sea_level", kDepth},
                                                 {"time", kTime}}};

constexpr std::array<Row, 2> kAxisLetters = {{{"z", kDepth}, {"t", kTime}}};

constexpr std::array<Row, 12> kAxisNames = {{{"lat", kLatitude},
                                             {"latitude", kLatitude},
                                             {"lon", kLongitude},
                                             {"longitude", kLongitude},
                                             {"rlat", kRotatedY},
                                             {"rlon", kRotatedX},
                                             {"x", kX},
                                             {"y", kY},
                                             {"depth", kDepth},
                                             {"lev", kDepth},
                                             {"z", kDepth},
                                             {"time", kTime}}};

template <size_t N>
std::optional<CfAxisKind> Look(const std::array<Row, N>& rows, std::string_view text) {
  const std::string word = LowerCase(Trimmed(text));
  const auto row = std::ranges::find(rows, word, &Row::first);
  return row == rows.end() ? std::nullopt : std::optional(row->second);
}

}  // namespace

std::optional<CfAxisKind> AxisKindOf(const NetcdfVariable& coordinate) {
  const std::string units = LowerCase(coordinate.TextOf("units"));
  const auto by_standard_name = Look(kStandardNames, coordinate.TextOf("standard_name"));
  // Some rotated grids count grid_latitude in degrees_north.
  if (by_standard_name && by_standard_name->is_rotated) return by_standard_name;
  if (const auto kind = Look(kAngleUnits, units)) return kind;
  if (units.find(" since ") != std::string::npos) return kTime;
  if (by_standard_name) return by_standard_name;
  // Grids of GMT: x and y in "degrees", whose long_name is Longitude and Latitude.
  if (const auto kind = Look(kAxisNames, coordinate.TextOf("long_name"));
      kind && kind->is_geographic) {
    return kind;
  }
  if (!coordinate.TextOf("positive").empty()) return kDepth;
  if (const auto kind = Look(kAxisLetters, coordinate.TextOf("axis"))) return kind;
  return Look(kAxisNames, coordinate.name);
}

std::optional<CfRole> RoleOfDimension(std::string_view name) {
  const std::string whole = LowerCase(name);
  const std::string_view word = whole;
  // nx, ni, nlat count.
  for (const std::string_view each : {word, word.substr(word.starts_with('n') ? 1 : 0)}) {
    if (each == "i") return CfRole::kEast;
    if (each == "j") return CfRole::kNorth;
    for (const std::string_view start : {"x", "lon", "east", "col"}) {
      if (each.starts_with(start)) return CfRole::kEast;
    }
    for (const std::string_view start : {"y", "eta", "lat", "north", "row"}) {
      if (each.starts_with(start)) return CfRole::kNorth;
    }
  }
  return std::nullopt;
}

std::optional<CfAxis> Ascending(std::vector<double> points, bool are_longitudes) {
  if (points.empty()) return std::nullopt;
  for (size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i])) return std::nullopt;
    if (!are_longitudes || i == 0) continue;
    if (std::abs(points[i]) > 1e4) return std::nullopt;
    points[i] -= 360 * std::rint((points[i] - points[i - 1]) / 360);
  }
  CfAxis axis;
  axis.source.resize(points.size());
  std::iota(axis.source.begin(), axis.source.end(), size_t{0});
  if (points.front() > points.back()) {
    std::ranges::reverse(points);
    std::ranges::reverse(axis.source);
  }
  if (std::ranges::adjacent_find(points, std::greater_equal<>()) != points.end()) {
    return std::nullopt;
  }
  if (are_longitudes && points.size() > 1) {
    const double span = points.back() - points.front();
    const double step = span / static_cast<double>(points.size() - 1);
    if (span < 360 && span + 1.5 * step > 360) {
      points.push_back(points.front() + 360);
      axis.source.push_back(axis.source.front());
    }
  }
  axis.points = std::move(points);
  return axis;
}

}  // namespace shoal
