// A vehicle that is simulated by a program outside: its ports, and what its clients have sent.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/netsim_manager/modem_port.h"
#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/mission.h"
#include "lib/mission/netsim/gps_output.h"
#include "lib/mission/netsim/netsim_answer.h"

namespace shoal {

/// What of a packet is not its sender's: the checksum of [acoustics] crc, on the air.
inline constexpr size_t kPacketCrcBytes = 4;

struct OutsideVehicle {
  NetsimVehicle options;
  const Vehicle* vehicle = nullptr;
  std::unique_ptr<ModemPort> modem;         ///< Null: it has none.
  std::unique_ptr<GpsOutput> gps;           ///< Null: it has none.
  std::vector<acoustic_rx_t> received;      ///< In this step.
  std::optional<NetsimReceiveStats> stats;  ///< The last of its client.
  std::optional<NetsimNav> nav;             ///< The last.
  std::optional<int64_t> nav_utime;         ///< The step in which it was published.
  bool nav_is_new = false;
  int64_t num_navs = 0;
  int64_t num_sentences = 0;  ///< For GPS.
  int64_t num_reports = 0;
};

/// Opens the ports of modem and GPS that the vehicle's options ask for. `address`: to listen on.
/// `on_event`: called, while the ports are served, with a sentence about a client that was refused.
[[nodiscard]] Result<bool> OpenPorts(const Mission& mission, const std::string& address,
                                     const std::function<void(const std::string&)>& on_event,
                                     OutsideVehicle* outsider);

/// Returns its position as a node report. @pre outsider.nav
[[nodiscard]] node_report_t ReportOf(const OutsideVehicle& outsider, const Eigen::Vector2d& local_m,
                                     int64_t utime);

/// Returns its lines of the status page. `stats_sender`: the vehicle whose packet outsider.stats is
/// about.
[[nodiscard]] std::string TextOf(const OutsideVehicle& outsider, int64_t utime,
                                 std::string_view stats_sender);

}  // namespace shoal
