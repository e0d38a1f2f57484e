#include "lib/mission/file/grid_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/model/mission.h"
#include "lib/mission/netcdf/cf_field.h"
#include "lib/mission/netcdf/cf_variables.h"
#include "lib/mission/netcdf/netcdf_file.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/track/iso_time.h"
#include "lib/sea/ocean/current.h"
#include "lib/sea/ocean/esri_grid.h"

namespace shoal {

namespace {

constexpr std::string_view kNetcdfEnding = ".nc";
constexpr double kMaxGridElevation_m = 20'000;
constexpr double kMicrosecondsPerSecond = 1e6;

std::string PathOf(const std::string& file, const GridPlacement& placement) {
  return (std::filesystem::path(placement.folder) / file).string();
}

Error CannotOpen(const std::string& path, const std::string& problem) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    return Error{path + ": is a directory; name the grid's file in it"};
  }
  return Error{path + ": " + problem + "; a grid's path counts from the mission file's folder"};
}

/// An open NetCDF file.
struct OpenGrid {
  FileDescriptor fd;
  NetcdfFile file;
};

Result<OpenGrid> OpenNetcdf(const std::string& path) {
  Result<FileDescriptor> fd = OpenRegularFile(path);
  if (!fd.ok()) return CannotOpen(path, fd.error());
  Result<NetcdfFile> file = NetcdfFile::Open(fd->get(), path);
  if (!file.ok()) return Error{file.error()};
  return OpenGrid{.fd = std::move(*fd), .file = std::move(*file)};
}

/// Returns what is wrong with the origin of a grid in degrees; empty: nothing.
std::string OriginProblem(const CfField& field, const Eigen::Vector2d& origin_m) {
  if (!field.is_geographic || origin_m.isZero()) return "";
  return "has latitudes and longitudes, among which the mission's own origin counts: remove "
         "grid_origin";
}

GridMap MapOf(const CfField& field, const Eigen::Vector2d& origin_m,
              const GridPlacement& placement) {
  if (field.is_geographic) {
    return {GeoPoint{.lat_deg = placement.origin_lat_deg, .lon_deg = placement.origin_lon_deg},
            GridAxis(field.x), GridAxis(field.y)};
  }
  std::vector<double> x_m = field.x;
  std::vector<double> y_m = field.y;
  for (double& x : x_m) x -= origin_m.x();
  for (double& y : y_m) y -= origin_m.y();
  return {GridAxis(std::move(x_m)), GridAxis(std::move(y_m))};
}

/// Returns where the value of this number stands, for messages.
std::string PointText(const CfField& field, size_t index) {
  const double x = field.x[index % field.x.size()];
  const double y = field.y[index / field.x.size() % field.y.size()];
  return field.is_geographic ? fmt::format("latitude {:.10g}, longitude {:.10g}", y, x)
                             : fmt::format("x = {:.10g} m, y = {:.10g} m", x, y);
}

/// Returns the first value that is beyond `most` on either side; nothing: there is none.
std::optional<size_t> FindBeyond(const std::vector<float>& values, double most) {
  for (size_t i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) > most) return i;
  }
  return std::nullopt;
}

/// Makes elevations, or depths, the depths of a sea floor. Returns what is wrong; empty: nothing.
std::string MakeDepths(CfField& field, bool are_depths, double gap_depth_m) {
  for (size_t i = 0; i < field.values.size(); ++i) {
    float& value = field.values[i];
    if (std::isnan(value)) {
      if (gap_depth_m < 0) {
        return fmt::format("has no data at {}; give points without data a depth: grid_gap_depth_m",
                           PointText(field, i));
      }
      value = static_cast<float>(gap_depth_m);
      continue;
    }
    if (std::abs(value) > kMaxGridElevation_m) {
      return fmt::format(
          "is {:g} at {}, further from the surface than {:g} m; is it the mark for no "
          "data? Then give the variable a _FillValue",
          value, PointText(field, i), kMaxGridElevation_m);
    }
    value = std::max(0.0F, are_depths ? value : -value);
  }
  return "";
}

Result<DepthGrid> ReadNetcdfFloor(const FloorOptions& options, const GridName& name,
                                  const GridPlacement& placement) {
  const std::string path = PathOf(name.file, placement);
  const Result<OpenGrid> grid = OpenNetcdf(path);
  if (!grid.ok()) return Error{grid.error()};
  const Result<std::string> variable = name.variable.empty()
                                           ? FindFloorVariable(grid->file.header(), path)
                                           : Result<std::string>(name.variable);
  if (!variable.ok()) return Error{variable.error()};
  Result<CfField> field = ReadCfField(SourceOf(grid->file), *variable, CfQuantity::kMetres);
  if (!field.ok()) return Error{field.error()};
  const bool are_depths =
      HoldsDepths(*grid->file.header().Find(*variable)).value_or(options.grid_is_depth);
  std::string problem = OriginProblem(*field, options.grid_origin_m);
  if (problem.empty() && field->depths_m.size() * field->times_s.size() > 1) {
    problem = "is one of several times or depths, and the sea floor has neither; cut out one";
  }
  if (problem.empty()) problem = MakeDepths(*field, are_depths, options.grid_gap_depth_m);
  if (!problem.empty()) {
    return Error{fmt::format("{}: variable '{}' {}", path, *variable, problem)};
  }
  return DepthGrid(MapOf(*field, options.grid_origin_m, placement), std::move(field->values));
}

Result<EsriField> ReadEsri(const std::string& path, EsriGridOptions options) {
  const FileText file = ReadRegularFile(path);
  if (!file.problem.empty()) return CannotOpen(path, file.problem);
  options.name = path;
  return ParseEsriField(file.text, options);
}

constexpr char kOtherPoints[] =
    "are on different points; both components must be known at the same places, depths and times: "
    "interpolate one to the other's, for example with cdo remapbil";

Result<CurrentGrid> ReadEsriCurrent(const CurrentGridOptions& options,
                                    const GridPlacement& placement) {
  const EsriGridOptions esri = {.values = GridValues::kVelocity,
                                .mission_origin_m = options.origin_m};
  Result<EsriField> east = ReadEsri(PathOf(options.east, placement), esri);
  if (!east.ok()) return Error{east.error()};
  Result<EsriField> north = ReadEsri(PathOf(options.north, placement), esri);
  if (!north.ok()) return Error{north.error()};
  if (east->frame != north->frame) {
    return Error{fmt::format("{} and {} {}", options.east, options.north, kOtherPoints)};
  }
  return CurrentGrid({.map = GridMap(east->frame),
                      .east_mps = std::move(east->values),
                      .north_mps = std::move(north->values)});
}

/// Returns the seconds since 1970 that are the mission's start.
double StartOfGrid(const CurrentGridOptions& options, const CfField& field,
                   const GridPlacement& placement) {
  if (options.time == "first") return field.times_s.front();
  const int64_t utime = options.time == "absolute"
                            ? placement.start_utime
                            : ParseLoggedTime(options.time).value_or(placement.start_utime);
  return static_cast<double>(utime) / kMicrosecondsPerSecond;
}

Result<CfField> ReadComponent(const NetcdfFile& file, const std::string& variable,
                              const Eigen::Vector2d& origin_m) {
  Result<CfField> field = ReadCfField(SourceOf(file), variable, CfQuantity::kMetresPerSecond);
  if (!field.ok()) return field;
  std::string problem = OriginProblem(*field, origin_m);
  if (const auto beyond = FindBeyond(field->values, kMaxCurrent_mps); beyond && problem.empty()) {
    problem = fmt::format(
        "is {:g} m/s at {}, faster than {:g} m/s; is it the mark for no data? "
        "Then give the variable a _FillValue",
        field->values[*beyond], PointText(*field, *beyond), kMaxCurrent_mps);
  }
  if (!problem.empty()) {
    return Error{fmt::format("{}: variable '{}' {}", file.name(), variable, problem)};
  }
  return field;
}

struct Components {
  CfField east;
  CfField north;
};

Result<Components> ReadComponents(const CurrentGridOptions& options,
                                  const GridPlacement& placement) {
  GridName east_name = SplitGridName(options.file.empty() ? options.east : options.file);
  GridName north_name = SplitGridName(options.file.empty() ? options.north : options.file);
  const Result<OpenGrid> east_grid = OpenNetcdf(PathOf(east_name.file, placement));
  if (!east_grid.ok()) return Error{east_grid.error()};
  const Result<OpenGrid> north_grid = north_name.file == east_name.file
                                          ? Result<OpenGrid>(Error{""})
                                          : OpenNetcdf(PathOf(north_name.file, placement));
  if (!north_grid.ok() && !north_grid.error().empty()) return Error{north_grid.error()};
  const NetcdfFile& east_file = east_grid->file;
  const NetcdfFile& north_file = north_grid.ok() ? north_grid->file : east_file;
  if (!options.file.empty()) {
    auto found = FindCurrentVariables(east_file.header(), east_file.name());
    if (!found.ok()) return Error{found.error()};
    std::tie(east_name.variable, north_name.variable) = std::move(*found);
  }
  Result<CfField> east = ReadComponent(east_file, east_name.variable, options.origin_m);
  if (!east.ok()) return Error{east.error()};
  Result<CfField> north = ReadComponent(north_file, north_name.variable, options.origin_m);
  if (!north.ok()) return Error{north.error()};
  if (east->is_geographic != north->is_geographic || east->x != north->x || east->y != north->y ||
      east->depths_m != north->depths_m || east->has_time != north->has_time ||
      east->times_s != north->times_s) {
    return Error{fmt::format("{}: variables '{}' and '{}' {}", east_file.name(), east->variable,
                             north->variable, kOtherPoints)};
  }
  return Components{.east = std::move(*east), .north = std::move(*north)};
}

}  // namespace

GridName SplitGridName(const std::string& text) {
  const std::string lower = LowerCase(text);
  const size_t colon = text.rfind(':');
  if (colon != std::string::npos &&
      std::string_view(lower).substr(0, colon).ends_with(kNetcdfEnding)) {
    return {.file = text.substr(0, colon), .variable = text.substr(colon + 1), .is_netcdf = true};
  }
  return {.file = text, .variable = "", .is_netcdf = lower.ends_with(kNetcdfEnding)};
}

bool IsGridTime(std::string_view text) {
  return text == "first" || text == "absolute" || ParseLoggedTime(text).has_value();
}

GridPlacement PlacementOf(const Mission& mission) {
  return {.folder = std::filesystem::path(mission.file).parent_path().string(),
          .origin_lat_deg = mission.origin_lat_deg,
          .origin_lon_deg = mission.origin_lon_deg,
          .start_utime = mission.start_utime};
}

std::vector<std::string> GridFilesOf(const Environment& environment) {
  const CurrentGridOptions& current = environment.current_grid;
  std::vector<std::string> files;
  for (const std::string& grid :
       {environment.floor.grid, current.file, current.east, current.north}) {
    if (!grid.empty()) files.push_back(SplitGridName(grid).file);
  }
  return files;
}

void NoteGridFilesRead(const Environment& environment, const GridPlacement& placement) {
  for (const std::string& file : GridFilesOf(environment)) NoteFileRead(PathOf(file, placement));
}

Result<DepthGrid> ReadFloorGrid(const FloorOptions& options, const GridPlacement& placement) {
  const GridName name = SplitGridName(options.grid);
  if (name.is_netcdf) return ReadNetcdfFloor(options, name, placement);
  std::optional<double> gap_depth_m;
  if (options.grid_gap_depth_m >= 0) gap_depth_m = options.grid_gap_depth_m;
  Result<EsriField> field =
      ReadEsri(PathOf(options.grid, placement),
               {.values = options.grid_is_depth ? GridValues::kDepth : GridValues::kElevation,
                .mission_origin_m = options.grid_origin_m,
                .nodata_depth_m = gap_depth_m});
  if (!field.ok()) return Error{field.error()};
  return DepthGrid(field->frame, std::move(field->values));
}

Result<CurrentGrid> ReadCurrentGrid(const CurrentGridOptions& options,
                                    const GridPlacement& placement) {
  if (options.file.empty() && !SplitGridName(options.east).is_netcdf) {
    return ReadEsriCurrent(options, placement);
  }
  Result<Components> read = ReadComponents(options, placement);
  if (!read.ok()) return Error{read.error()};
  const CfField& field = read->east;
  std::vector<double> times_s = {0};
  if (field.has_time) {
    times_s = field.times_s;
    const double start_s = StartOfGrid(options, field, placement);
    for (double& time_s : times_s) time_s -= start_s;
  }
  return CurrentGrid({.map = MapOf(field, options.origin_m, placement),
                      .depths_m = field.depths_m,
                      .times_s = std::move(times_s),
                      .east_mps = std::move(read->east.values),
                      .north_mps = std::move(read->north.values)});
}

}  // namespace shoal
