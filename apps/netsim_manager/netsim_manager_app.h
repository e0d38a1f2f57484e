// Lets vehicle simulators from outside take part, as GobySoft's netsim does: positions come in over
// one TCP port, and each vehicle has a modem on a port of its own. Subscribes to
// ACOUSTIC_RX_<V> of these vehicles and COMMS_FATES; publishes NODE_REPORT, MODEM_TX and
// MODEM_STATS.
//
// Clients are answered at once, between steps; what they bring is published in the next step, of
// several positions of a vehicle the last. Modems keep mission time: between two steps it goes on
// as the wall's does.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/netsim_manager/outside_vehicle.h"
#include "lib/base/geodesy/local_frame.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/os/wait_set.h"
#include "lib/mission/model/mission.h"
#include "lib/mission/netsim/line_server.h"
#include "lib/mission/netsim/netsim_answer.h"
#include "lib/run/run/app.h"

namespace shoal {

class NetsimManagerApp : public App {
 public:
  /// @pre mission.netsim. Fault() names ports that could not be opened.
  NetsimManagerApp(const Mission& mission, Bus& bus);

  void Tick(int64_t utime) override;
  void OnWarp(double warp) override { warp_ = warp; }
  int ServedFd() const override { return served_.fd(); }
  void Serve(int64_t now_us, int64_t utc_us) override;
  std::string Fault() const override { return fault_; }
  StatusPage Status() const override;

  /// The port of the line protocol, where [netsim] leaves it to the system (port = 0).
  int port() const { return lines_ ? lines_->port() : 0; }
  /// The ports of a vehicle's modem and of its GPS sentences, likewise; 0: it has none.
  int ModemPortOf(std::string_view vehicle) const;
  int GpsPortOf(std::string_view vehicle) const;

 private:
  void Open();
  void Await(int fd);
  void Event(const std::string& text);
  bool Take(OutsideVehicle* outsider);
  std::string OnLine(const std::string& address, std::string_view line);
  void TakePosition(const NetsimPosition& position);
  void TakeStats(const NetsimReceiveStats& stats);
  void TakeFates(const comms_fates_t& fates);
  void PassReceived(OutsideVehicle* outsider, int64_t mission_us);
  void Report(OutsideVehicle* outsider, int64_t utime);
  /// Mission time since the start, for modems: never goes back.
  int64_t MissionTime_us(int64_t wall_us);
  /// Sets modems' clocks at first, and warns where they have fallen behind.
  void WatchClocks(int64_t mission_us);
  /// Returns how far mission time is behind the wall's since then; negative: ahead of it.
  int64_t Lag_us() const { return utc_us_ - utc_at_zero_us_.value_or(utc_us_) - mission_us_; }
  bool HasMicroModem() const;
  std::string NameOfPort(int32_t port) const;

  const Mission mission_;
  const NetsimOptions options_;
  const LocalFrame frame_;
  Bus& bus_;
  WaitSet served_;
  std::unique_ptr<LineServer> lines_;
  std::vector<OutsideVehicle> outsiders_;
  std::vector<modem_stats_t> stats_;  ///< Of this step.
  /// What COMMS_FATES holds of packets that arrived in this step: by receiver, sender and the
  /// packet's number, as ACOUSTIC_RX has it (path[0].packet counts reports and messages too).
  std::map<std::tuple<std::string, std::string, int64_t>, acoustic_path_t> paths_;
  NetsimCounts counts_;
  StatusLog log_;
  std::string fault_;

  double warp_ = 1;
  std::optional<int64_t> utime_;
  int64_t utc_us_ = 0;
  std::optional<int64_t> tick_wall_us_;  ///< When the last step was, as Serve saw it.
  int64_t mission_us_ = 0;               ///< As given to modems last.
  /// The wall's UTC at mission time 0, as modems' clocks were set by it.
  std::optional<int64_t> utc_at_zero_us_;
  bool has_lagged_ = false;  ///< The warning was given.
  int64_t num_stats_ = 0;
};

}  // namespace shoal
