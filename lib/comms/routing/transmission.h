// One transmission as it leaves its source.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lib/base/random/stream.h"
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

/// Returns `later_utime` - `earlier_utime` in seconds.
[[nodiscard]] inline double SecondsBetween(int64_t earlier_utime, int64_t later_utime) {
  return static_cast<double>(later_utime - earlier_utime) / 1e6;
}

}  // namespace shoal
