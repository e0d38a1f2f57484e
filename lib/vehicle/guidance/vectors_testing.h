// For tests of guidance: random vectors and scenes, sensible ones and extreme ones.
#pragma once

#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "lib/vehicle/guidance/surroundings.h"

namespace shoal {

inline double DrawBetween(double low, double high) {
  return low + (high - low) * (*rc::gen::inRange(0, 1'000'001) / 1e6);
}

inline Eigen::Vector3d VectorWithin(double bound) {
  return {DrawBetween(-bound, bound), DrawBetween(-bound, bound), DrawBetween(-bound, bound)};
}

/// Returns any finite number, extremes often.
inline double AnyFinite() {
  const double scale =
      *rc::gen::element(0.0, 1.0, 100.0, 1e9, 1e155, 1e300, std::numeric_limits<double>::max(),
                        std::numeric_limits<double>::denorm_min());
  return *rc::gen::element(-1.0, 1.0, 0.5, -1e-3) * scale;
}

inline Eigen::Vector3d AnyFiniteVector() { return {AnyFinite(), AnyFinite(), AnyFinite()}; }

inline Eigen::Matrix3d AboutZ(double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// Owns what Surroundings only point to.
struct TargetScene {
  Neighbour own{.id = 1};
  Neighbour target{.id = 0};
  std::vector<Neighbour> group = {};
  std::vector<SonarEcho> sonar = {};
  double seabed_z_m = 200;

  Surroundings Seen() const {
    return {.own = own, .target = target, .group = group, .sonar = sonar, .seabed_z_m = seabed_z_m};
  }

  TargetScene Turned(double angle_rad) const {
    const Eigen::Matrix3d turn = AboutZ(angle_rad);
    const auto turned = [&](Neighbour neighbour) {
      neighbour.position_m = turn * neighbour.position_m;
      neighbour.velocity_mps = turn * neighbour.velocity_mps;
      return neighbour;
    };
    TargetScene scene = *this;
    scene.own = turned(own);
    scene.target = turned(target);
    for (Neighbour& member : scene.group) member = turned(member);
    for (SonarEcho& echo : scene.sonar) echo.direction = turn * echo.direction;
    return scene;
  }
};

/// Returns a scene of a few hundred metres.
inline TargetScene AnyTargetScene() {
  TargetScene scene;
  scene.own.position_m = VectorWithin(50) + Eigen::Vector3d(0, 0, 50);
  scene.own.velocity_mps = VectorWithin(2);
  scene.target.position_m = VectorWithin(150) + Eigen::Vector3d(0, 0, 50);
  scene.target.velocity_mps = VectorWithin(2);
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
    scene.group.push_back({.id = 1 + i,
                           .position_m = VectorWithin(60) + Eigen::Vector3d(0, 0, 50),
                           .velocity_mps = VectorWithin(2)});
  }
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(1, DrawBetween(-0.4, 0.4), DrawBetween(-0.2, 0.2)).normalized();
    scene.sonar.push_back({.direction = direction, .range_m = DrawBetween(0, 60)});
  }
  return scene;
}

/// Returns a scene of extremes; vehicles coincide often.
inline TargetScene AnyFiniteTargetScene() {
  TargetScene scene;
  scene.own = {.id = *rc::gen::inRange(0, 3),
               .position_m = AnyFiniteVector(),
               .velocity_mps = AnyFiniteVector()};
  const auto other = [&](int id) {
    Neighbour neighbour{
        .id = id, .position_m = AnyFiniteVector(), .velocity_mps = AnyFiniteVector()};
    if (*rc::gen::inRange(0, 2) == 0) neighbour.position_m = scene.own.position_m;
    return neighbour;
  };
  scene.target = other(0);
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    scene.group.push_back(other(*rc::gen::inRange(0, 4)));
    scene.sonar.push_back({.direction = AnyFiniteVector(), .range_m = AnyFinite()});
  }
  scene.seabed_z_m = AnyFinite();
  return scene;
}

}  // namespace shoal
