#include "lib/mission/netcdf/cf_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/netcdf/cf_words.h"

namespace shoal {

namespace {

/// Beginnings of standard names: below the geoid, mean sea level, the geopotential datum, the
/// reference ellipsoid, and the aliases of old tables, below the sea level.
constexpr std::array<std::string_view, 2> kDepthNames = {"sea_floor_depth",
                                                         "model_sea_floor_depth"};
constexpr std::array<std::string_view, 9> kElevationNames = {"height_above_mean_sea_level",
                                                             "height_above_sea_level",
                                                             "height_above_geoid",
                                                             "height_above_geopotential_datum",
                                                             "height_above_reference_ellipsoid",
                                                             "altitude",
                                                             "surface_altitude",
                                                             "bedrock_altitude",
                                                             "ground_level_altitude"};
constexpr std::array<std::string_view, 13> kFloorVariables = {
    "elevation", "z",      "band1",    "depth",       "deptho", "topo", "bathymetry",
    "bathy",     "height", "altitude", "bathy_metry", "hdepth", "h"};
constexpr std::array<std::string_view, 9> kDepthVariables = {
    "depth",       "depths", "deptho",      "bathymetry", "bathy",
    "bathy_metry", "hdepth", "water_depth", "h"};

using NamePair = std::pair<std::string_view, std::string_view>;
constexpr std::array<NamePair, 8> kVelocityNames = {
    {{"eastward_sea_water_velocity", "northward_sea_water_velocity"},
     {"barotropic_eastward_sea_water_velocity", "barotropic_northward_sea_water_velocity"},
     {"surface_eastward_sea_water_velocity", "surface_northward_sea_water_velocity"},
     {"sea_water_x_velocity", "sea_water_y_velocity"},
     {"x_sea_water_velocity", "y_sea_water_velocity"},
     {"barotropic_sea_water_x_velocity", "barotropic_sea_water_y_velocity"},
     {"surface_sea_water_x_velocity", "surface_sea_water_y_velocity"},
     {"grid_eastward_sea_water_velocity", "grid_northward_sea_water_velocity"}}};
constexpr std::array<NamePair, 6> kVelocityVariables = {{{"uo", "vo"},
                                                         {"u", "v"},
                                                         {"water_u", "water_v"},
                                                         {"ubar", "vbar"},
                                                         {"u_velocity", "v_velocity"},
                                                         {"ucur", "vcur"}}};

bool IsOnPlane(const NetcdfVariable& variable) {
  return variable.dimensions.size() >= 2 && variable.type != NetcdfType::kOther;
}

std::string StandardName(const NetcdfVariable& variable) {
  return LowerCase(Trimmed(variable.TextOf("standard_name")));
}

std::string Name(const NetcdfVariable& variable) { return LowerCase(variable.name); }

bool IsDepthName(std::string_view standard_name) {
  return std::ranges::any_of(
      kDepthNames, [&](std::string_view start) { return standard_name.starts_with(start); });
}

bool IsElevationName(std::string_view standard_name) {
  return std::ranges::find(kElevationNames, standard_name) != kElevationNames.end();
}

bool HasAny(const std::string& text, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(
      parts, [&](std::string_view part) { return text.find(part) != std::string::npos; });
}

/// Returns whether a text describes the water's surface, waves, ice, or a layer of the water.
bool IsOfWater(const std::string& text) {
  return HasAny(text, {"sea_surface", "surface_height", "wave", "swell", "sea_level_anomaly",
                       "free_surface", "surface_elevation", "ice", "snow", "layer", "isosurface",
                       "thermocline", "thickness", "dynamic_topography"});
}

/// Returns the variables with at least two dimensions of which `text` returns this word, and that
/// are not another quantity.
template <class TextOf, class IsOther>
std::vector<std::string> Those(const NetcdfHeader& header, std::string_view word,
                               const TextOf& text, const IsOther& is_other) {
  std::vector<std::string> names;
  for (const NetcdfVariable& variable : header.variables) {
    if (IsOnPlane(variable) && text(variable) == word && !is_other(variable)) {
      names.push_back(variable.name);
    }
  }
  return names;
}

/// Returns the names of all variables that a user may choose from, for messages.
std::string Choices(const NetcdfHeader& header) {
  std::string names;
  for (const NetcdfVariable& variable : header.variables) {
    if (!IsOnPlane(variable) || names.size() > 200) continue;
    names += (names.empty() ? "" : ", ") + PrintableName(variable.name);
  }
  return names.empty() ? "none" : names;
}

}  // namespace

Result<std::string> FindFloorVariable(const NetcdfHeader& header, const std::string& file) {
  std::vector<std::string> found;
  for (const NetcdfVariable& variable : header.variables) {
    const std::string standard_name = StandardName(variable);
    if (IsOnPlane(variable) && (IsDepthName(standard_name) || IsElevationName(standard_name))) {
      found.push_back(variable.name);
    }
  }
  const auto is_other = [](const NetcdfVariable& each) { return OtherThanFloor(each).has_value(); };
  for (const std::string_view word : kFloorVariables) {
    if (found.empty()) found = Those(header, word, Name, is_other);
  }
  if (found.empty()) {
    for (const NetcdfVariable& variable : header.variables) {
      if (IsOnPlane(variable) && !is_other(variable)) found.push_back(variable.name);
    }
  }
  if (found.size() == 1) return found.front();
  return Error{
      fmt::format("{}: which variable is the sea floor is not clear; name it after the "
                  "file, {}:variable; there are: {}",
                  file, file, Choices(header))};
}

std::optional<FloorStatement> StatementOf(const NetcdfVariable& variable) {
  const std::string positive = LowerCase(Trimmed(variable.TextOf("positive")));
  if (positive == "down" || positive == "up") {
    return FloorStatement{.are_depths = positive == "down",
                          .by = "its attribute positive = '" + positive + "'"};
  }
  const std::string name = StandardName(variable);
  const std::string by = "its standard_name " + PrintableName(name);
  if (IsDepthName(name)) return FloorStatement{.are_depths = true, .by = by};
  if (IsElevationName(name)) return FloorStatement{.are_depths = false, .by = by};
  return std::nullopt;
}

std::optional<std::string> OtherThanFloor(const NetcdfVariable& variable) {
  const std::string name = StandardName(variable);
  if (IsDepthName(name) || IsElevationName(name)) return std::nullopt;
  const bool may_be_floor = HasAny(name, {"floor", "depth", "bathymetry", "topograph", "altitude",
                                          "elevation", "height"}) &&
                            !IsOfWater(name);
  if (!name.empty() && !may_be_floor) return "its standard_name is " + PrintableName(name);
  std::string long_name = LowerCase(variable.TextOf("long_name"));
  std::ranges::replace(long_name, ' ', '_');
  std::ranges::replace(long_name, '-', '_');
  if (name.empty() &&
      HasAny(long_name, {"surface_height", "surface_elevation", "free_surface", "wave_height",
                         "sea_level_anomaly", "layer_depth"}) &&
      !HasAny(long_name, {"floor", "bathymetry", "bottom", "below"})) {
    return "its long_name is '" + PrintableName(variable.TextOf("long_name")) + "'";
  }
  return std::nullopt;
}

std::optional<std::string> OtherThanCurrent(const NetcdfVariable& variable) {
  const std::string name = StandardName(variable);
  if (!HasAny(name, {"wind", "ice", "wave", "stokes", "stress", "transport"})) return std::nullopt;
  return "its standard_name is " + PrintableName(name);
}

bool IsNamedAsDepths(const NetcdfVariable& variable) {
  return std::ranges::find(kDepthVariables, Name(variable)) != kDepthVariables.end();
}

bool CountsFromEllipsoid(const NetcdfVariable& variable) {
  const std::string name = StandardName(variable);
  return (IsDepthName(name) || IsElevationName(name)) && name.ends_with("reference_ellipsoid");
}

CfDirection DirectionOf(const NetcdfVariable& variable) {
  const std::string name = StandardName(variable);
  const auto has = [&](std::string_view part) { return name.find(part) != std::string::npos; };
  if (has("grid_eastward") || has("x_velocity") || name.starts_with("x_")) return CfDirection::kX;
  if (has("grid_northward") || has("y_velocity") || name.starts_with("y_")) return CfDirection::kY;
  if (has("eastward")) return CfDirection::kEast;
  if (has("northward")) return CfDirection::kNorth;
  const std::string long_name = LowerCase(variable.TextOf("long_name"));
  const auto has_word = [&](std::string_view word) {
    return long_name.find(word) != std::string::npos;
  };
  // "zonal" is written of components along the axes too.
  if (!name.empty() || HasAny(long_name, {"grid", "axis"})) return CfDirection::kUnknown;
  if (has_word("eastward")) return CfDirection::kEast;
  if (has_word("northward")) return CfDirection::kNorth;
  return CfDirection::kUnknown;
}

Result<std::pair<std::string, std::string>> FindCurrentVariables(const NetcdfHeader& header,
                                                                 const std::string& file) {
  const auto is_other = [](const NetcdfVariable& each) {
    return OtherThanCurrent(each).has_value();
  };
  // The first row of which anything is there decides: another one is another current.
  const auto look = [&](const auto& rows, const auto& text)
      -> std::optional<std::pair<std::vector<std::string>, std::vector<std::string>>> {
    for (const auto& [east, north] : rows) {
      auto easts = Those(header, east, text, is_other);
      auto norths = Those(header, north, text, is_other);
      if (!easts.empty() || !norths.empty()) return {{std::move(easts), std::move(norths)}};
    }
    return std::nullopt;
  };
  auto found = look(kVelocityNames, StandardName);
  if (!found) found = look(kVelocityVariables, Name);
  if (found && found->first.size() == 1 && found->second.size() == 1) {
    return std::pair(found->first.front(), found->second.front());
  }
  return Error{
      fmt::format("{}: which variables are the current is not clear; name both, grid_east "
                  "= \"{}:variable\" and grid_north; there are: {}",
                  file, file, Choices(header))};
}

}  // namespace shoal
