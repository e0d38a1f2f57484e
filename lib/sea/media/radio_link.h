// Whether a radio transmission gets from one antenna to another, with the numbers that decided, and
// how long it takes.
//
//   const RadioLink link = DecideRadio(options, {.position_m = {0, 0, 0}}, {.position_m = {900, 0,
//   12}}); link.fault is kSubmerged, link.depth_m 12.
//
// A transmission needs both antennas out of the water, then a range below the horizon (where that
// is asked), below `range_m` (where that is set), and a loss that transmitter and receiver can
// bear.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

#include "lib/base/random/stream.h"
#include "lib/sea/media/path_loss.h"

namespace shoal {

/// A `[[medium]]` of kind = "radio".
struct RadioOptions {
  double range_m = 1000;         ///< It had to be less than this; negative: no such limit.
  double surface_depth_m = 0.5;  ///< A vehicle deeper than this has its antenna in the water.
  double antenna_height_m = 2;   ///< Above the vehicle; a vehicle may have its own.
  bool horizon = false;          ///< The Earth's curvature hides what is too far.
  PathLossModel path_loss = PathLossModel::kNone;
  double frequency_mhz = 900;
  double power_dbm = 30;          ///< Of the transmitter, with both antennas' gain.
  double sensitivity_dbm = -100;  ///< What is received must not be weaker.
  double exponent = 2;            ///< Of log_distance.
  double rate_bps = 0;            ///< 0: a transmission takes no time on the air.
  double latency_s = 0;
  double jitter_s = 0;  ///< Up to this, uniformly distributed, on top of the latency.
  double loss = 0;      ///< [0, 1]: this share is lost at random.

  bool operator==(const RadioOptions&) const = default;
};

/// One end of a link.
struct RadioEnd {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  double antenna_height_m = -1;                          ///< Negative: the medium's.
};

/// What stops a transmission.
enum class RadioFault { kNone, kSubmerged, kBelowHorizon, kOutOfRange, kWeakSignal };

/// A number that was not asked for is -1.
struct RadioLink {
  RadioFault fault = RadioFault::kNone;
  double depth_m = -1;        ///< Of the deeper end.
  double depth_limit_m = -1;  ///< The depth had to be at most this.
  double range_m = -1;
  double limit_m = -1;  ///< The range had to be less: the least of the limits asked for.
  double horizon_m = -1;
  double path_loss_db = -1;
  double path_loss_limit_db = -1;  ///< The loss had to be at most this.
};

/// Decides one link. The same in both directions.
[[nodiscard]] RadioLink DecideRadio(const RadioOptions& options, const RadioEnd& source,
                                    const RadioEnd& receiver);
/// What follows from the options alone, and takes longer than all the rest.
struct RadioTerms {
  TwoRayTerms two_ray;   ///< Of antennas of the medium's height above the surface.
  double horizon_m = 0;  ///< Likewise.
};
[[nodiscard]] RadioTerms TermsOf(const RadioOptions& options);
/// The same as without the terms, bit for bit.
[[nodiscard]] RadioLink DecideRadio(const RadioOptions& options, const RadioTerms& terms,
                                    const RadioEnd& source, const RadioEnd& receiver);

/// Names the random numbers of the transmissions of one kind over one link.
struct RadioDraws {
  StreamKey jitter;
  StreamKey loss;
};
/// `source`, `receiver`: keys of names.
[[nodiscard]] RadioDraws RadioDrawsOf(uint64_t seed, std::string_view medium, std::string_view kind,
                                      std::string_view source, std::string_view receiver);

/// How long transmission `number` of its source and kind takes, and whether chance loses it.
struct RadioPassage {
  double air_s = 0;
  double delay_s = 0;  ///< From the first byte sent to the last received: air, latency, jitter.
  bool is_lost = false;
};
[[nodiscard]] RadioPassage DrawPassage(const RadioOptions& options, int64_t num_bytes,
                                       const RadioDraws& draws, int64_t number);

}  // namespace shoal
