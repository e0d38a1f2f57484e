// Between the mission's plane (x East, y North, metres from the origin) and latitude, longitude.
//
//   LocalFrame frame({.lat_deg = 43.8253, .lon_deg = -70.3304});
//   GeoPoint where = frame.ToGeo({120, -35});
//   std::optional<Eigen::Vector2d> again = frame.ToLocal(where);
//
// The plane touches the WGS84 ellipsoid at the origin. A point of the sea surface has the x, y of
// the point of the plane above it (along the ellipsoid's normal), so ToGeo and ToLocal undo each
// other to well under a millimetre. Distances in the plane are longer than those on the ellipsoid
// by about (r / R)^2 / 3: 8 mm in 10 km, 8 m in 100 km. Its reach covers the corners of what
// mission files allow, 1000 km East and North.
#pragma once

#include <Eigen/Core>
#include <GeographicLib/LocalCartesian.hpp>
#include <optional>

namespace shoal {

/// WGS84.
struct GeoPoint {
  double lat_deg = 0;  ///< [-90, 90].
  double lon_deg = 0;  ///< [-180, 180].
};

class LocalFrame {
 public:
  /// Beyond this distance from the origin a plane is not a map.
  static constexpr double kReach_m = 1.5e6;

  /// @pre origin is finite and in range.
  explicit LocalFrame(const GeoPoint& origin);

  /// Returns the point of the ellipsoid below `position_m`; NaN for both where the position is not
  /// finite or out of reach.
  [[nodiscard]] GeoPoint ToGeo(const Eigen::Vector2d& position_m) const;

  /// Returns x East, y North; nothing where the point is not finite, no point of the Earth or out
  /// of reach.
  [[nodiscard]] std::optional<Eigen::Vector2d> ToLocal(const GeoPoint& point) const;

  /// Returns as x, y what runs `along` East and North at a point. The plane's axes point there only
  /// at the origin and, along its meridian, toward North: elsewhere meridians converge. Lengths
  /// stay.
  [[nodiscard]] Eigen::Vector2d TurnToPlane(const Eigen::Vector2d& along,
                                            const GeoPoint& point) const;

 private:
  GeoPoint origin_;
  GeographicLib::LocalCartesian plane_;
};

}  // namespace shoal
