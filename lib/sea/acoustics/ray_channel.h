// What one modem receives of another where sound bends: from the arrivals of its rays, their travel
// time, the power that adds up and the power that disturbs.
//
//   RayChannel channel(options, {.floor = floor}, {.hz = 25'000, .absorption_dbpkm = 6});
//   const RayReception reception = channel.Receive({alpha_m, alpha_mps}, {bravo_m, bravo_mps});
//   if (reception.num_arrivals == 0) ...   // A shadow zone: reception.shadow states why.
//
// The arrivals of a link are found once for each cell of positions: in a sea that is the same
// everywhere by range and both depths, over a sea floor by both places. They are those of the
// cell's middle; delays are moved from there to the places themselves to first order. Links shorter
// than 100 cells are not kept. A delay is then wrong by at most cell_m / (200 c), 3.3 us for 1 m
// (away from caustics), a level by 0.1 dB, the edge of a shadow by a cell. What is found depends on
// the cell alone, and so not on what was asked before.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lib/sea/acoustics/ray_channel_options.h"
#include "lib/sea/ocean/sea_floor.h"
#include "lib/sea/rays/bellhop_arrivals.h"
#include "lib/sea/rays/eigenrays.h"

namespace shoal {

/// Why no path without a bounce leads to the receiver.
enum class ShadowReason : uint8_t {
  kNone,           ///< There is one.
  kBendsDown,      ///< Sound is slower below, and rays bend away from the surface.
  kBendsUp,        ///< Sound is slower above.
  kFastLayer,      ///< Faster water between the two depths turns the rays back.
  kBottomBetween,  ///< The sea floor stands between the two.
  kNotInFan,       ///< None of the above: the path is steeper than max_launch_deg, or too weak.
};

/// Returns "sound bends down" ...; empty for kNone.
[[nodiscard]] std::string_view ShadowText(ShadowReason reason);

/// The surroundings that options name but do not hold.
struct RaySurroundings {
  std::optional<SeaFloor> floor = {};                      ///< Where follows_floor.
  std::shared_ptr<const ArrivalTable> arrivals = nullptr;  ///< Where arrivals_file is named.
};

/// What the water does at the modem's frequencies.
struct RayBand {
  double hz = 25'000;  ///< The middle of the band.
  double absorption_dbpkm = 0;
};

struct RayEnd {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();    ///< x East, y North, z down.
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();  ///< Over ground.
};

struct RayReception {
  double travel_s = 0;        ///< Of the earliest significant arrival.
  double signal = 0;          ///< Power of the arrivals that add up, relative to that at 1 m.
  double interference = 0;    ///< Power of all others.
  int num_arrivals = 0;       ///< That are significant.
  double delay_spread_s = 0;  ///< From the first of them to the last.
  int num_surface = 0;        ///< Bounces of the strongest.
  int num_bottom = 0;
  double doppler_mps = 0;  ///< Of the strongest: how fast its path grows shorter.
  ShadowReason shadow = ShadowReason::kNone;
};

class RayChannel {
 public:
  /// @pre ProblemOf(options).empty(), and the surroundings that the options name are there
  RayChannel(const RayChannelOptions& options, RaySurroundings surroundings, const RayBand& band);

  /// Returns what arrives. @pre finite ends
  [[nodiscard]] RayReception Receive(const RayEnd& from, const RayEnd& to);

  /// Returns the time that sound takes on the earliest significant path, and nothing where there is
  /// no path.
  [[nodiscard]] std::optional<double> TravelTime(const Eigen::Vector3d& from_m,
                                                 const Eigen::Vector3d& to_m);

  const SoundProfile& profile() const { return profile_; }
  /// Returns the section from one place to another, as rays are traced in it.
  [[nodiscard]] RayScene SceneBetween(const Eigen::Vector3d& from_m,
                                      const Eigen::Vector3d& to_m) const;

 private:
  /// One arrival of a cell's middle: what does not change within the cell, and how delay changes.
  struct Path {
    double delay_s = 0;
    double power = 0;      ///< Absorption taken away.
    double by_range = 0;   ///< d delay / d range, s/m.
    double by_source = 0;  ///< d delay / d depth of the source.
    double by_receiver = 0;
    int16_t num_surface = 0;
    int16_t num_bottom = 0;
  };
  struct Link {
    double range_m = 0;  ///< Of the cell's middle, and its depths.
    double source_m = 0;
    double receiver_m = 0;
    ShadowReason shadow = ShadowReason::kNone;
    std::vector<Path> paths;  ///< In order of delay.
  };
  using Cell = std::array<int32_t, 6>;
  struct CellHash {
    size_t operator()(const Cell& cell) const;
  };

  const Link& LinkOf(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m, double range_m);
  Link FindLink(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m) const;
  std::vector<RayArrival> FindArrivals(const RayScene& scene, double range_m, double source_m,
                                       double receiver_m) const;
  ShadowReason ReasonOf(const RayScene& scene, double range_m, double source_m,
                        double receiver_m) const;

  RayChannelOptions options_;
  SoundProfile profile_;
  RaySurroundings surroundings_;
  RayBand band_;
  double significant_share_;  ///< Of the strongest power.
  std::unordered_map<Cell, Link, CellHash> links_;
  Link uncached_;
};

}  // namespace shoal
