// The current: the same everywhere at one time, horizontal, constant or swinging about a mean.
//
//   const Current current(params, StreamKey(seed, "current"));
//   Eigen::Vector2d water_mps = Velocity(current.At(time_s));
//
// The value at a time needs no history: every half period has draws of its own.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lib/base/random/stream.h"

namespace shoal {

/// A quantity that swings about its mean. deviation = 0: it is constant.
struct Swing {
  double mean = 0;
  double deviation = 0;  ///< >= 0: three standard deviations of what amplitudes are drawn from.
  double half_period_s = 60;  ///< From one crossing of the mean to the next.
};

struct CurrentParams {
  Swing speed_mps = {};
  Swing direction_rad = {};    ///< psi, toward which the water flows.
  double max_speed_mps = 2.5;  ///< Speeds are clipped to [0, this].
};

/// What keeps arithmetic finite; far beyond any sea.
inline constexpr double kMaxCurrent_mps = 50;
inline constexpr double kMinHalfPeriod_s = 1e-3;
inline constexpr double kMaxHalfPeriod_s = 1e9;

/// Returns whether a current can be made of these: finite numbers, 0 <= mean speed <= max_speed <=
/// kMaxCurrent_mps, deviations >= 0, the direction's at most pi, half periods within the limits.
[[nodiscard]] bool IsCurrent(const CurrentParams& params);

/// How the water moves at one time.
struct Flow {
  double speed_mps = 0;
  double direction_rad = 0;  ///< psi, (-pi, pi], toward which.
};

/// Returns the water's velocity, x East, y North.
[[nodiscard]] Eigen::Vector2d Velocity(const Flow& flow);

/// One half period of a swing.
struct HalfPeriod {
  double start_amplitude = 0;  ///< >= 0.
  double end_amplitude = 0;    ///< >= 0.
  bool above_mean = true;      ///< On which side of the mean.
};

/// Returns by how much the value lies off the mean at `fraction`, [0, 1], of the half period:
/// +-(a_0 + (a_1 - a_0) fraction) sin(pi fraction). MuNet's shape (golden current_shape.json).
[[nodiscard]] double DeviationAt(const HalfPeriod& half_period, double fraction);

/// Returns the flow at these deviations from the means: speed clipped, direction wrapped.
[[nodiscard]] Flow FlowAt(const CurrentParams& params, double speed_deviation_mps,
                          double direction_deviation_rad);

class Current {
 public:
  /// Still water.
  Current() : Current(CurrentParams{}, StreamKey(0, "current")) {}
  /// A speed's deviation counts as no more than what lies between its mean and either limit, as a
  /// larger one would only be clipped. @pre IsCurrent(params)
  Current(const CurrentParams& params, const StreamKey& key);

  /// Returns the flow at a time, negative ones too. Continuous in time but where the speed is
  /// clipped or the direction wraps. @pre time_s is finite
  [[nodiscard]] Flow At(double time_s) const;

  /// Returns Velocity(At(time_s)). @pre time_s is finite
  [[nodiscard]] Eigen::Vector2d VelocityAt(double time_s) const;

  const CurrentParams& params() const { return params_; }

 private:
  /// One of the two swings with its draws.
  struct Draws {
    StreamKey key;
    bool starts_above = true;
  };

  static Draws DrawsFor(const StreamKey& key, std::string_view name);
  static double Deviation(const Swing& swing, const Draws& draws, double time_s);
  static double Amplitude(const Swing& swing, const Draws& draws, int64_t node);

  std::optional<Eigen::Vector2d> constant_mps_;  ///< Absent: it swings.
  CurrentParams params_;
  Draws speed_;
  Draws direction_;
};

}  // namespace shoal
