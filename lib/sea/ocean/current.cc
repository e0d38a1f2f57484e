#include "lib/sea/ocean/current.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

/// Nodes further from the start than this all count as this one: integers stay exact.
constexpr double kLastNode = 1e15;

bool IsSwing(const Swing& swing, double max_deviation) {
  return std::isfinite(swing.mean) && swing.deviation >= 0 && swing.deviation <= max_deviation &&
         swing.half_period_s >= kMinHalfPeriod_s && swing.half_period_s <= kMaxHalfPeriod_s;
}

}  // namespace

bool IsCurrent(const CurrentParams& params) {
  return IsSwing(params.speed_mps, kMaxCurrent_mps) && IsSwing(params.direction_rad, kPi) &&
         params.speed_mps.mean >= 0 && params.speed_mps.mean <= params.max_speed_mps &&
         params.max_speed_mps <= kMaxCurrent_mps;
}

Eigen::Vector2d Velocity(const Flow& flow) {
  const auto [sine, cosine] = SinCos(flow.direction_rad);
  return flow.speed_mps * Eigen::Vector2d(cosine, sine);
}

double DeviationAt(const HalfPeriod& half_period, double fraction) {
  const double amplitude = half_period.start_amplitude +
                           (half_period.end_amplitude - half_period.start_amplitude) * fraction;
  const double deviation = amplitude * Sin(kPi * fraction);
  return half_period.above_mean ? deviation : -deviation;
}

Flow FlowAt(const CurrentParams& params, double speed_deviation_mps,
            double direction_deviation_rad) {
  return {.speed_mps =
              std::clamp(params.speed_mps.mean + speed_deviation_mps, 0.0, params.max_speed_mps),
          .direction_rad = WrapPi(params.direction_rad.mean + direction_deviation_rad)};
}

Current::Current(const CurrentParams& params, const StreamKey& key)
    : params_(params), speed_(DrawsFor(key, "speed")), direction_(DrawsFor(key, "direction")) {
  SHOAL_CHECK(IsCurrent(params), "IsCurrent(params)");
  Swing& speed = params_.speed_mps;
  speed.deviation = std::min({speed.deviation, speed.mean, params_.max_speed_mps - speed.mean});
  if (speed.deviation == 0 && params_.direction_rad.deviation == 0) {
    constant_mps_ = Velocity(At(0));
  }
}

Current::Draws Current::DrawsFor(const StreamKey& key, std::string_view name) {
  const StreamKey own = key.With(name);
  return {.key = own, .starts_above = Stream(own.With("start")).UniformInt(2) == 0};
}

double Current::Amplitude(const Swing& swing, const Draws& draws, int64_t node) {
  return std::abs(swing.deviation / 3 * Stream(draws.key.With(node)).Normal());
}

double Current::Deviation(const Swing& swing, const Draws& draws, double time_s) {
  if (swing.deviation == 0) return 0;
  const double half_periods = std::clamp(time_s / swing.half_period_s, -kLastNode, kLastNode);
  const double start = std::floor(half_periods);
  const auto node = static_cast<int64_t>(start);
  const bool is_even = node % 2 == 0;
  return DeviationAt({.start_amplitude = Amplitude(swing, draws, node),
                      .end_amplitude = Amplitude(swing, draws, node + 1),
                      .above_mean = draws.starts_above == is_even},
                     half_periods - start);
}

Flow Current::At(double time_s) const {
  SHOAL_CHECK(std::isfinite(time_s), "time_s is finite");
  return FlowAt(params_, Deviation(params_.speed_mps, speed_, time_s),
                Deviation(params_.direction_rad, direction_, time_s));
}

Eigen::Vector2d Current::VelocityAt(double time_s) const {
  SHOAL_CHECK(std::isfinite(time_s), "time_s is finite");
  return constant_mps_ ? *constant_mps_ : Velocity(At(time_s));
}

}  // namespace shoal
