// Acoustic networks and media as a text of their own, as COMMS_RULES carries them in logs.
//
//   const std::string text = ExplainMedia({.acoustics = mission.acoustics});
//   LoadedMedia loaded = LoadMediaText(text, "COMMS_RULES");
//   if (!loaded.errors.empty()) ...
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/sea/acoustics/channel_plan.h"

namespace shoal {

/// All that carries traffic in a mission, and what each vehicle has of it.
struct MediaSetup {
  /// What carries the packets of a vehicle in a swarm that is not as `packets_over`.
  struct PacketsOf {
    std::string vehicle;
    MediaChoice over;

    bool operator==(const PacketsOf&) const = default;
  };
  /// A vehicle whose acoustic modem hangs below it.
  struct HangingModem {
    std::string vehicle;
    double depth_m = 0;  ///< Below the vehicle; > 0.

    bool operator==(const HangingModem&) const = default;
  };

  Acoustics acoustics = {};               ///< The medium acoustic.
  std::vector<MediumOptions> media = {};  ///< [[medium]].
  MediaChoice packets_over = {.names = {std::string(kAcousticMedium)}};
  std::vector<PacketsOf> packets_of = {};
  std::vector<HangingModem> hanging_modems = {};
  /// In the mission's order; empty: all vehicles have all media, and there is no gateway.
  std::vector<VehicleMedia> of_vehicles = {};
  /// The sea floor, where a channel of sound follows it.
  std::optional<FloorOptions> floor = {};

  bool operator==(const MediaSetup&) const = default;

  /// Returns the acoustic networks, that of [acoustics] first.
  std::vector<const Acoustics*> Networks() const;
  /// The names of all media, the built-in ones first.
  std::vector<std::string> Names() const;
  /// Returns how far below a vehicle its acoustic modem hangs.
  double ModemDepth_m(std::string_view vehicle) const;
  /// Returns what carries the packets of a vehicle.
  const MediaChoice& PacketsOver(std::string_view vehicle) const;
};

struct LoadedMedia {
  MediaSetup setup;                 ///< Usable only where `errors` is empty.
  std::vector<std::string> errors;  ///< "name:line:column: what is wrong", in order.
};

/// Returns the media of a mission.
[[nodiscard]] MediaSetup MediaOf(const Mission& mission);

/// Returns the table [acoustics] with every default filled in, the modem's data included; where the
/// acoustic network is not used, a line before the table states it. Then the other media, where
/// there are any. Loading that text gives an equal setup.
[[nodiscard]] std::string ExplainMedia(const MediaSetup& setup);

/// Reads such a text; `name` stands for the file in messages. Opens no file: a modem must be
/// written as a table.
[[nodiscard]] LoadedMedia LoadMediaText(std::string_view text, const std::string& name);

/// Returns the nodes of a network of unknown size.
[[nodiscard]] std::vector<AcousticNode> AnyNode();

}  // namespace shoal
