// Between latitude, longitude and the plane coordinates of a map, and which way the map's axes
// point.
//
//   const auto map = MapProjection::Make({.kind = MapProjectionKind::kPolarStereographic,
//                                         .origin_lat_deg = 90,
//                                         .central_lon_deg = 58,
//                                         .true_scale_lat_deg = 60});
//   Eigen::Vector2d place = map->Forward({.lat_deg = 74.66, .lon_deg = 19.75});
//   double bearing_rad = map->NorthBearing_rad(place);  // of the map's y axis
//
// Conformal projections of the ellipsoid by GeographicLib (Karney), and the rotated pole of weather
// models, on the sphere ("CF Conventions" 1.11, appendix F).
#pragma once

#include <Eigen/Core>
#include <GeographicLib/Constants.hpp>
#include <GeographicLib/LambertConformalConic.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <optional>
#include <variant>

#include "lib/base/geodesy/local_frame.h"

namespace shoal {

enum class MapProjectionKind {
  kPolarStereographic,
  kLambertConformalConic,
  kMercator,
  kTransverseMercator,
  kRotatedPole,  ///< Coordinates are degrees: longitude and latitude about another pole.
};

struct MapProjectionParams {
  MapProjectionKind kind = MapProjectionKind::kMercator;
  double radius_m = GeographicLib::Constants::WGS84_a();  ///< At the equator; > 0.
  double flattening = GeographicLib::Constants::WGS84_f();
  /// Where y is 0 before false_origin_m; of kPolarStereographic +90 or -90; of kRotatedPole the
  /// latitude of the grid's North pole.
  double origin_lat_deg = 0;
  double central_lon_deg = 0;  ///< Of kRotatedPole the longitude of the grid's North pole.
  /// Parallels of kLambertConformalConic; two equal ones are one.
  double first_parallel_deg = 0;
  double second_parallel_deg = 0;
  /// Where kPolarStereographic and kMercator have the scale 1; else `scale` counts.
  std::optional<double> true_scale_lat_deg = {};
  double scale = 1;              ///< At the origin; > 0.
  double pole_grid_lon_deg = 0;  ///< Of kRotatedPole: the North pole's longitude in the grid.
  Eigen::Vector2d false_origin_m = Eigen::Vector2d::Zero();  ///< Added to x and y.
};

class MapProjection {
 public:
  /// Nothing where no projection has these numbers.
  [[nodiscard]] static std::optional<MapProjection> Make(const MapProjectionParams& params);

  /// Returns x, y in metres, of kRotatedPole in degrees, x in (-180, 180]; NaN where the point is.
  [[nodiscard]] Eigen::Vector2d Forward(const GeoPoint& point) const;
  [[nodiscard]] GeoPoint Reverse(const Eigen::Vector2d& place) const;
  /// Returns the bearing of the y axis at a place, clockwise from North. The x axis is to its
  /// right.
  [[nodiscard]] double NorthBearing_rad(const Eigen::Vector2d& place) const;

  bool is_rotated_pole() const { return params_.kind == MapProjectionKind::kRotatedPole; }

 private:
  using Plane =
      std::variant<std::monostate, GeographicLib::PolarStereographic,
                   GeographicLib::LambertConformalConic, GeographicLib::TransverseMercator>;
  struct Place {
    GeoPoint point;
    double bearing_deg = 0;
  };

  MapProjection(const MapProjectionParams& params, Plane plane);
  static Plane PlaneOf(const MapProjectionParams& params);
  Eigen::Vector2d ForwardUnmoved(const GeoPoint& point) const;
  Place ReverseOf(const Eigen::Vector2d& place) const;

  MapProjectionParams params_;
  Plane plane_;                                        ///< std::monostate: a rotated pole.
  Eigen::Vector2d moved_m_ = Eigen::Vector2d::Zero();  ///< Added to what the plane has.
};

/// Returns the components of a vector along East and North, whose components along the axes of a
/// map are `along`, where the map's y axis has this bearing.
[[nodiscard]] Eigen::Vector2d ToEastNorth(const Eigen::Vector2d& along, double north_bearing_rad);

}  // namespace shoal
