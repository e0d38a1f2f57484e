// The last reported state of one vehicle.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lib/comms/routing/fate.h"
#include "lib/comms/routing/rules.h"
#include "lib/comms/routing/sparse_row.h"

namespace shoal {

/// The time of what has not happened.
inline constexpr int64_t kNever = std::numeric_limits<int64_t>::min();

/// The last reported state of one vehicle, and the fates of what it sent and was to receive.
struct Contact {
  std::string name;         ///< As the mission, or the vehicle itself at first, writes it.
  std::string key;          ///< VehicleKey(name).
  std::string group_key;    ///< Its group in lower case; empty: belongs to no group.
  int32_t index = 0;        ///< Its place among the router's contacts.
  int32_t rank = 0;         ///< Its place in the order of keys.
  bool of_mission = false;  ///< Registered: keeps its place whatever unregistered vehicles do.
  bool known = false;       ///< False: has not reported yet, or was forgotten.
  LinkFactors factors;      ///< Kept when it is forgotten.

  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  /// Its true position, which decides about packets. Absent: the position of its last report.
  std::optional<Eigen::Vector3d> true_position_m;
  int64_t received_utime = 0;  ///< Of its last report, by our clock; staleness counts from here.
  int64_t message_utime = kNever;       ///< Of its last message that was not too soon.
  int64_t last_message_utime = kNever;  ///< Of its last message, unless that was invalid.

  /// When a report of this vehicle was last delivered, by index of the receiver.
  SparseRow<int64_t, kNever> delivered_utime;
  /// Whose next report this vehicle receives whatever the other rules decide, by index; may be
  /// shorter.
  std::vector<uint8_t> wants_report_of;
  int32_t num_wanted = 0;  ///< How many of these.

  std::array<int64_t, kNumKinds> num_sent = {};  ///< Transmissions; the next one's number.
  int64_t num_admitted = 0;                      ///< Reports that were not refused.
  KindCounts sent = {};                          ///< Fates of what it sent.
  KindCounts received = {};                      ///< Fates of what it was to receive.

  /// True where it sends and receives transmissions of this kind: packets once its place is known,
  /// all else once it has reported.
  bool TakesPart(Kind kind) const {
    return known || (kind == Kind::kPacket && true_position_m.has_value());
  }
  const Eigen::Vector3d& PositionFor(Kind kind) const {
    return kind == Kind::kPacket && true_position_m ? *true_position_m : position_m;
  }
};

}  // namespace shoal
