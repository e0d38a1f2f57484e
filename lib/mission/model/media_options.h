// Media and gateways of a mission as data: [[medium]], and what a vehicle has of them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/mission/model/environment.h"
#include "lib/sea/media/radio_link.h"

namespace shoal {

enum class MediumKind {
  kRadio,     ///< lib/sea/media/radio_link.h
  kAcoustic,  ///< A network of its own, with the keys of [acoustics].
};

inline constexpr std::array<std::pair<std::string_view, MediumKind>, 2> kMediumKinds = {{
    {"radio", MediumKind::kRadio},
    {"acoustic", MediumKind::kAcoustic},
}};

/// `[[medium]]`.
struct MediumOptions {
  std::string name = {};
  MediumKind kind = MediumKind::kRadio;
  RadioOptions radio = {};   ///< Of kind kRadio.
  Acoustics acoustics = {};  ///< Of kind kAcoustic.

  bool operator==(const MediumOptions&) const = default;
};

/// `[vehicle.gateway]`: what comes by one medium goes on over others.
struct GatewayOptions {
  bool exists = false;                 ///< The file has the table.
  std::vector<std::string> from = {};  ///< What comes by these media is forwarded.
  std::vector<std::string> to = {};    ///< Over the first of these that can work.
  bool reports = true;
  bool messages = true;  ///< Acks too.
  int64_t queue = 50;    ///< At most this many wait; what comes then is not forwarded.
  double rate_hz = 10;   ///< Forwards at most this many in a second.
  int64_t max_hops = 3;  ///< Does not forward what as many gateways have forwarded.

  bool operator==(const GatewayOptions&) const = default;
};

/// What a vehicle has to send and receive with.
struct VehicleMedia {
  std::vector<std::string> names = {};  ///< Besides direct, which all have.
  double antenna_height_m = -1;         ///< Above the vehicle; negative: the medium's.
  GatewayOptions gateway = {};

  bool operator==(const VehicleMedia&) const = default;
};

}  // namespace shoal
