#include "lib/base/geodesy/map_projection.h"

#include <GeographicLib/Math.hpp>
#include <cmath>
#include <exception>
#include <numbers>
#include <utility>

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

namespace {

constexpr double kRadian = std::numbers::pi / 180;

/// Turns a point about the sphere so that `pole` comes to the North; its longitude then counts from
/// the meridian on which the old pole lies. Undoes itself with the poles exchanged.
GeoPoint AboutPole(const GeoPoint& point, const GeoPoint& pole) {
  const double lat = point.lat_deg * kRadian;
  const double lon = (point.lon_deg - pole.lon_deg) * kRadian;
  const double pole_lat = pole.lat_deg * kRadian;
  const double height = Sin(lat) * Sin(pole_lat) + Cos(lat) * Cos(pole_lat) * Cos(lon);
  const double east = -Cos(lat) * Sin(lon);
  const double toward = Sin(lat) * Cos(pole_lat) - Cos(lat) * Sin(pole_lat) * Cos(lon);
  return {.lat_deg = Atan2(height, Hypot(east, toward)) / kRadian,
          .lon_deg = Atan2(east, toward) / kRadian};
}

bool IsProjection(const MapProjectionParams& params) {
  const bool is_polar = params.kind == MapProjectionKind::kPolarStereographic;
  const bool is_earth = params.radius_m > 1e6 && params.radius_m < 1e7 && params.flattening >= 0 &&
                        params.flattening < 0.1;
  const bool has_true_scale =
      !params.true_scale_lat_deg || is_polar || std::abs(*params.true_scale_lat_deg) < 90;
  return is_earth && has_true_scale && std::abs(params.central_lon_deg) <= 540 &&
         (is_polar ? std::abs(params.origin_lat_deg) == 90
                   : std::abs(params.origin_lat_deg) <= 90) &&
         std::abs(params.pole_grid_lon_deg) <= 540 && params.scale > 0.01 && params.scale < 100 &&
         params.false_origin_m.cwiseAbs().maxCoeff() <= 1e9;
}

}  // namespace

MapProjection::Plane MapProjection::PlaneOf(const MapProjectionParams& params) {
  const double radius_m = params.radius_m;
  const double flattening = params.flattening;
  switch (params.kind) {
    case MapProjectionKind::kPolarStereographic: {
      GeographicLib::PolarStereographic plane(radius_m, flattening, params.scale);
      if (params.true_scale_lat_deg) plane.SetScale(std::abs(*params.true_scale_lat_deg), 1);
      return plane;
    }
    case MapProjectionKind::kLambertConformalConic:
      return GeographicLib::LambertConformalConic(radius_m, flattening, params.first_parallel_deg,
                                                  params.second_parallel_deg, params.scale);
    case MapProjectionKind::kMercator: {
      // A cone with parallels on both sides of the equator is a cylinder.
      if (const auto& lat_deg = params.true_scale_lat_deg) {
        return GeographicLib::LambertConformalConic(radius_m, flattening, *lat_deg, -*lat_deg, 1);
      }
      return GeographicLib::LambertConformalConic(radius_m, flattening, 0, params.scale);
    }
    case MapProjectionKind::kTransverseMercator:
      return GeographicLib::TransverseMercator(radius_m, flattening, params.scale);
    case MapProjectionKind::kRotatedPole:
      break;
  }
  return std::monostate{};
}

std::optional<MapProjection> MapProjection::Make(const MapProjectionParams& params) {
  if (!IsProjection(params)) return std::nullopt;
  try {
    MapProjection map(params, PlaneOf(params));
    if (!map.moved_m_.allFinite()) return std::nullopt;
    return map;
  } catch (const std::exception&) {  // GeographicErr: parallels at a pole, and the like.
    return std::nullopt;
  }
}

MapProjection::MapProjection(const MapProjectionParams& params, Plane plane)
    : params_(params), plane_(plane) {
  if (params.kind == MapProjectionKind::kRotatedPole) return;
  moved_m_ = params.false_origin_m;
  if (params.kind == MapProjectionKind::kPolarStereographic) return;
  moved_m_ -= ForwardUnmoved({.lat_deg = params.origin_lat_deg, .lon_deg = params.central_lon_deg});
}

Eigen::Vector2d MapProjection::ForwardUnmoved(const GeoPoint& point) const {
  Eigen::Vector2d place(0, 0);
  if (const auto* polar = std::get_if<GeographicLib::PolarStereographic>(&plane_)) {
    polar->Forward(params_.origin_lat_deg > 0, point.lat_deg,
                   point.lon_deg - params_.central_lon_deg, place.x(), place.y());
  } else if (const auto* conic = std::get_if<GeographicLib::LambertConformalConic>(&plane_)) {
    conic->Forward(params_.central_lon_deg, point.lat_deg, point.lon_deg, place.x(), place.y());
  } else if (const auto* mercator = std::get_if<GeographicLib::TransverseMercator>(&plane_)) {
    mercator->Forward(params_.central_lon_deg, point.lat_deg, point.lon_deg, place.x(), place.y());
  } else {
    const GeoPoint turned =
        AboutPole(point, {.lat_deg = params_.origin_lat_deg, .lon_deg = params_.central_lon_deg});
    place = {GeographicLib::Math::AngNormalize(turned.lon_deg + params_.pole_grid_lon_deg),
             turned.lat_deg};
  }
  return place;
}

Eigen::Vector2d MapProjection::Forward(const GeoPoint& point) const {
  return ForwardUnmoved(point) + moved_m_;
}

MapProjection::Place MapProjection::ReverseOf(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d from = place - moved_m_;
  Place found;
  GeoPoint& point = found.point;
  double scale = 0;
  if (const auto* polar = std::get_if<GeographicLib::PolarStereographic>(&plane_)) {
    polar->Reverse(params_.origin_lat_deg > 0, from.x(), from.y(), point.lat_deg, point.lon_deg,
                   found.bearing_deg, scale);
    point.lon_deg = GeographicLib::Math::AngNormalize(point.lon_deg + params_.central_lon_deg);
  } else if (const auto* conic = std::get_if<GeographicLib::LambertConformalConic>(&plane_)) {
    conic->Reverse(params_.central_lon_deg, from.x(), from.y(), point.lat_deg, point.lon_deg,
                   found.bearing_deg, scale);
  } else if (const auto* mercator = std::get_if<GeographicLib::TransverseMercator>(&plane_)) {
    mercator->Reverse(params_.central_lon_deg, from.x(), from.y(), point.lat_deg, point.lon_deg,
                      found.bearing_deg, scale);
  } else {
    point = AboutPole({.lat_deg = from.y(), .lon_deg = from.x() - params_.pole_grid_lon_deg},
                      {.lat_deg = params_.origin_lat_deg, .lon_deg = 0});
    point.lon_deg = GeographicLib::Math::AngNormalize(point.lon_deg + params_.central_lon_deg);
    // The azimuth of the grid's pole from the point.
    const double lat = point.lat_deg * kRadian;
    const double pole_lat = params_.origin_lat_deg * kRadian;
    const double east = (params_.central_lon_deg - point.lon_deg) * kRadian;
    found.bearing_deg = Atan2(Sin(east) * Cos(pole_lat),
                              Cos(lat) * Sin(pole_lat) - Sin(lat) * Cos(pole_lat) * Cos(east)) /
                        kRadian;
  }
  return found;
}

GeoPoint MapProjection::Reverse(const Eigen::Vector2d& place) const {
  return ReverseOf(place).point;
}

double MapProjection::NorthBearing_rad(const Eigen::Vector2d& place) const {
  return ReverseOf(place).bearing_deg * kRadian;
}

Eigen::Vector2d ToEastNorth(const Eigen::Vector2d& along, double north_bearing_rad) {
  const auto [sine, cosine] = SinCos(north_bearing_rad);
  return {cosine * along.x() + sine * along.y(), cosine * along.y() - sine * along.x()};
}

}  // namespace shoal
