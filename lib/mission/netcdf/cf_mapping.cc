#include "lib/mission/netcdf/cf_mapping.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/netcdf/cf_words.h"

namespace shoal {

namespace {

using MappingRow = std::pair<std::string_view, MapProjectionKind>;
constexpr std::array<MappingRow, 5> kMappings = {
    {{"polar_stereographic", MapProjectionKind::kPolarStereographic},
     {"lambert_conformal_conic", MapProjectionKind::kLambertConformalConic},
     {"mercator", MapProjectionKind::kMercator},
     {"transverse_mercator", MapProjectionKind::kTransverseMercator},
     {"rotated_latitude_longitude", MapProjectionKind::kRotatedPole}}};

/// Reads the numbers of one mapping and notes the first that it needs and that is not there.
class MappingNumbers {
 public:
  explicit MappingNumbers(const NetcdfVariable& mapping) : mapping_(mapping) {}

  std::optional<double> Find(std::string_view name, size_t index = 0) const {
    const std::vector<double>& numbers = mapping_.NumbersOf(name);
    return index < numbers.size() ? std::optional(numbers[index]) : std::nullopt;
  }
  double Get(std::string_view name, double otherwise) const {
    return Find(name).value_or(otherwise);
  }
  /// Of two names, the first that is there.
  double Need(std::string_view name, std::string_view other = "") {
    std::optional<double> number = Find(name);
    if (!number && !other.empty()) number = Find(other);
    if (!number && missing_.empty()) missing_ = name;
    return number.value_or(0);
  }
  const std::string& missing() const { return missing_; }

 private:
  const NetcdfVariable& mapping_;
  std::string missing_;
};

constexpr double kSphere_m = 6'371'000;

/// Returns whether a text of the mapping names WGS84, or GRS80, which is the same to 0.1 mm.
bool NamesWgs84(const NetcdfVariable& mapping) {
  for (const char* key : {"reference_ellipsoid_name", "horizontal_datum_name",
                          "geographic_crs_name", "crs_wkt", "spatial_ref"}) {
    const std::string text = LowerCase(mapping.TextOf(key));
    for (const char* name : {"wgs 84", "wgs84", "wgs_1984", "grs 80", "grs80", "grs 1980"}) {
      if (text.find(name) != std::string::npos) return true;
    }
  }
  return false;
}

/// Sets the figure of the Earth.
void SetEarth(const NetcdfVariable& mapping, const MappingNumbers& numbers,
              MapProjectionParams& params) {
  const auto radius_m = numbers.Find("earth_radius");
  const auto major_m = numbers.Find("semi_major_axis");
  const auto minor_m = numbers.Find("semi_minor_axis");
  const auto inverse = numbers.Find("inverse_flattening");
  if (!major_m && !radius_m) {
    if (NamesWgs84(mapping)) return;
    params.radius_m = kSphere_m;
    params.flattening = 0;
    return;
  }
  params.radius_m = major_m ? *major_m : *radius_m;
  params.flattening = 0;
  if (inverse) {
    params.flattening = *inverse == 0 ? 0 : 1 / *inverse;  // 0: a sphere, as many files have it.
  } else if (major_m && minor_m) {
    params.flattening = 1 - *minor_m / *major_m;
  }
}

void SetPlane(MappingNumbers& numbers, MapProjectionParams& params) {
  params.scale = numbers.Get("scale_factor_at_projection_origin", 1);
  switch (params.kind) {
    case MapProjectionKind::kPolarStereographic:
      params.origin_lat_deg = numbers.Need("latitude_of_projection_origin");
      params.central_lon_deg =
          numbers.Need("straight_vertical_longitude_from_pole", "longitude_of_projection_origin");
      params.true_scale_lat_deg = numbers.Find("standard_parallel");
      return;
    case MapProjectionKind::kLambertConformalConic: {
      params.origin_lat_deg = numbers.Need("latitude_of_projection_origin");
      params.central_lon_deg =
          numbers.Need("longitude_of_central_meridian", "longitude_of_projection_origin");
      params.first_parallel_deg = numbers.Need("standard_parallel");
      const auto second_deg = numbers.Find("standard_parallel", 1);
      params.second_parallel_deg = second_deg.value_or(params.first_parallel_deg);
      return;
    }
    case MapProjectionKind::kMercator:
      params.central_lon_deg =
          numbers.Need("longitude_of_projection_origin", "longitude_of_central_meridian");
      params.true_scale_lat_deg = numbers.Find("standard_parallel");
      return;
    case MapProjectionKind::kTransverseMercator:
      params.origin_lat_deg = numbers.Get("latitude_of_projection_origin", 0);
      params.central_lon_deg =
          numbers.Need("longitude_of_central_meridian", "longitude_of_projection_origin");
      params.scale = numbers.Get("scale_factor_at_central_meridian", params.scale);
      return;
    case MapProjectionKind::kRotatedPole:
      params.origin_lat_deg = numbers.Need("grid_north_pole_latitude");
      params.central_lon_deg = numbers.Need("grid_north_pole_longitude");
      params.pole_grid_lon_deg = numbers.Get("north_pole_grid_longitude", 0);
      return;
  }
}

}  // namespace

Result<const NetcdfVariable*> FindMapping(const NetcdfHeader& header,
                                          const NetcdfVariable& variable, std::string_view x_axis) {
  // "crs", or "projected: x y geographic: lat lon".
  std::string_view found;
  std::string_view last;
  for (const std::string_view word : WordsOf(variable.TextOf("grid_mapping"))) {
    if (word.ends_with(':')) {
      last = word.substr(0, word.size() - 1);
      if (found.empty()) found = last;
    } else if (last.empty()) {
      found = word;
    } else if (word == x_axis) {
      found = last;
    }
  }
  if (found.empty()) return nullptr;
  const NetcdfVariable* mapping = header.Find(found);
  if (mapping == nullptr) {
    return Error{
        fmt::format("has the grid_mapping '{}', and the file has no such variable: where "
                    "the grid lies is not known; copy that variable into it too",
                    PrintableName(found))};
  }
  return mapping;
}

Result<MapProjection> ProjectionOf(const NetcdfVariable& mapping, double metres) {
  const std::string name = LowerCase(Trimmed(mapping.TextOf("grid_mapping_name")));
  const auto* row = std::ranges::find(kMappings, name, &MappingRow::first);
  if (row == kMappings.end()) {
    return Error{fmt::format(
        "is on a map whose grid_mapping '{}' is '{}'; those read are polar_stereographic, "
        "lambert_conformal_conic, mercator, transverse_mercator and rotated_latitude_longitude: "
        "interpolate it to latitudes and longitudes, for example with gdalwarp -t_srs EPSG:4326 or "
        "cdo remapbil",
        PrintableName(mapping.name), PrintableName(name))};
  }
  MapProjectionParams params = {.kind = row->second};
  MappingNumbers numbers(mapping);
  SetEarth(mapping, numbers, params);
  SetPlane(numbers, params);
  const Result<double> meridian_deg = PrimeMeridianOf(mapping);
  if (!meridian_deg.ok()) return Error{meridian_deg.error()};
  params.central_lon_deg += *meridian_deg;
  params.false_origin_m =
      metres * Eigen::Vector2d(numbers.Get("false_easting", 0), numbers.Get("false_northing", 0));
  if (!numbers.missing().empty()) {
    return Error{fmt::format("has the grid_mapping '{}', {}, without the number '{}'; add it",
                             PrintableName(mapping.name), name, numbers.missing())};
  }
  std::optional<MapProjection> projection = MapProjection::Make(params);
  if (!projection) {
    return Error{
        fmt::format("has the grid_mapping '{}', {}, with numbers that no such map has; "
                    "correct them",
                    PrintableName(mapping.name), name)};
  }
  return std::move(*projection);
}

Result<double> PrimeMeridianOf(const NetcdfVariable& mapping) {
  const std::string name = LowerCase(mapping.TextOf("prime_meridian_name"));
  const std::vector<double>& numbers = mapping.NumbersOf("longitude_of_prime_meridian");
  if (numbers.empty() && !name.empty() && name.find("greenwich") == std::string::npos) {
    return Error{fmt::format(
        "has the grid_mapping '{}', whose longitudes count from '{}', without the number "
        "'longitude_of_prime_meridian'; add it",
        PrintableName(mapping.name), PrintableName(name))};
  }
  if (!numbers.empty() && !(std::abs(numbers[0]) <= 180)) {
    return Error{
        fmt::format("has the grid_mapping '{}' with a longitude_of_prime_meridian beyond "
                    "180 degrees; correct it",
                    PrintableName(mapping.name))};
  }
  return numbers.empty() ? 0 : numbers[0];
}

bool HasFigure(const NetcdfVariable& mapping) {
  return !mapping.NumbersOf("earth_radius").empty() ||
         !mapping.NumbersOf("semi_major_axis").empty() || NamesWgs84(mapping);
}

}  // namespace shoal
