#include "apps/netsim_manager/outside_vehicle.h"

#include <fmt/format.h>

#include <utility>

#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/mission/model/swarm_plan.h"

namespace shoal {

Result<bool> OpenPorts(const Mission& mission, const std::string& address,
                       const std::function<void(const std::string&)>& on_event,
                       OutsideVehicle* outsider) {
  const NetsimVehicle& vehicle = outsider->options;
  if (vehicle.modem != NetsimModem::kNone) {
    const Acoustics& acoustics = PacketAcousticsOf(mission);
    const std::optional<ModemPreset>& modem_of_network = acoustics.options.modem;
    const int64_t limit = modem_of_network ? modem_of_network->max_packet_bytes : 0;
    auto modem =
        ModemPort::Open({.address = address,
                         .port = vehicle.modem_tcp_port,
                         .kind = vehicle.modem,
                         .modem_address = outsider->vehicle->acoustic_address,
                         .water_bps = acoustics.options.data_rate_bps,
                         .more_bytes = acoustics.crc ? kPacketCrcBytes : 0,
                         .max_bytes = limit > 0 ? static_cast<size_t>(limit) : kMaxRawPieceBytes,
                         .on_refuse = [on_event, name = vehicle.name](const std::string& host) {
                           on_event(
                               fmt::format("{}: a second host at {} was refused, one "
                                           "client per port",
                                           name, host));
                         }});
    if (!modem.ok()) return Error{modem.error()};
    outsider->modem = std::move(*modem);
  }
  if (vehicle.gps.tcp_port > 0 || !vehicle.gps.path.empty()) {
    auto gps = GpsOutput::Open(
        vehicle.gps, address, [on_event, name = vehicle.name](const std::string& client) {
          on_event(fmt::format("{}: a GPS client at {} was refused, {} at most", name, client,
                               GpsOutput::kMaxClients));
        });
    if (!gps.ok()) return Error{gps.error()};
    outsider->gps = std::move(*gps);
  }
  return true;
}

node_report_t ReportOf(const OutsideVehicle& outsider, const Eigen::Vector2d& local_m,
                       int64_t utime) {
  const NetsimNav& nav = *outsider.nav;
  const Vehicle& vehicle = *outsider.vehicle;
  node_report_t report{};
  report.utime = utime;
  report.name = vehicle.name;
  report.type = vehicle.type;
  report.group = vehicle.group;
  report.color = vehicle.color;
  report.length_m = vehicle.length_m;
  report.x_m = local_m.x();
  report.y_m = local_m.y();
  report.depth_m = nav.depth_m;
  report.altitude_m = -1;
  report.lat_deg = nav.lat_deg;
  report.lon_deg = nav.lon_deg;
  report.speed_mps = report.speed_over_ground_mps = nav.speed_mps;
  report.heading_deg = report.course_over_ground_deg = Wrap360(nav.heading_deg);
  report.mode = "NETSIM";
  report.all_stop = "clear";
  report.index = outsider.num_reports;
  return report;
}

std::string TextOf(const OutsideVehicle& outsider, int64_t utime, std::string_view stats_sender) {
  const NetsimVehicle& options = outsider.options;
  std::string text =
      fmt::format("  {}: port {}, from {}, in {}; {} positions\n", options.name,
                  options.modem_tcp_port, options.address, options.environment, outsider.num_navs);
  if (outsider.nav) {
    const NetsimNav& nav = *outsider.nav;
    const double age_s = Seconds(utime - outsider.nav_utime.value_or(0));
    text +=
        fmt::format("    lat {:.6f}, lon {:.6f}, depth {:.1f} m, {:.2f} m/s, heading {:.1f} deg",
                    nav.lat_deg, nav.lon_deg, nav.depth_m, nav.speed_mps, nav.heading_deg);
    text += outsider.nav_utime ? fmt::format(", {:.1f} s ago\n", age_s) : "\n";
  }
  if (outsider.modem) text += outsider.modem->Text();
  if (outsider.stats) {
    text += fmt::format("    its last statistics: a packet of {}, {}", stats_sender,
                        outsider.stats->packet_success ? "good" : "bad");
    if (const auto& modem = outsider.stats->modem) {
      text += fmt::format(", rate {}, {} of {} frames bad, SNR {} dB in, {} dB out", modem->rate,
                          modem->num_bad_frames, modem->num_frames, modem->snr_in_db,
                          modem->snr_out_db);
    }
    text += "\n";
  }
  if (outsider.gps) {
    text += fmt::format("    GPS: {} sentences", outsider.num_sentences);
    if (outsider.gps->port() > 0) {
      const TcpServerCounts& counts = outsider.gps->counts();
      text += fmt::format(", port {}, {} refused, {} stalled", outsider.gps->port(), counts.refused,
                          counts.stalled);
    }
    if (!options.gps.path.empty()) {
      text += fmt::format(", {} ({} not taken)", options.gps.path, outsider.gps->num_lost());
    }
    text += "\n";
  }
  return text;
}

}  // namespace shoal
