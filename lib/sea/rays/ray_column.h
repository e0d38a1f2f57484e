// The parts that every path between two depths of a layered sea is made of.
//
//   const RayColumn column(profile, 0, 100, 30, 60);
//   const RayColumn::Kind kind = column.KindAt(launch_rad);
//   const RayParts parts = column.PartsAt(launch_rad, kind);   // range and time of each part
#pragma once

#include <vector>

#include "lib/sea/rays/sound_profile.h"

namespace shoal {

/// What a stretch of a path adds.
struct PathSum {
  double range_m = 0;
  double slope = 0;  ///< d range / d p, p = cos(angle) / speed: m^2/s.
  double time_s = 0;
  double length_m = 0;
};

/// Up: from the shallower end to the turn or the surface. Between: from end to end. Down: from the
/// deeper end to the turn or the bottom.
struct RayParts {
  PathSum up;
  PathSum between;
  PathSum down;
  double p = 0;  ///< cos(angle) / speed, s/m.
};

class RayColumn {
 public:
  /// @pre surface_m <= source_m, receiver_m <= bottom_m
  RayColumn(const SoundProfile& profile, double surface_m, double bottom_m, double source_m,
            double receiver_m);

  /// What becomes of rays between two critical angles: the vertices, from the surface down, up to
  /// which they come.
  struct Kind {
    size_t top = 0;
    size_t bottom = 0;
    bool turns_above = false;  ///< False: it meets the surface.
    bool turns_below = false;  ///< False: it meets the bottom.
    bool reaches = false;      ///< The receiver's depth; if not, the rest has no meaning.
  };

  /// Returns the launch angles > 0, growing, at which the kind of a ray can change: those of rays
  /// that are horizontal at a kink of the profile, at a boundary or at the receiver.
  [[nodiscard]] std::vector<double> CriticalAngles() const;
  /// The kind of the rays around this angle. @pre launch_rad > 0
  [[nodiscard]] Kind KindAt(double launch_rad) const;

  /// Returns ranges and slopes of the parts, times and lengths too if `has_times`. @pre
  /// kind.reaches, and launch_rad in (0, pi/2), or at the ends of what has this kind
  [[nodiscard]] RayParts PartsAt(double launch_rad, const Kind& kind, bool has_times) const;

  /// Returns the sine of the angle at a vertex, not negative.
  [[nodiscard]] double SineAt(size_t vertex, double launch_rad) const;

  double speed_mps(size_t vertex) const { return vertices_[vertex].speed_mps; }
  size_t source() const { return source_; }
  size_t receiver() const { return receiver_; }
  size_t surface() const { return 0; }
  size_t bottom() const { return vertices_.size() - 1; }
  /// Returns whether both ends lie in one stretch of water of constant speed.
  [[nodiscard]] bool IsStraightBetween() const;

 private:
  struct Vertex {
    double depth_m = 0;
    double speed_mps = 0;
    double gradient = 0;  ///< Of the layer below it, 1/s.
  };

  size_t Find(double depth_m) const;
  double SquareAt(size_t vertex, double sine) const;
  /// Adds the layers between two vertices. @pre first <= last
  PathSum Cross(size_t first, size_t last, double sine, double p, bool has_times) const;
  /// Adds the arc from a vertex to its turn in a layer of this gradient.
  static void AddTurn(double sine, double p, double gradient, bool has_times, PathSum* sum);

  std::vector<Vertex> vertices_;
  size_t source_ = 0;
  size_t receiver_ = 0;
};

}  // namespace shoal
