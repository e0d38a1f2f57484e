#include "lib/mission/file/current_directions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

/// The directions of a grid's axes at one of its points, as unit vectors; NaN: not known.
struct GridAxes {
  Eigen::Vector2d x = {1, 0};
  Eigen::Vector2d y = {0, 1};
};

GridAxes AxesOnMap(const CfField& field, size_t column, size_t row) {
  const double bearing_rad = field.projection->NorthBearing_rad({field.x[column], field.y[row]});
  return {.x = ToEastNorth({1, 0}, bearing_rad), .y = ToEastNorth({0, 1}, bearing_rad)};
}

/// Up, East and North at a point of the Earth; x toward the Greenwich meridian, z toward the pole.
struct EarthAxes {
  Eigen::Vector3d up;
  Eigen::Vector3d east;
  Eigen::Vector3d north;
};

EarthAxes AxesOfEarth(const GeoPoint& point) {
  const auto [sin_lat, cos_lat] = SinCos(DegToRad(point.lat_deg));
  const auto [sin_lon, cos_lon] = SinCos(DegToRad(point.lon_deg));
  return {.up = {cos_lat * cos_lon, cos_lat * sin_lon, sin_lat},
          .east = {-sin_lon, cos_lon, 0},
          .north = {-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat}};
}

double CrossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Which way the rows and columns of a curvilinear grid run at its points.
class MeshDirections {
 public:
  explicit MeshDirections(const CfField& field) : field_(field) {
    // A grid has one hand, and of some thousand points most show it.
    const size_t num_points = field.x.size() * field.y.size();
    const size_t step = num_points / 4096 + 1;
    int64_t sum = 0;
    int64_t along_meridians = 0;
    for (size_t point = 0; point < num_points; point += step) {
      const Ways x = WaysAlongX(point % field.x.size(), point / field.x.size());
      const Ways y = WaysAlongY(point % field.x.size(), point / field.x.size());
      if (x.count == 0 || y.count == 0) continue;
      const double cross = CrossOf(x.ways[0], y.ways[0]);
      sum += cross > 0 ? 1 : cross < 0 ? -1 : 0;
      along_meridians += std::abs(x.ways[0].y()) > std::abs(x.ways[0].x()) ? 1 : -1;
    }
    hand_ = sum < 0 ? -1 : 1;
    is_along_meridians_ = along_meridians > 0;
  }

  /// The y of its points is to the right of their x, as it is on no map.
  bool is_mirrored() const { return hand_ < 0; }
  /// x runs rather North or South than East or West.
  bool is_along_meridians() const { return is_along_meridians_; }

  /// Returns the directions of x and y, East and North of length 1. Where the points beside one are
  /// known only on one side the way to these counts; where none is, the other axis.
  GridAxes At(size_t column, size_t row) const {
    const Ways x = WaysAlongX(column, row);
    const Ways y = WaysAlongY(column, row);
    for (size_t i = 0; i < x.count; ++i) {
      for (size_t j = 0; j < y.count; ++j) {
        // At a fold, where the points on both sides are the same ones, one of the ways fits.
        if (CrossOf(x.ways[i], y.ways[j]) * hand_ > 0) return {.x = x.ways[i], .y = y.ways[j]};
      }
    }
    if (x.count > 0) {
      return {.x = x.ways[0], .y = hand_ * Eigen::Vector2d(-x.ways[0].y(), x.ways[0].x())};
    }
    if (y.count > 0) {
      return {.x = hand_ * Eigen::Vector2d(y.ways[0].y(), -y.ways[0].x()), .y = y.ways[0]};
    }
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return {.x = {kNan, kNan}, .y = {kNan, kNan}};
  }

 private:
  /// What may be the direction of an axis at a point, the likeliest first.
  struct Ways {
    std::array<Eigen::Vector2d, 2> ways;
    size_t count = 0;

    void Add(const Eigen::Vector2d& way) { ways[count++] = way.normalized(); }
  };

  GeoPoint PointAt(size_t point) const {
    return {.lat_deg = field_.lats_deg[point], .lon_deg = field_.lons_deg[point]};
  }

  Ways WaysAlongX(size_t column, size_t row) const {
    const size_t here = row * field_.x.size() + column;
    return WaysAlong(here, column == 0 ? here : here - 1,
                     column + 1 == field_.x.size() ? here : here + 1);
  }
  Ways WaysAlongY(size_t column, size_t row) const {
    const size_t here = row * field_.x.size() + column;
    return WaysAlong(here, row == 0 ? here : here - field_.x.size(),
                     row + 1 == field_.y.size() ? here : here + field_.x.size());
  }

  Ways WaysAlong(size_t here, size_t before, size_t after) const {
    const EarthAxes earth = AxesOfEarth(PointAt(here));
    const auto way_to = [&](size_t other) {
      const Eigen::Vector3d way = AxesOfEarth(PointAt(other)).up - earth.up;
      return Eigen::Vector2d(way.dot(earth.east), way.dot(earth.north));
    };
    const Eigen::Vector2d first = -way_to(before);
    const Eigen::Vector2d second = way_to(after);
    const auto is_way = [](const Eigen::Vector2d& way) { return way.norm() > kSamePlace_rad; };
    Ways found;
    if ((first + second).norm() > 0.1 * std::max(first.norm(), second.norm()) &&
        is_way(first + second)) {
      found.Add(first + second);  // False for NaN.
      return found;
    }
    for (const Eigen::Vector2d& way : {first, second}) {
      if (is_way(way)) found.Add(way);
    }
    return found;
  }

  static constexpr double kSamePlace_rad = 1e-9;  // 6 mm.

  const CfField& field_;
  double hand_ = 1;
  bool is_along_meridians_ = false;
};

/// Turns velocities at all times and depths at each point, by `turn(point, vector)`.
template <class Turn>
void TurnEach(CfField& east, CfField& north, const Turn& turn) {
  const size_t num_points = east.x.size() * east.y.size();
  for (size_t i = 0; i < east.values.size(); ++i) {
    const Eigen::Vector2d flow =
        turn(i % num_points, Eigen::Vector2d(east.values[i], north.values[i]));
    east.values[i] = static_cast<float>(flow.x());
    north.values[i] = static_cast<float>(flow.y());
  }
}

/// Turns velocities along the axes of a grid to East and North.
void TurnToEast(Components& components) {
  const CfField& field = components.east;
  std::vector<GridAxes> axes;
  axes.reserve(field.x.size() * field.y.size());
  std::optional<MeshDirections> mesh;
  if (!field.projection) mesh.emplace(field);
  for (size_t row = 0; row < field.y.size(); ++row) {
    for (size_t column = 0; column < field.x.size(); ++column) {
      axes.push_back(mesh ? mesh->At(column, row) : AxesOnMap(field, column, row));
    }
  }
  if (mesh && !field.is_x_known && mesh->is_along_meridians()) {
    components.notes.warnings.push_back(fmt::format(
        "variables '{}' and '{}' run along the dimensions of a grid, of which neither axes nor "
        "names "
        "show which is x: the last is taken, which runs along the meridians; give these dimensions "
        "axes with the standard_name projection_x_coordinate and projection_y_coordinate",
        components.east.variable, components.north.variable));
  }
  if (mesh && mesh->is_mirrored()) {
    components.notes.warnings.push_back(fmt::format(
        "variables '{}' and '{}' run along the dimensions of a grid on which y lies to the right "
        "of "
        "x, as on no map: if the current comes out mirrored, give these dimensions axes with the "
        "standard_name projection_x_coordinate and projection_y_coordinate, or the file components "
        "eastward and northward",
        components.east.variable, components.north.variable));
  }
  TurnEach(components.east, components.north, [&](size_t point, const Eigen::Vector2d& flow) {
    return axes[point].x * flow.x() + axes[point].y * flow.y();
  });
}

}  // namespace

void TurnToPlane(Components& components, const GeoPoint& origin) {
  const CfField& field = components.east;
  if (!field.projection && !field.is_curvilinear()) return;
  const LocalFrame frame(origin);
  const size_t columns = field.x.size();
  std::vector<GeoPoint> points;
  points.reserve(columns * field.y.size());
  for (size_t i = 0; i < columns * field.y.size(); ++i) {
    points.push_back(field.projection
                         ? field.projection->Reverse({field.x[i % columns], field.y[i / columns]})
                         : GeoPoint{.lat_deg = field.lats_deg[i], .lon_deg = field.lons_deg[i]});
  }
  TurnEach(components.east, components.north, [&](size_t point, const Eigen::Vector2d& flow) {
    return frame.TurnToPlane(flow, points[point]);
  });
}

std::string UseDirections(Components& components, CfDirection east, CfDirection north) {
  const std::string both =
      fmt::format("variables '{}' and '{}'", components.east.variable, components.north.variable);
  if (east == CfDirection::kNorth || east == CfDirection::kY || north == CfDirection::kEast ||
      north == CfDirection::kX) {
    components.notes.warnings.push_back(
        both +
        " are named as East and North, and their standard_name has them the other way round: "
        "is grid_east exchanged with grid_north?");
    return "";
  }
  const bool is_along_grid = east == CfDirection::kX || north == CfDirection::kY;
  const bool is_along_earth = east == CfDirection::kEast || north == CfDirection::kNorth;
  if (is_along_grid && is_along_earth) {
    return both + " are along different axes by their standard_name; name two that belong together";
  }
  const bool has_turned_axes =
      components.east.projection.has_value() || components.east.is_curvilinear();
  if (is_along_earth) return "";
  if (has_turned_axes) {
    if (!is_along_grid) {
      components.notes.warnings.push_back(
          both +
          " have no standard_name, and the axes of their grid do not point East and North: "
          "they are taken to be along the axes; if they are not, give them the standard_name "
          "eastward_sea_water_velocity and northward_sea_water_velocity");
    }
    TurnToEast(components);
  } else if (is_along_grid && !components.east.is_geographic) {
    components.notes.warnings.push_back(
        both +
        " are along the axes of a grid that no grid_mapping places: these are taken to point "
        "East and North");
  }
  return "";
}

}  // namespace shoal
