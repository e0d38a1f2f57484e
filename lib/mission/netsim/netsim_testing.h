// A mission's [netsim] for tests, and requests as a client would write them.
#pragma once

#include <string>
#include <vector>

#include "lib/base/codec/base64.h"
#include "lib/mission/netsim/netsim_options.h"
#include "lib/mission/netsim/netsim_request.h"

namespace shoal {

/// alice (62000) swims in the bay and reports from 127.0.0.1; bruce (62001), at the date line, from
/// anywhere.
inline NetsimOptions TwoNetsimVehicles() {
  NetsimOptions options;
  options.environments = {{.name = "bay",
                           .lat_min_deg = 41,
                           .lat_max_deg = 42,
                           .lon_min_deg = -71,
                           .lon_max_deg = -70,
                           .depth_min_m = 0,
                           .depth_max_m = 100},
                          {.name = "date line",
                           .lat_min_deg = -10,
                           .lat_max_deg = 10,
                           .lon_min_deg = 170,
                           .lon_max_deg = 190,
                           .depth_min_m = -5,
                           .depth_max_m = 50}};
  options.vehicles = {
      {.name = "alice", .modem_tcp_port = 62000, .address = "127.0.0.1", .environment = "bay"},
      {.name = "bruce", .modem_tcp_port = 62001, .environment = "date line"}};
  return options;
}

/// In the middle of the bay.
inline NetsimNav AliceNav() {
  return {.modem_tcp_port = 62000,
          .time_s = 1.7e9,
          .lat_deg = 41.5,
          .lon_deg = -70.5,
          .depth_m = 10,
          .speed_mps = 1.5,
          .heading_deg = 90};
}

/// Puts a message into a line, without its end.
inline std::string LineOf(const std::vector<uint8_t>& message,
                          const std::string& name = "netsim.protobuf.NetSimManagerRequest") {
  return "NETSIM|" + name + "|" + Base64(message);
}

}  // namespace shoal
