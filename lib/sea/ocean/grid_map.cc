#include "lib/sea/ocean/grid_map.h"

#include <cmath>
#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

namespace {

/// Returns the same meridian as a number from `first` on; beyond `last` that of the nearer end.
double UnwrapLongitude(double lon_deg, double first, double last) {
  const double unwrapped = lon_deg + 360 * std::ceil((first - lon_deg) / 360);
  const bool is_nearer_to_first = unwrapped > last && first + 360 - unwrapped < unwrapped - last;
  return is_nearer_to_first ? unwrapped - 360 : unwrapped;
}

}  // namespace

GridMap::GridMap(const GridFrame& frame)
    : GridMap(GridAxis::Even(frame.south_west_m.x(), frame.cell_m.x(), frame.columns),
              GridAxis::Even(frame.south_west_m.y(), frame.cell_m.y(), frame.rows)) {}

GridMap::GridMap(GridAxis x_m, GridAxis y_m) : x_(std::move(x_m)), y_(std::move(y_m)) {}

GridMap::GridMap(const GeoPoint& origin, GridAxis lon_deg, GridAxis lat_deg)
    : x_(std::move(lon_deg)), y_(std::move(lat_deg)), earth_(origin) {}

GridMap::GridMap(const GeoPoint& origin, const MapProjection& projection, GridAxis x, GridAxis y)
    : x_(std::move(x)), y_(std::move(y)), earth_(origin), projection_(projection) {}

GridMap::GridMap(GridMesh mesh)
    : x_(GridAxis::Even(0, 1, mesh.columns())),
      y_(GridAxis::Even(0, 1, mesh.rows())),
      mesh_(std::make_shared<const GridMesh>(std::move(mesh))) {}

GridCell GridMap::Locate(const Eigen::Vector2d& position_m) const {
  if (mesh_) return mesh_->Locate(position_m);
  if (!earth_) return {.x = x_.Locate(position_m.x()), .y = y_.Locate(position_m.y())};
  const GeoPoint point = earth_->ToGeo(position_m);
  if (!projection_) {
    return {.x = x_.Locate(UnwrapLongitude(point.lon_deg, x_.first(), x_.last())),
            .y = y_.Locate(point.lat_deg)};
  }
  Eigen::Vector2d place = projection_->Forward(point);
  if (projection_->is_rotated_pole()) {
    place.x() = UnwrapLongitude(place.x(), x_.first(), x_.last());
  }
  return {.x = x_.Locate(place.x()), .y = y_.Locate(place.y())};
}

Eigen::Vector2d GridMap::TurnToPlane(const Eigen::Vector2d& along,
                                     const Eigen::Vector2d& position_m) const {
  if (!earth_ || projection_) return along;
  const GeoPoint point = earth_->ToGeo(position_m);
  return std::isfinite(point.lat_deg) ? earth_->TurnToPlane(along, point) : along;
}

double GridMap::Interpolate(std::span<const float> values, const GridCell& cell) const {
  SHOAL_CHECK(values.size() == num_points(), "a layer has columns * rows values");
  const auto point = [&](int column, int row) -> double {
    return values[static_cast<size_t>(row) * static_cast<size_t>(columns()) +
                  static_cast<size_t>(column)];
  };
  return std::lerp(std::lerp(point(cell.x.before, cell.y.before),
                             point(cell.x.after, cell.y.before), cell.x.share),
                   std::lerp(point(cell.x.before, cell.y.after), point(cell.x.after, cell.y.after),
                             cell.x.share),
                   cell.y.share);
}

}  // namespace shoal
