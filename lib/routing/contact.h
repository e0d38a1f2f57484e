// What the broker knows of one vehicle.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace shoal {

/// Where one vehicle was when it last told us, and what became of what it said and should hear.
struct Contact {
  std::string name;         ///< As the mission, or the vehicle itself at first, writes it.
  std::string group;        ///< Empty: belongs to no group.
  int32_t index = 0;        ///< Its place among the router's contacts.
  bool of_mission = false;  ///< Has its place kept whatever strangers do.
  bool known = false;       ///< False: not heard of yet, or forgotten.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  int64_t received_utime = 0;  ///< Of its last report, by our clock; staleness counts from here.
  int64_t num_reports = 0;     ///< That it sent, refused ones included; the next one's number.
  int64_t num_admitted = 0;    ///< Of these, the ones that were not refused.
  int64_t num_heard = 0;       ///< Reports delivered to it.
};

}  // namespace shoal
