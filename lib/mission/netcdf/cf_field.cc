#include "lib/mission/netcdf/cf_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/netcdf/cf_axes.h"
#include "lib/mission/netcdf/cf_mapping.h"
#include "lib/mission/netcdf/cf_time.h"
#include "lib/mission/netcdf/cf_values.h"
#include "lib/mission/netcdf/cf_words.h"
#include "lib/mission/netcdf/netcdf_file.h"

namespace shoal {

namespace {

constexpr double kMetresPerKilometre = 1000;
constexpr char kCurvilinear[] =
    "interpolate it to a grid with one axis of latitudes and one of longitudes, for example with "
    "cdo remapbil";

/// Reads one field. A step that cannot go on returns what is wrong, empty: nothing.
class CfReader {
 public:
  CfReader(const CfSource& source, const NetcdfVariable& variable, CfQuantity quantity)
      : source_(source), header_(source.header), variable_(variable), quantity_(quantity) {}

  Result<CfField> Read() {
    for (const auto step : {&CfReader::ReadAxes, &CfReader::UseAxes, &CfReader::ReadValues}) {
      const std::string problem = (this->*step)();
      if (!read_error_.empty()) return Error{read_error_};
      if (!problem.empty()) {
        return Error{fmt::format("{}: variable '{}' {}", source_.name,
                                 PrintableName(variable_.name), problem)};
      }
    }
    return std::move(field_);
  }

 private:
  /// An axis of the variable, and how far apart its neighbours are in the file.
  struct Role {
    CfAxis axis = {.points = {0}, .source = {0}};
    const NetcdfVariable* coordinate = nullptr;  ///< Null: there is none.
    size_t stride = 0;
    uint32_t dimension = 0;
    bool is_geographic = false;
    bool is_rotated = false;
  };

  /// A dimension of which it is not known what it counts, and the error that this is at the end.
  struct Loose {
    uint32_t dimension = 0;
    size_t stride = 0;
    std::string problem = {};
  };

  Role& At(CfRole role) { return roles_[static_cast<size_t>(role)]; }

  std::string ReadAxes() {
    size_t stride = 1;
    for (size_t i = variable_.dimensions.size(); i-- > 0;) {
      const uint32_t dimension = variable_.dimensions[i];
      if (std::string problem = ReadAxis(dimension, stride); !problem.empty()) return problem;
      stride *= header_.dimensions[dimension].length;
    }
    return "";
  }

  std::string ReadAxis(uint32_t number, size_t stride) {
    const NetcdfDimension& dimension = header_.dimensions[number];
    const std::string name = PrintableName(dimension.name);
    const NetcdfVariable* coordinate = header_.Find(dimension.name);
    const bool has_axis =
        coordinate != nullptr && coordinate->dimensions == std::vector<uint32_t>{number};
    const std::optional<CfAxisKind> kind = has_axis ? AxisKindOf(*coordinate) : std::nullopt;
    if (!kind) {
      if (dimension.length != 1) AddLoose(number, stride, has_axis);
      return "";
    }
    Role& role = At(kind->role);
    if (role.coordinate != nullptr) {
      return fmt::format("has two axes of one kind, '{}' and '{}'; correct their units",
                         PrintableName(role.coordinate->name), name);
    }
    if ((kind->is_geographic || kind->is_rotated) && !IsInDegrees(*coordinate)) {
      return UnitProblem(*coordinate, "degrees");
    }
    Result<std::vector<double>> points = source_.read(*coordinate);
    if (!points.ok()) return read_error_ = points.error();
    const bool are_longitudes =
        (kind->is_geographic || kind->is_rotated) && kind->role == CfRole::kEast;
    const std::optional<CfAxis> axis =
        Ascending(Unpacked(*coordinate, std::move(*points)), are_longitudes);
    if (!axis) {
      return fmt::format(
          "has an axis '{}' that is empty, or whose values neither rise nor fall "
          "from point to point; write the file again",
          name);
    }
    role = {.axis = *axis,
            .coordinate = coordinate,
            .stride = stride,
            .dimension = number,
            .is_geographic = kind->is_geographic,
            .is_rotated = kind->is_rotated};
    return "";
  }

  void AddLoose(uint32_t number, size_t stride, bool has_axis) {
    const std::string name = PrintableName(header_.dimensions[number].name);
    std::string problem;
    if (has_axis) {
      problem = fmt::format(
          "has an axis '{}' of no known kind; give it units (degrees_north, "
          "degrees_east, \"hours since ...\") or a standard_name (latitude, longitude, "
          "projection_x_coordinate, projection_y_coordinate, depth, time)",
          name);
    } else {
      const bool is_curvilinear = !variable_.TextOf("coordinates").empty();
      problem = fmt::format(
          "has a dimension '{}' without a variable of that name, which would hold "
          "its coordinates; {}",
          name, is_curvilinear ? kCurvilinear : "add it, with units such as degrees_north");
    }
    loose_.push_back({.dimension = number, .stride = stride, .problem = std::move(problem)});
  }

  std::string UseAxes() {
    for (const auto step :
         {&CfReader::FindPlane, &CfReader::CheckPlane, &CfReader::UseDepths, &CfReader::UseTimes}) {
      std::string problem = (this->*step)();
      if (!problem.empty() || !read_error_.empty()) return problem;
    }
    return "";
  }

  /// Finds what shows where the points lie.
  std::string FindPlane() {
    const Role& x = At(CfRole::kEast);
    const Role& y = At(CfRole::kNorth);
    const bool has_axes = x.coordinate != nullptr && y.coordinate != nullptr;
    if (has_axes && x.is_geographic != y.is_geographic) {
      return "has one axis in degrees and one in metres; correct their units";
    }
    field_.variable = variable_.name;
    const bool is_geographic = has_axes && x.is_geographic;
    const NetcdfVariable* mapping = nullptr;
    if (has_axes) {
      const auto found = FindMapping(header_, variable_, x.coordinate->name);
      if (found.ok()) mapping = *found;
      // That of latitudes and longitudes has nothing that these need, but another meridian.
      if (!found.ok() && !is_geographic) return found.error();
    }
    if (is_geographic && mapping != nullptr) {
      const Result<double> meridian_deg = PrimeMeridianOf(*mapping);
      if (!meridian_deg.ok()) return meridian_deg.error();
      for (double& lon_deg : At(CfRole::kEast).axis.points) lon_deg += *meridian_deg;
      mapping = nullptr;
    }
    const std::string map_problem = mapping == nullptr ? "" : UseMapping(*mapping);
    if (!is_geographic && !field_.projection) {
      if (std::string problem = FindPoints(); !problem.empty() || !read_error_.empty()) {
        return problem;
      }
    }
    if (!loose_.empty()) return loose_.front().problem;
    if (x.coordinate == nullptr || y.coordinate == nullptr) {
      return "has no axes of latitude and longitude, or x and y; name another one after the file: "
             "file.nc:variable";
    }
    field_.is_geographic = is_geographic;
    field_.x = x.axis.points;
    field_.y = y.axis.points;
    if (is_geographic || field_.is_curvilinear()) return "";
    return mapping == nullptr ? CheckUnmapped() : map_problem;
  }

  std::string UseMapping(const NetcdfVariable& mapping) {
    Result<MapProjection> projection =
        ProjectionOf(mapping, MetresIn(*At(CfRole::kEast).coordinate).value_or(1));
    if (!projection.ok()) return projection.error();
    const bool is_rotated = projection->is_rotated_pole();
    if (is_rotated != At(CfRole::kEast).is_rotated || is_rotated != At(CfRole::kNorth).is_rotated) {
      return fmt::format(
          "has axes that are not those of its grid_mapping '{}'; correct their "
          "standard_names",
          PrintableName(mapping.name));
    }
    if (!is_rotated && !HasFigure(mapping)) {
      field_.warnings.push_back(fmt::format(
          "has the grid_mapping '{}' without a figure of the Earth, which is taken for a sphere of "
          "6371 km: if the map is of an ellipsoid, the grid is up to 20 km off; give it "
          "semi_major_axis and inverse_flattening, or earth_radius",
          PrintableName(mapping.name)));
    }
    field_.projection = std::move(*projection);
    return "";
  }

  /// Axes in metres without a map: those of the mission.
  std::string CheckUnmapped() {
    const Role& x = At(CfRole::kEast);
    if (x.is_rotated || At(CfRole::kNorth).is_rotated) {
      return "is on a grid about another pole, and no grid_mapping names that; copy the variable "
             "with grid_north_pole_latitude and grid_north_pole_longitude into the file too";
    }
    if (LowerCase(Trimmed(x.coordinate->TextOf("standard_name"))) == "projection_x_coordinate") {
      field_.warnings.push_back(
          "is on a projected map that no grid_mapping names: its axes are taken to point East and "
          "North, which those of most maps do not");
    }
    return "";
  }

  /// Variables with the places of all points of the plane.
  struct Points {
    const NetcdfVariable* lats = nullptr;
    const NetcdfVariable* lons = nullptr;
  };

  /// Without a map that is known, looks for latitudes and longitudes of the two dimensions that are
  /// left, or have axes that count something else than degrees. Where there are none it changes
  /// nothing.
  std::string FindPoints() {
    std::vector<Points> pairs;
    for (const NetcdfVariable& lats : header_.variables) {
      if (!IsOnPlane(lats, CfRole::kNorth)) continue;
      for (const NetcdfVariable& lons : header_.variables) {
        if (lons.dimensions == lats.dimensions && IsOnPlane(lons, CfRole::kEast)) {
          pairs.push_back({.lats = &lats, .lons = &lons});
        }
      }
    }
    if (pairs.empty()) return "";
    const std::string coordinates(variable_.TextOf("coordinates"));
    const std::vector<std::string_view> words = WordsOf(coordinates);
    const auto named = std::ranges::find_if(pairs, [&](const Points& pair) {
      return std::ranges::find(words, pair.lats->name) != words.end() &&
             std::ranges::find(words, pair.lons->name) != words.end();
    });
    if (named != pairs.end()) return UsePoints(*named);
    if (pairs.size() > 1) {
      return fmt::format(
          "may lie at the latitudes '{}' or '{}', or the longitudes '{}' or '{}'; name those of "
          "its "
          "points in its attribute coordinates = \"{} {}\"",
          PrintableName(pairs[0].lats->name), PrintableName(pairs.back().lats->name),
          PrintableName(pairs[0].lons->name), PrintableName(pairs.back().lons->name),
          PrintableName(pairs[0].lons->name), PrintableName(pairs[0].lats->name));
    }
    if (!words.empty()) {
      field_.warnings.push_back(fmt::format(
          "names in its attribute coordinates '{}' no latitudes and longitudes of its dimensions: "
          "'{}' and '{}' are taken, the only ones in the file",
          PrintableName(coordinates), PrintableName(pairs[0].lats->name),
          PrintableName(pairs[0].lons->name)));
    }
    return UsePoints(pairs[0]);
  }

  /// Returns whether a variable has latitudes, or longitudes, of two dimensions of the plane.
  bool IsOnPlane(const NetcdfVariable& degrees, CfRole role) const {
    const auto kind = AxisKindOf(degrees);
    return degrees.dimensions.size() == 2 && degrees.type != NetcdfType::kOther && kind &&
           kind->is_geographic && kind->role == role &&
           degrees.dimensions[0] != degrees.dimensions[1] && StrideOf(degrees.dimensions[0]) &&
           StrideOf(degrees.dimensions[1]);
  }

  /// Returns the stride of a dimension of the plane; nothing: it is not one.
  std::optional<size_t> StrideOf(uint32_t dimension) const {
    const auto loose = std::ranges::find(loose_, dimension, &Loose::dimension);
    if (loose != loose_.end()) return loose->stride;
    for (const CfRole role : {CfRole::kEast, CfRole::kNorth}) {
      const Role& axis = roles_[static_cast<size_t>(role)];
      if (axis.coordinate != nullptr && axis.dimension == dimension) return axis.stride;
    }
    return std::nullopt;
  }

  /// Returns what a dimension of the plane is: by its axis, else by its name.
  std::optional<CfRole> RoleOf(uint32_t dimension) const {
    for (const CfRole role : {CfRole::kEast, CfRole::kNorth}) {
      const Role& axis = roles_[static_cast<size_t>(role)];
      if (axis.coordinate != nullptr && axis.dimension == dimension) return role;
    }
    return RoleOfDimension(header_.dimensions[dimension].name);
  }

  /// Makes a dimension of the plane count points. They stay in the order of its axis, ascending:
  /// along it run the components of a current.
  Role CountPoints(uint32_t dimension, const NetcdfVariable& coordinate) const {
    Role role = {.coordinate = &coordinate, .stride = *StrideOf(dimension), .dimension = dimension};
    for (const CfRole each : {CfRole::kEast, CfRole::kNorth}) {
      const Role& axis = roles_[static_cast<size_t>(each)];
      if (axis.coordinate != nullptr && axis.dimension == dimension) role.axis = axis.axis;
    }
    const size_t length = header_.dimensions[dimension].length;
    if (role.axis.source.size() < length) {
      role.axis.source.resize(length);
      std::iota(role.axis.source.begin(), role.axis.source.end(), size_t{0});
    }
    role.axis.points.resize(role.axis.source.size());
    std::iota(role.axis.points.begin(), role.axis.points.end(), 0.0);
    return role;
  }

  std::string UsePoints(const Points& points) {
    if (const auto mapping = FindMapping(header_, variable_, ""); mapping.ok() && *mapping) {
      const Result<double> meridian_deg = PrimeMeridianOf(**mapping);
      if (!meridian_deg.ok()) return meridian_deg.error();
      if (*meridian_deg != 0) {
        return "has longitudes of two dimensions, and a grid_mapping whose longitudes do not count "
               "from Greenwich: whether these do is not clear; make them count from there, and "
               "remove "
               "longitude_of_prime_meridian";
      }
    }
    const std::vector<uint32_t>& dimensions = points.lats->dimensions;
    // Models store rows of x, unless axes or names state the other order.
    const std::optional<CfRole> first = RoleOf(dimensions[0]);
    const std::optional<CfRole> second = RoleOf(dimensions[1]);
    const bool is_x_first = (first == CfRole::kEast && second != CfRole::kEast) ||
                            (second == CfRole::kNorth && first != CfRole::kNorth);
    field_.is_x_known = first != second;
    const uint32_t x_dimension = dimensions[is_x_first ? 0 : 1];
    const uint32_t y_dimension = dimensions[is_x_first ? 1 : 0];
    Role east = CountPoints(x_dimension, *points.lons);
    Role north = CountPoints(y_dimension, *points.lats);
    const size_t row_length = header_.dimensions[dimensions[1]].length;
    const size_t x_stride = is_x_first ? row_length : 1;
    const size_t y_stride = is_x_first ? 1 : row_length;
    for (const auto& [variable, degrees] :
         {std::pair(points.lats, &field_.lats_deg), std::pair(points.lons, &field_.lons_deg)}) {
      if (!IsInDegrees(*variable)) return UnitProblem(*variable, "degrees");
      Result<std::vector<double>> read = source_.read(*variable);
      if (!read.ok()) return read_error_ = read.error();
      const std::vector<double> stored = Unpacked(*variable, std::move(*read));
      degrees->reserve(stored.size());
      for (const size_t y : north.axis.source) {
        for (const size_t x : east.axis.source) {
          degrees->push_back(stored[y * y_stride + x * x_stride]);
        }
      }
      if (degrees->empty()) return "has latitudes or longitudes without a value; write it again";
    }
    At(CfRole::kEast) = std::move(east);
    At(CfRole::kNorth) = std::move(north);
    std::erase_if(loose_, [&](const Loose& each) {
      return each.dimension == x_dimension || each.dimension == y_dimension;
    });
    return "";
  }

  std::string CheckPlane() {
    if (field_.is_curvilinear()) return "";
    if (field_.is_geographic || (field_.projection && field_.projection->is_rotated_pole())) {
      if (std::abs(field_.y.front()) <= 90 && std::abs(field_.y.back()) <= 90 &&
          field_.x.back() - field_.x.front() <= 361) {
        return "";
      }
      return "has latitudes beyond 90 degrees, or longitudes more than once round the Earth; the "
             "file is damaged, or its units are wrong";
    }
    for (const auto& [role, axis] :
         {std::pair(CfRole::kEast, &field_.x), std::pair(CfRole::kNorth, &field_.y)}) {
      const std::optional<double> unit = MetresIn(*At(role).coordinate);
      if (!unit) return UnitProblem(*At(role).coordinate, "metres (m) or kilometres (km)");
      for (double& point : *axis) point *= *unit;
      if (std::max(std::abs(axis->front()), std::abs(axis->back())) > 1e9) {
        return "has coordinates beyond 1e9 metres; the file is damaged, or its units are wrong";
      }
    }
    return "";
  }

  std::string UseDepths() {
    Role& depth = At(CfRole::kDepth);
    if (depth.coordinate == nullptr) return "";
    const std::optional<double> unit = MetresIn(*depth.coordinate);
    if (!unit || IsLevel(*depth.coordinate)) {
      return UnitProblem(*depth.coordinate,
                         "metres: levels of sigma, density or pressure "
                         "must be interpolated to depths first");
    }
    if (AreShares(depth)) {
      return fmt::format(
          "has an axis '{}' without units, of which no point is beyond 1, as levels of sigma have "
          "them: give it units = \"m\" if these are metres; levels must be interpolated to depths "
          "first",
          PrintableName(depth.coordinate->name));
    }
    if (AreNumbers(depth)) {
      field_.warnings.push_back(
          fmt::format("has an axis '{}' without units that counts {:g}, {:g}, {:g}: it is taken to "
                      "be metres; if "
                      "these are the numbers of levels, give it their depths",
                      PrintableName(depth.coordinate->name), depth.axis.points[0],
                      depth.axis.points[1], depth.axis.points[2]));
    }
    const std::string positive = LowerCase(depth.coordinate->TextOf("positive"));
    const std::string standard_name = LowerCase(depth.coordinate->TextOf("standard_name"));
    const bool are_heights =
        positive == "up" ||
        (positive.empty() && (standard_name == "altitude" || standard_name.starts_with("height")));
    if (are_heights) TurnDepths();
    std::vector<double>& points = depth.axis.points;
    const std::string name = PrintableName(depth.coordinate->name);
    if (points.size() > 1 && points.back() <= 0) {
      TurnDepths();
      field_.warnings.push_back(fmt::format(
          "has an axis '{}' whose attributes place all of it above the surface: its numbers are "
          "taken as depths whatever their sign; correct its attribute positive",
          name));
    } else if (points.size() > 1 && points.front() < 0) {
      field_.warnings.push_back(fmt::format("has an axis '{}' that begins {:g} m above the surface",
                                            name, -points.front() * *unit));
    }
    field_.depths_m = points;
    for (double& point : field_.depths_m) point *= *unit;
    return "";
  }

  /// Makes heights of depths, or depths of heights.
  void TurnDepths() {
    CfAxis& axis = At(CfRole::kDepth).axis;
    std::ranges::reverse(axis.points);
    std::ranges::reverse(axis.source);
    for (double& point : axis.points) point = -point;
  }

  /// Returns whether an axis counts no depths, whatever its units: shares of the water's depth, or
  /// metres from the sea floor.
  static bool IsLevel(const NetcdfVariable& axis) {
    const std::string standard_name = LowerCase(axis.TextOf("standard_name"));
    if (!axis.TextOf("formula_terms").empty() || standard_name.starts_with("ocean_") ||
        standard_name.find("sea_floor") != std::string::npos) {
      return true;
    }
    const std::string long_name = LowerCase(axis.TextOf("long_name"));
    const std::string name = LowerCase(axis.name);
    for (const char* word : {"sigma", "s-coordinate", "s_coordinate", "terrain"}) {
      for (const std::string& text : {standard_name, long_name, name}) {
        if (text.find(word) != std::string::npos) return true;
      }
    }
    return name == "s_rho" || name == "s_w" || name == "siglay" || name == "siglev";
  }

  /// Returns whether an axis without units has shares of the water's depth: several, none of them
  /// beyond 1.
  static bool AreShares(const Role& depth) {
    const std::vector<double>& points = depth.axis.points;
    return depth.coordinate->TextOf("units").empty() && points.size() > 1 && points.front() >= -1 &&
           points.back() <= 1 && (points.front() >= 0 || points.back() <= 0);
  }

  /// Returns whether an axis without units counts 0, 1, 2, ... or 1, 2, 3, ...
  static bool AreNumbers(const Role& depth) {
    const std::vector<double>& points = depth.axis.points;
    if (!depth.coordinate->TextOf("units").empty() || points.size() < 3) return false;
    if (points[0] != 0 && points[0] != 1) return false;
    for (size_t i = 1; i < points.size(); ++i) {
      if (points[i] != points[0] + static_cast<double>(i)) return false;
    }
    return true;
  }

  std::string UseTimes() {
    const Role& time = At(CfRole::kTime);
    if (time.coordinate == nullptr) return "";
    const std::string_view calendar = time.coordinate->TextOf("calendar");
    const std::optional<CfTimeUnit> unit =
        ParseCfTimeUnit(time.coordinate->TextOf("units"), calendar);
    if (!unit || !IsRealCalendar(calendar)) {
      return fmt::format(
          "has times in '{}' of the calendar '{}'; they must count seconds, minutes, "
          "hours or days since a date like 2026-11-24 06:00:00, of the standard "
          "calendar, not before the year 1",
          PrintableName(time.coordinate->TextOf("units")), PrintableName(calendar));
    }
    if (calendar.empty() && IsBeforeGregorian(*unit)) {
      field_.warnings.push_back(fmt::format(
          "has times in '{}' of no calendar, which count Julian days before 1582-10-15; if they "
          "are "
          "two days off, give the times the attribute calendar = \"proleptic_gregorian\"",
          PrintableName(time.coordinate->TextOf("units"))));
    }
    field_.times_s = time.axis.points;
    for (double& point : field_.times_s) point = unit->epoch_s + point * unit->unit_s;
    if (std::max(std::abs(field_.times_s.front()), std::abs(field_.times_s.back())) > 1e12) {
      return "has times far beyond the calendar; the file is damaged, or its units are wrong";
    }
    if (std::ranges::adjacent_find(field_.times_s, std::greater_equal<>()) !=
        field_.times_s.end()) {
      return "has times that are equal; write the file again";
    }
    field_.has_time = true;
    return "";
  }

  static std::optional<double> MetresIn(const NetcdfVariable& coordinate) {
    const std::string units = LowerCase(Trimmed(coordinate.TextOf("units")));
    if (units.empty() || units == "m" || units == "meter" || units == "meters" ||
        units == "metre" || units == "metres") {
      return 1;
    }
    return units == "km" ? std::optional(kMetresPerKilometre) : std::nullopt;
  }

  /// Without units an axis that is called so is in degrees.
  static bool IsInDegrees(const NetcdfVariable& coordinate) {
    const std::string units = LowerCase(coordinate.TextOf("units"));
    return units.empty() || units.starts_with("deg") || units.starts_with("\u00b0");
  }

  static std::string UnitProblem(const NetcdfVariable& coordinate, const std::string& wanted) {
    return fmt::format("has an axis '{}' in '{}'; it must be in {}", PrintableName(coordinate.name),
                       PrintableName(coordinate.TextOf("units")), wanted);
  }

  /// Returns how many metres, or metres per second, 1 of the variable is.
  std::optional<double> UnitOfValues() const {
    if (quantity_ == CfQuantity::kMetres) return MetresIn(variable_);
    std::string units = LowerCase(Trimmed(variable_.TextOf("units")));
    std::erase_if(units, [](char c) { return c == '*' || c == '^' || c == '.'; });
    const bool is_centimetres = units.starts_with("cm") || units.starts_with("centimet");
    for (const std::string_view length : {"centimeters", "centimeter", "centimetre", "cm", "meters",
                                          "meter", "metres", "metre", "m"}) {
      if (!units.starts_with(length)) continue;
      units.erase(0, length.size());
      break;
    }
    std::erase(units, ' ');
    const bool is_per_second = units == "s-1" || units == "/s" || units == "second-1" ||
                               units == "/second" || units == "/sec" || units == "sec-1";
    if (variable_.TextOf("units").empty()) return 1;
    if (!is_per_second) return std::nullopt;
    return is_centimetres ? 0.01 : 1;
  }

  std::string ReadValues() {
    const std::optional<double> unit = UnitOfValues();
    if (!unit) {
      return fmt::format("is in '{}', not in {}; name another one after the file: file.nc:variable",
                         PrintableName(variable_.TextOf("units")),
                         quantity_ == CfQuantity::kMetres ? "metres" : "m s-1");
    }
    Result<std::vector<double>> read = source_.read(variable_);
    if (!read.ok()) return read_error_ = read.error();
    const std::vector<double> values = Unpacked(variable_, std::move(*read));
    const auto& [time, depth, north, east] = roles_;
    field_.values.reserve(time.axis.source.size() * depth.axis.source.size() *
                          north.axis.source.size() * east.axis.source.size());
    for (const size_t t : time.axis.source) {
      for (const size_t z : depth.axis.source) {
        for (const size_t y : north.axis.source) {
          const size_t row = t * time.stride + z * depth.stride + y * north.stride;
          for (const size_t x : east.axis.source) {
            field_.values.push_back(static_cast<float>(values[row + x * east.stride] * *unit));
          }
        }
      }
    }
    return "";
  }

  const CfSource& source_;
  const NetcdfHeader& header_;
  const NetcdfVariable& variable_;
  const CfQuantity quantity_;
  std::array<Role, kNumCfRoles> roles_;  ///< By CfRole.
  std::vector<Loose> loose_;             ///< From the dimension that varies fastest.
  CfField field_;
  std::string read_error_;  ///< Names file and variable already; empty: all could be read.
};

}  // namespace

CfSource SourceOf(const NetcdfFile& file) {
  return {.name = file.name(),
          .header = file.header(),
          .read = [&file](const NetcdfVariable& variable) { return file.Read(variable); }};
}

Result<CfField> ReadCfField(const CfSource& source, std::string_view variable,
                            CfQuantity quantity) {
  const NetcdfVariable* found = source.header.Find(variable);
  if (found == nullptr) {
    std::string names;
    for (const NetcdfVariable& each : source.header.variables) {
      if (each.dimensions.size() >= 2 && names.size() < 200) {
        names += (names.empty() ? "" : ", ") + PrintableName(each.name);
      }
    }
    return Error{fmt::format("{}: there is no variable '{}' in it; name one of these: {}",
                             source.name, PrintableName(variable), names)};
  }
  return CfReader(source, *found, quantity).Read();
}

}  // namespace shoal
