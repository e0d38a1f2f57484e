#include "lib/mission/file/grid_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/file/current_directions.h"
#include "lib/mission/file/floor_reading.h"
#include "lib/mission/model/mission.h"
#include "lib/mission/netcdf/cf_field.h"
#include "lib/mission/netcdf/cf_variables.h"
#include "lib/mission/netcdf/cf_words.h"
#include "lib/mission/netcdf/netcdf_file.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/track/iso_time.h"
#include "lib/sea/ocean/current.h"
#include "lib/sea/ocean/esri_grid.h"
#include "lib/sea/ocean/floor_signs.h"
#include "lib/sea/ocean/gap_marks.h"
#include "lib/sea/ocean/grid_mesh.h"

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

/// Returns what is wrong with the way a grid is placed; empty: nothing.
std::string PlaceProblem(const CfField& field, const Eigen::Vector2d& origin_m) {
  if (field.is_curvilinear() && (field.x.size() < 2 || field.y.size() < 2)) {
    return "has latitudes and longitudes of two dimensions, and less than two points along one of "
           "them; cut out a larger part";
  }
  const bool has_degrees = field.is_geographic || field.is_curvilinear() ||
                           (field.projection && field.projection->is_rotated_pole());
  if (!has_degrees || origin_m.isZero()) return "";
  return "has latitudes and longitudes, among which the mission's own origin counts: remove "
         "grid_origin";
}

GridMap MapOf(const CfField& field, const Eigen::Vector2d& origin_m, const GridPlacement& placement,
              GridNotes& notes) {
  GeoPoint origin = {.lat_deg = placement.origin_lat_deg, .lon_deg = placement.origin_lon_deg};
  if (field.is_curvilinear()) {
    notes.needs_origin = true;
    return GridMap(GridMesh(origin, static_cast<int>(field.x.size()),
                            static_cast<int>(field.y.size()), field.lats_deg, field.lons_deg));
  }
  if (field.is_geographic) {
    notes.needs_origin = true;
    return {origin, GridAxis(field.x), GridAxis(field.y)};
  }
  if (field.projection) {
    if (origin_m.isZero()) {
      notes.needs_origin = true;
    } else {
      origin = field.projection->Reverse(origin_m);
      notes.own_origin = origin;
    }
    return {origin, *field.projection, GridAxis(field.x), GridAxis(field.y)};
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
  if (field.is_curvilinear()) {
    const size_t point = index % (field.x.size() * field.y.size());
    return fmt::format("latitude {:.10g}, longitude {:.10g}", field.lats_deg[point],
                       field.lons_deg[point]);
  }
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

/// Returns the warning of a number that was taken for no data.
std::string MarkText(float mark, const char* remedy) {
  return fmt::format(
      "has the number {:g}, and none near it: it is taken to mark points without data; {}", mark,
      remedy);
}

/// Takes numbers that programs use as marks for no data as such (GapMarks), with a warning; also
/// those that are packed.
void TakeGapMarks(const NetcdfVariable& variable, CfField& field) {
  const auto first_of = [&](const char* name, double otherwise) {
    const std::vector<double>& numbers = variable.NumbersOf(name);
    return numbers.empty() || !std::isfinite(numbers[0]) ? otherwise : numbers[0];
  };
  GapMarks plain;
  GapMarks packed(first_of("scale_factor", 1), first_of("add_offset", 0));
  for (const float value : field.values) {
    if (std::isnan(value)) continue;
    plain.Count(value);
    packed.Count(value);
  }
  std::set<float> found;
  for (const GapMarks* marks : {&plain, &packed}) {
    for (const float mark : marks->Found()) found.insert(mark);
  }
  for (const float mark : found) {
    std::ranges::replace(field.values, mark, std::nanf(""));
    field.warnings.push_back(MarkText(mark, "give the variable a _FillValue"));
  }
}

/// Returns what is wrong with the numbers of a floor, each for itself; empty: nothing.
std::string CountSigns(const CfField& field, bool has_marks, double gap_depth_m,
                       FloorSigns& signs) {
  for (size_t i = 0; i < field.values.size(); ++i) {
    const float value = field.values[i];
    if (std::isnan(value)) {
      if (gap_depth_m >= 0) continue;
      return fmt::format(
          "has no data at {}{}; give points without data a depth: grid_gap_depth_m",
          PointText(field, i),
          has_marks ? " (such a number as -9999, and none near it, counts as none)" : "");
    }
    if (std::abs(value) > kMaxGridElevation_m) {
      return fmt::format(
          "is {:g} at {}, further from the surface than {:g} m; is it the mark for no "
          "data? Then give the variable a _FillValue",
          value, PointText(field, i), kMaxGridElevation_m);
    }
    signs.Count(value);
  }
  return "";
}

void MakeDepths(CfField& field, bool are_depths, double gap_depth_m) {
  for (float& value : field.values) {
    value = std::isnan(value) ? static_cast<float>(gap_depth_m)
                              : std::max(0.0F, are_depths ? value : -value);
  }
}

/// Adds a field's own warnings to those of its grid.
void AddWarnings(const CfField& field, const std::string& path, GridNotes& notes) {
  for (const std::string& warning : field.warnings) {
    notes.warnings.push_back(fmt::format("{}: variable '{}' {}", path, field.variable, warning));
  }
}

Result<GridRead<DepthGrid>> ReadNetcdfFloor(const FloorOptions& options, const GridName& name,
                                            const GridPlacement& placement) {
  const std::string path = PathOf(name.file, placement);
  const Result<OpenGrid> grid = OpenNetcdf(path);
  if (!grid.ok()) return Error{grid.error()};
  const Result<std::string> found = name.variable.empty()
                                        ? FindFloorVariable(grid->file.header(), path)
                                        : Result<std::string>(name.variable);
  if (!found.ok()) return Error{found.error()};
  Result<CfField> field = ReadCfField(SourceOf(grid->file), *found, CfQuantity::kMetres);
  if (!field.ok()) return Error{field.error()};
  const NetcdfVariable& variable = *grid->file.header().Find(*found);
  const std::string where = fmt::format("{}: variable '{}'", path, *found);
  std::string problem = PlaceProblem(*field, options.grid_origin_m);
  if (const auto other = OtherThanFloor(variable); problem.empty() && other) {
    problem = "is not a sea floor: " + *other + "; name another one, or correct that";
  }
  if (problem.empty() && field->depths_m.size() * field->times_s.size() > 1) {
    problem = "is one of several times or depths, and the sea floor has neither; cut out one";
  }
  GridNotes notes;
  FloorSigns signs;
  FloorReading reading;
  const size_t num_warnings = field->warnings.size();
  TakeGapMarks(variable, *field);
  if (problem.empty()) {
    problem =
        CountSigns(*field, field->warnings.size() > num_warnings, options.grid_gap_depth_m, signs);
  }
  if (problem.empty()) problem = SignsProblem(variable, signs, options);
  if (problem.empty()) {
    reading = ReadingOf(variable, signs, options, where, notes);
    problem = LandProblem(signs, reading, options.grid_is_depth == reading.are_depths);
  }
  if (!problem.empty()) return Error{fmt::format("{} {}", where, problem)};
  AddWarnings(*field, path, notes);
  WarnOfLand(signs, reading, path, notes);
  if (CountsFromEllipsoid(variable)) {
    notes.warnings.push_back(
        where +
        " counts from the reference ellipsoid, from which the sea's surface is "
        "up to 110 m away: add the height of the geoid");
  }
  MakeDepths(*field, reading.are_depths, options.grid_gap_depth_m);
  GridMap map = MapOf(*field, options.grid_origin_m, placement, notes);
  return GridRead<DepthGrid>{.grid = DepthGrid(std::move(map), std::move(field->values)),
                             .notes = std::move(notes)};
}

/// Returns why a map is one of degrees, whose coordinates are read as metres; empty: it is not. A
/// map of some metres, as of a tank, lies around the mission's plane.
std::string DegreesProblem(const GridFrame& frame, const GridPlacement& placement) {
  const Eigen::Vector2d low = frame.south_west_m - frame.cell_m / 2;
  const Eigen::Vector2d size(frame.columns * frame.cell_m.x(), frame.rows * frame.cell_m.y());
  const Eigen::Vector2d high = low + size;
  if (low.x() < -180 || high.x() > 360 || low.y() < -90 || high.y() > 90) return "";
  const auto has = [&](double x, double y) {
    return x >= low.x() && x <= high.x() && y >= low.y() && y <= high.y();
  };
  const double lat = placement.origin_lat_deg;
  const double lon = placement.origin_lon_deg;
  const bool has_origin = (lat != 0 || lon != 0) && (has(lon, lat) || has(lon + 360, lat));
  if (std::abs(size.x() - 360) > frame.cell_m.x() / 2 && (!has_origin || has(0, 0))) return "";
  return fmt::format(
      "the map lies from ({:g}, {:g}) to ({:g}, {:g}), which are longitudes and latitudes, and its "
      "coordinates are read as metres: project it, for example with gdalwarp -t_srs and the UTM "
      "zone",
      low.x(), low.y(), high.x(), high.y());
}

Result<EsriField> ReadEsri(const std::string& path, EsriGridOptions options,
                           const GridPlacement& placement) {
  const FileText file = ReadRegularFile(path);
  if (!file.problem.empty()) return CannotOpen(path, file.problem);
  options.name = path;
  Result<EsriField> field = ParseEsriField(file.text, options);
  if (!field.ok() || !options.mission_origin_m.isZero()) return field;
  const std::string problem = DegreesProblem(field->frame, placement);
  if (!problem.empty()) return Error{path + ": " + problem};
  return field;
}

constexpr char kOtherPoints[] =
    "are on different points; both components must be known at the same places, depths and times: "
    "interpolate one to the other's, for example with cdo remapbil";

Result<GridRead<CurrentGrid>> ReadEsriCurrent(const CurrentGridOptions& options,
                                              const GridPlacement& placement) {
  const EsriGridOptions esri = {.values = GridValues::kVelocity,
                                .mission_origin_m = options.origin_m};
  Result<EsriField> east = ReadEsri(PathOf(options.east, placement), esri, placement);
  if (!east.ok()) return Error{east.error()};
  Result<EsriField> north = ReadEsri(PathOf(options.north, placement), esri, placement);
  if (!north.ok()) return Error{north.error()};
  if (east->frame != north->frame) {
    return Error{fmt::format("{} and {} {}", options.east, options.north, kOtherPoints)};
  }
  return GridRead<CurrentGrid>{.grid = CurrentGrid({.map = GridMap(east->frame),
                                                    .east_mps = std::move(east->values),
                                                    .north_mps = std::move(north->values)})};
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
  std::string problem = PlaceProblem(*field, origin_m);
  if (problem.empty() && (field->x.size() < 2 || field->y.size() < 2)) {
    problem =
        "has a single point along one of its horizontal axes, and how far that reaches is not "
        "known: cut out two or more along each, or write the current as speed_mps and "
        "direction_deg";
  }
  const NetcdfVariable& found = *file.header().Find(variable);
  if (const auto other = OtherThanCurrent(found); other && problem.empty()) {
    problem = "is not a current: " + *other + "; name another one, or correct that";
  }
  if (const auto beyond = FindBeyond(field->values, kMaxCurrent_mps); beyond && problem.empty()) {
    problem = fmt::format(
        "is {:g} m/s at {}, faster than {:g} m/s; is it the mark for no data? "
        "Then give the variable a _FillValue",
        field->values[*beyond], PointText(*field, *beyond), kMaxCurrent_mps);
  }
  if (!problem.empty()) {
    return Error{fmt::format("{}: variable '{}' {}", file.name(), variable, problem)};
  }
  TakeGapMarks(found, *field);
  return field;
}

/// Whether two fields are known at the same places. NaN is the same place as NaN.
bool HaveSamePlaces(const CfField& a, const CfField& b) {
  const auto is_same = [](double x, double y) {
    return x == y || (std::isnan(x) && std::isnan(y));
  };
  const auto are_same = [&](const std::vector<double>& x, const std::vector<double>& y) {
    return std::ranges::equal(x, y, is_same);
  };
  if (a.is_geographic != b.is_geographic || a.projection.has_value() != b.projection.has_value() ||
      a.x != b.x || a.y != b.y || !are_same(a.lats_deg, b.lats_deg) ||
      !are_same(a.lons_deg, b.lons_deg)) {
    return false;
  }
  if (!a.projection) return true;
  const Eigen::Vector2d first(a.x.front(), a.y.front());
  const Eigen::Vector2d last(a.x.back(), a.y.back());
  const GeoPoint at_first = a.projection->Reverse(first);
  const GeoPoint at_last = a.projection->Reverse(last);
  return is_same(at_first.lat_deg, b.projection->Reverse(first).lat_deg) &&
         is_same(at_first.lon_deg, b.projection->Reverse(first).lon_deg) &&
         is_same(at_last.lat_deg, b.projection->Reverse(last).lat_deg) &&
         is_same(at_last.lon_deg, b.projection->Reverse(last).lon_deg);
}

/// Returns the variables of two dimensions that the attribute `coordinates` of one names.
std::set<std::string> PointsNamedBy(const NetcdfHeader& header, const std::string& variable) {
  std::set<std::string> names;
  for (const std::string_view word : WordsOf(header.Find(variable)->TextOf("coordinates"))) {
    const NetcdfVariable* named = header.Find(word);
    if (named != nullptr && named->dimensions.size() == 2) names.insert(named->name);
  }
  return names;
}

/// Returns whether a file names other points for one component than for the other, as those of a
/// staggered grid have, even where both have the same axes.
bool AreStaggered(const NetcdfHeader& header, const CfField& east, const CfField& north) {
  if (east.is_curvilinear()) return false;  // Then the places are compared.
  const std::set<std::string> first = PointsNamedBy(header, east.variable);
  const std::set<std::string> second = PointsNamedBy(header, north.variable);
  return !first.empty() && !second.empty() && first != second;
}

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
  if (!HaveSamePlaces(*east, *north) || east->depths_m != north->depths_m ||
      east->has_time != north->has_time || east->times_s != north->times_s ||
      (!north_grid.ok() && AreStaggered(east_file.header(), *east, *north))) {
    return Error{fmt::format("{}: variables '{}' and '{}' {}", east_file.name(), east->variable,
                             north->variable, kOtherPoints)};
  }
  Components components = {.east = std::move(*east), .north = std::move(*north)};
  // What is wrong with their axes is the same of both.
  std::erase_if(components.north.warnings, [&](const std::string& warning) {
    return std::ranges::find(components.east.warnings, warning) != components.east.warnings.end();
  });
  AddWarnings(components.east, east_file.name(), components.notes);
  AddWarnings(components.north, north_file.name(), components.notes);
  const std::string problem =
      UseDirections(components, DirectionOf(*east_file.header().Find(east_name.variable)),
                    DirectionOf(*north_file.header().Find(north_name.variable)));
  if (!problem.empty()) return Error{east_file.name() + ": " + problem};
  return components;
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

Result<GridRead<DepthGrid>> ReadFloorGrid(const FloorOptions& options,
                                          const GridPlacement& placement) {
  const GridName name = SplitGridName(options.grid);
  if (name.is_netcdf) return ReadNetcdfFloor(options, name, placement);
  const FloorReading reading = {.are_depths = options.grid_is_depth.value_or(false)};
  std::optional<double> gap_depth_m;
  if (options.grid_gap_depth_m >= 0) gap_depth_m = options.grid_gap_depth_m;
  const std::string path = PathOf(options.grid, placement);
  Result<EsriField> field =
      ReadEsri(path,
               {.values = reading.are_depths ? GridValues::kDepth : GridValues::kElevation,
                .mission_origin_m = options.grid_origin_m,
                .nodata_depth_m = gap_depth_m},
               placement);
  if (!field.ok()) return Error{field.error()};
  const std::string problem = LandProblem(field->signs, reading, options.grid_is_depth.has_value());
  if (!problem.empty()) return Error{path + ": the map " + problem};
  GridNotes notes;
  for (const float mark : field->gap_marks) {
    notes.warnings.push_back(path + " " + MarkText(mark, "set NODATA_value"));
  }
  WarnOfLand(field->signs, reading, path, notes);
  return GridRead<DepthGrid>{.grid = DepthGrid(field->frame, std::move(field->values)),
                             .notes = std::move(notes)};
}

Result<GridRead<CurrentGrid>> ReadCurrentGrid(const CurrentGridOptions& options,
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
  GridMap map = MapOf(field, options.origin_m, placement, read->notes);
  const GeoPoint origin = {.lat_deg = placement.origin_lat_deg,
                           .lon_deg = placement.origin_lon_deg};
  TurnToPlane(*read, read->notes.own_origin.value_or(origin));
  return GridRead<CurrentGrid>{.grid = CurrentGrid({.map = std::move(map),
                                                    .depths_m = field.depths_m,
                                                    .times_s = std::move(times_s),
                                                    .east_mps = std::move(read->east.values),
                                                    .north_mps = std::move(read->north.values)}),
                               .notes = std::move(read->notes)};
}

}  // namespace shoal
