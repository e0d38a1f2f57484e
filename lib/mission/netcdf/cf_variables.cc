#include "lib/mission/netcdf/cf_variables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/netcdf/cf_words.h"

namespace shoal {

namespace {

constexpr std::array<std::string_view, 4> kDepthNames = {
    "sea_floor_depth_below_geoid", "sea_floor_depth_below_mean_sea_level",
    "sea_floor_depth_below_sea_surface", "sea_floor_depth"};
constexpr std::array<std::string_view, 5> kElevationNames = {
    "height_above_mean_sea_level", "height_above_geoid", "altitude", "surface_altitude",
    "bedrock_altitude"};
constexpr std::array<std::string_view, 10> kFloorVariables = {
    "elevation", "z",          "band1", "depth",  "deptho",
    "topo",      "bathymetry", "bathy", "height", "altitude"};

using NamePair = std::pair<std::string_view, std::string_view>;
constexpr std::array<NamePair, 3> kVelocityNames = {
    {{"eastward_sea_water_velocity", "northward_sea_water_velocity"},
     {"barotropic_eastward_sea_water_velocity", "barotropic_northward_sea_water_velocity"},
     {"surface_eastward_sea_water_velocity", "surface_northward_sea_water_velocity"}}};
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

/// Returns the variables with at least two dimensions of which `text` returns this word.
template <class TextOf>
std::vector<std::string> Those(const NetcdfHeader& header, std::string_view word,
                               const TextOf& text) {
  std::vector<std::string> names;
  for (const NetcdfVariable& variable : header.variables) {
    if (IsOnPlane(variable) && text(variable) == word) names.push_back(variable.name);
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
  for (const std::string_view word : kDepthNames) {
    for (std::string& name : Those(header, word, StandardName)) found.push_back(std::move(name));
  }
  for (const std::string_view word : kElevationNames) {
    for (std::string& name : Those(header, word, StandardName)) found.push_back(std::move(name));
  }
  for (const std::string_view word : kFloorVariables) {
    if (found.empty()) found = Those(header, word, Name);
  }
  if (found.empty()) {
    for (const NetcdfVariable& variable : header.variables) {
      if (IsOnPlane(variable)) found.push_back(variable.name);
    }
  }
  if (found.size() == 1) return found.front();
  return Error{
      fmt::format("{}: which variable is the sea floor is not clear; name it after the "
                  "file, {}:variable; there are: {}",
                  file, file, Choices(header))};
}

std::optional<bool> HoldsDepths(const NetcdfVariable& variable) {
  const std::string positive = LowerCase(Trimmed(variable.TextOf("positive")));
  if (positive == "down" || positive == "up") return positive == "down";
  const std::string name = StandardName(variable);
  if (std::ranges::find(kDepthNames, name) != kDepthNames.end()) return true;
  if (std::ranges::find(kElevationNames, name) != kElevationNames.end()) return false;
  return std::nullopt;
}

Result<std::pair<std::string, std::string>> FindCurrentVariables(const NetcdfHeader& header,
                                                                 const std::string& file) {
  const auto look = [&](const auto& rows,
                        const auto& text) -> std::optional<std::pair<std::string, std::string>> {
    for (const auto& [east, north] : rows) {
      const std::vector<std::string> easts = Those(header, east, text);
      const std::vector<std::string> norths = Those(header, north, text);
      if (easts.size() == 1 && norths.size() == 1) return {{easts.front(), norths.front()}};
    }
    return std::nullopt;
  };
  if (auto found = look(kVelocityNames, StandardName)) return *found;
  if (auto found = look(kVelocityVariables, Name)) return *found;
  return Error{
      fmt::format("{}: which variables are the current is not clear; name both, grid_east "
                  "= \"{}:variable\" and grid_north; there are: {}",
                  file, file, Choices(header))};
}

}  // namespace shoal
