// One transmission as it leaves its source.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lib/base/random/stream.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/kind.h"

namespace shoal {

struct Transmission {
  Kind kind = Kind::kReport;
  int64_t number = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  std::string_view group_key;
  double stealth = 1;
  /// DropKey of the source; absent: there is no drop_percentage.
  std::optional<StreamKey> link_key;
  bool is_forwarded = false;   ///< A gateway sends on what another has made.
  bool has_range_rule = true;  ///< False: of a modem, whose range the acoustic network decides.
};

}  // namespace shoal
