// The table [environment].
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "lib/mission/file/describe.h"
#include "lib/mission/file/grid_files.h"
#include "lib/mission/file/ocean_of.h"

namespace shoal {
namespace {

/// The current of a preset; muNet's seas by their zones.
struct CurrentPreset {
  std::string_view name;
  CurrentWords words;
};

const std::array<CurrentPreset, 3>& Presets() {
  static const std::array<CurrentPreset, 3> presets = {{
      {"calm", {"typical", "northeast", "steady", "steady", "calm", "calm"}},
      {"dead", {"dead", "90", "constant", "constant", "calm", "calm"}},
      {"stormy", {"fast", "any", "unsteady", "unsteady", "choppy", "choppy"}},
  }};
  return presets;
}

void DescribeWords(Fields& fields, CurrentWords& words) {
  if (fields.Has("preset", false)) {
    std::string name;
    std::vector<std::string_view> names;
    for (const CurrentPreset& preset : Presets()) names.push_back(preset.name);
    fields.Word("preset", name, names);
    for (const CurrentPreset& preset : Presets()) {
      if (preset.name == name) words = preset.words;
    }
  }
  fields.Scalar("speed_mps", words.speed_mps);
  fields.Scalar("direction_deg", words.direction_deg);
  fields.Scalar("speed_deviation_mps", words.speed_deviation_mps);
  fields.Scalar("direction_deviation_deg", words.direction_deviation_deg);
  fields.Scalar("speed_half_period_s", words.speed_half_period_s);
  fields.Scalar("direction_half_period_s", words.direction_half_period_s);
  if (!fields.reading()) return;
  for (const CurrentProblem& problem : FindProblems(words))
    fields.Refuse(problem.key, problem.text);
}

constexpr TextRule kPathRule = {.min_length = 1, .max_length = 1000};

/// What is wrong with a grid's keys taken together; empty: nothing.
std::string GridProblem(const CurrentGridOptions& grid) {
  if (grid.file.empty() && (grid.east.empty() || grid.north.empty())) {
    return "a current needs both components: write grid_east and grid_north, or grid = "
           "\"tide.nc\", a NetCDF file with both";
  }
  if (!grid.file.empty() && !(grid.east.empty() && grid.north.empty())) {
    return "grid names both components, and so do grid_east and grid_north: remove one or the "
           "other";
  }
  const GridName name = SplitGridName(grid.file);
  if (!grid.file.empty() && (!name.is_netcdf || !name.variable.empty())) {
    return "grid is a NetCDF file with both components, tide.nc; of ESRI ASCII files, and to name "
           "variables (tide.nc:u), write grid_east and grid_north";
  }
  const GridName east = SplitGridName(grid.east);
  const GridName north = SplitGridName(grid.north);
  if (east.is_netcdf != north.is_netcdf || east.is_netcdf == east.variable.empty() ||
      north.is_netcdf == north.variable.empty()) {
    return "grid_east and grid_north are two ESRI ASCII files (.asc), or a NetCDF file each with "
           "its variable, like \"tide.nc:u\" and \"tide.nc:v\"";
  }
  if (!IsGridTime(grid.time)) {
    return "grid_time is \"first\", \"absolute\", or a date like \"2026-11-24T06:00:00Z\"";
  }
  return "";
}

/// The keys that a current without a grid has.
constexpr std::array<std::string_view, 7> kWordKeys = {
    "preset",
    "speed_mps",
    "direction_deg",
    "speed_deviation_mps",
    "direction_deviation_deg",
    "speed_half_period_s",
    "direction_half_period_s",
};

void DescribeGrid(Fields& fields, CurrentGridOptions& grid) {
  if (fields.Has("grid", !grid.file.empty())) fields.Text("grid", grid.file, kPathRule);
  if (fields.Has("grid_east", !grid.east.empty())) fields.Text("grid_east", grid.east, kPathRule);
  if (fields.Has("grid_north", !grid.north.empty())) {
    fields.Text("grid_north", grid.north, kPathRule);
  }
  fields.Pair("grid_origin", grid.origin_m, Between(-1e9, 1e9));
  fields.Text("grid_time", grid.time, {.min_length = 1, .max_length = 64});
  if (!fields.reading() || !fields.IsSound()) return;
  const std::string problem = GridProblem(grid);
  if (!problem.empty()) fields.Refuse(fields.Has("grid", true) ? "grid" : "grid_east", problem);
  for (const std::string_view key : kWordKeys) {
    if (!fields.Has(key, false)) continue;
    fields.Skip(key);
    fields.Refuse(key, std::string(key) +
                           " has no effect beside a grid, which is the whole current: "
                           "remove one of them");
  }
}

void DescribeCurrent(Fields& fields, Environment& environment) {
  CurrentGridOptions& grid = environment.current_grid;
  bool has_grid = grid.exists();
  for (const char* key : {"grid", "grid_east", "grid_north", "grid_origin", "grid_time"}) {
    if (fields.reading()) has_grid = has_grid || fields.Has(key, false);
  }
  if (has_grid) return DescribeGrid(fields, grid);
  DescribeWords(fields, environment.current);
}

void Describe(Fields& fields, PlumeOptions& plume) {
  plume.exists = true;
  fields.Triple("source", plume.source_m, Between(-kFarthest_m, kFarthest_m));
  fields.Number("rate_gps", plume.rate_gps, Between(0, 1e9));
  fields.Number("current_mps", plume.current_mps, Between(0, kFastest_mps));
  fields.Number("direction_deg", plume.direction_deg, Between(-360, 360));
  if (plume.source_m.z() < 0 || plume.source_m.z() > 20'000) {
    fields.Refuse("source", "source is [x, y, depth], with a depth from 0 to 20000 m");
  }
}

}  // namespace

void Describe(Fields& fields, FloorOptions& floor) {
  constexpr std::array<std::string_view, 6> kStyles = {"none",    "flat",  "linear",
                                                       "sigmoid", "shelf", "grid"};
  fields.Word("style", floor.style, kStyles);
  fields.Number("depth_m", floor.depth_m, Between(0, 20'000));
  fields.Number("range_m", floor.range_m, Between(0, 20'000));
  fields.Number("size_m", floor.size_m, Between(1, 1e6));
  fields.Number("scale_m", floor.scale_m, Between(1, 1e6));
  fields.Number("slope_east", floor.slope_east, Between(-10, 10));
  fields.Number("slope_north", floor.slope_north, Between(-10, 10));
  if (fields.Has("grid", !floor.grid.empty())) {
    fields.Text("grid", floor.grid, kPathRule);
    if (fields.reading() && floor.style == "none") floor.style = "grid";
  }
  if (fields.Has("grid_is_depth", floor.grid_is_depth.has_value())) {
    bool is_depth = floor.grid_is_depth.value_or(false);
    fields.Flag("grid_is_depth", is_depth);
    floor.grid_is_depth = is_depth;
  }
  fields.Pair("grid_origin", floor.grid_origin_m, Between(-1e9, 1e9));
  if (fields.Has("grid_gap_depth_m", floor.grid_gap_depth_m >= 0)) {
    fields.Number("grid_gap_depth_m", floor.grid_gap_depth_m, Between(0, 20'000));
  }
  if (fields.reading() && floor.style == "grid" && !fields.Has("grid", true)) {
    fields.Refuse("style",
                  "style = \"grid\" needs grid = \"bay.asc\", an ESRI ASCII file, or \"bay.nc\"");
  }
}

void Describe(Fields& fields, Environment& environment) {
  constexpr std::array<std::pair<std::string_view, ContactRule>, 2> kContactRules = {{
      {"ignore", ContactRule::kIgnore},
      {"stop", ContactRule::kStop},
  }};
  fields.Choice("contact", environment.contact, kContactRules);
  fields.Inline("current", [&](Fields& current) { DescribeCurrent(current, environment); });
  fields.Inline("floor", [&](Fields& floor) { Describe(floor, environment.floor); });
  if (fields.Has("plume", environment.plume.exists)) {
    fields.Inline("plume", [&](Fields& plume) { Describe(plume, environment.plume); });
  }
}

}  // namespace shoal
