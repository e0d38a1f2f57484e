// Settings of a channel in which sound bends: [acoustics.channel] with model = "rays".
#pragma once

#include <string>
#include <vector>

#include "lib/sea/rays/reflection.h"
#include "lib/sea/rays/sound_profile.h"

namespace shoal {

/// One point of a packet error table: linear in between, constant beyond its ends.
struct PacketErrorPoint {
  double snr_db = 0;  ///< Grows from point to point.
  double loss = 0;    ///< Probability that a packet is lost, [0, 1].

  bool operator==(const PacketErrorPoint&) const = default;
};

struct RayChannelOptions {
  std::vector<SpeedPoint> profile = {{0, 1500}};
  bool follows_floor = false;   ///< The bottom is the sea floor of the mission.
  double bottom_depth_m = 100;  ///< Else it is flat, here.
  HalfSpace bottom = {};
  double wind_mps = 0;         ///< Raises waves at the surface.
  double max_launch_deg = 60;  ///< Rays are launched up to this angle, up and down; < 90.
  double window_s = 0.01;      ///< Arrivals up to this long after the first add to the signal.
  double significant_db = 20;  ///< Weaker than the strongest by more than this: not significant.
  double max_doppler_mps = 5;  ///< Arrivals with more do not add to the signal.
  double cell_m = 1;           ///< Arrivals are kept by cells of position with this side; > 0.
  std::vector<PacketErrorPoint> packet_errors = {};  ///< Empty: the modem's bit error rate decides.

  // Where data came from: paths as the mission file has them; empty: not from a file.
  std::string profile_file = {};
  std::string packet_errors_file = {};
  std::string arrivals_file = {};  ///< Arrivals that Bellhop has written take the place of rays.

  bool operator==(const RayChannelOptions&) const = default;
};

/// Returns the probability of loss that a table has for this ratio. @pre the table is not empty
[[nodiscard]] double LossOf(const std::vector<PacketErrorPoint>& table, double snr_db);

/// Returns "" or what is wrong with the options.
[[nodiscard]] std::string ProblemOf(const RayChannelOptions& options);

}  // namespace shoal
