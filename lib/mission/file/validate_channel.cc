// Channels in which sound bends: what their files hold, and what of the mission has no effect.
#include <fmt/format.h>

#include <string>

#include "lib/mission/file/validate.h"
#include "lib/mission/file/water_files.h"

namespace shoal {
namespace {

void WarnOfIdleSound(const RayChannelOptions& rays, const AcousticOptions& options,
                     const TablePlace& network) {
  if (network.Below("sea").Has("spreading_exponent")) {
    network.Below("sea").Warn("spreading_exponent",
                              "spreading_exponent has no effect with rays, which spread as the "
                              "water bends them");
  }
  if (network.Has("sound_speed_mps")) {
    network.Warn("sound_speed_mps",
                 "travel times come from the profile of [acoustics.channel]; sound_speed_mps is "
                 "what swarms plan their slots with");
  }
  if (!rays.packet_errors.empty() && options.packet_loss_model != PacketLossModel::kModem) {
    network.Below("channel").Warn(
        "packet_errors", "packet_errors has no effect: packet_loss_model is not \"modem\"");
  }
}

void ValidateChannel(const Mission& mission, const AcousticOptions& options,
                     const TablePlace& network) {
  const RayChannelOptions& rays = *options.rays;
  const TablePlace channel = network.Below("channel");
  if (!channel.IsSound()) return;
  WarnOfIdleSound(rays, options, network);
  if (!rays.arrivals_file.empty()) {
    const auto table = ReadArrivals(PathBeside(mission.file, rays.arrivals_file));
    if (!table.ok()) channel.Refuse("arrivals_file", table.error());
    return;
  }
  if (rays.follows_floor && mission.environment.floor.style == "none") {
    channel.Refuse("follows_floor",
                   "follows_floor = true, and the mission has no sea floor: write "
                   "[environment.floor], or bottom_depth_m here");
  }
  const double deepest_m = rays.profile.back().depth_m;
  if (!rays.follows_floor && rays.profile.size() > 1 && deepest_m < rays.bottom_depth_m) {
    channel.Warn(channel.Has("profile") ? "profile" : "profile_file",
                 fmt::format("the profile ends at {:g} m, above the bottom at {:g} m: the speed is "
                             "taken to be constant below",
                             deepest_m, rays.bottom_depth_m));
  }
  const double bottom_m = rays.bottom_depth_m;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    if (rays.follows_floor || vehicle.start.depth_m <= bottom_m) continue;
    network.Warn(
        "channel",
        fmt::format("{} starts at {:g} m, below the bottom of the channel at {:g} m: sound "
                    "reaches it as if it hung just above",
                    vehicle.name, vehicle.start.depth_m, bottom_m));
  }
}

}  // namespace

void ValidateChannels(const Mission& mission, const TablePlace& file) {
  if (mission.acoustics.options.rays) {
    ValidateChannel(mission, mission.acoustics.options, file.Below("acoustics"));
  }
  for (size_t i = 0; i < mission.media.size(); ++i) {
    const AcousticOptions& options = mission.media[i].acoustics.options;
    if (mission.media[i].kind == MediumKind::kAcoustic && options.rays) {
      ValidateChannel(mission, options, file.Below("medium", i));
    }
  }
}

}  // namespace shoal
