// The status page of netsim_manager.
#include <fmt/format.h>

#include "apps/netsim_manager/netsim_manager_app.h"

namespace shoal {

std::string NetsimManagerApp::OutsiderText(const Outsider& outsider) const {
  const NetsimVehicle& options = outsider.options;
  std::string text =
      fmt::format("  {}: port {}, from {}, in {}; {} positions\n", options.name,
                  options.modem_tcp_port, options.address, options.environment, outsider.num_navs);
  if (outsider.nav) {
    const NetsimNav& nav = *outsider.nav;
    const double age_s =
        static_cast<double>(utime_.value_or(0) - outsider.nav_utime.value_or(0)) / 1e6;
    text +=
        fmt::format("    lat {:.6f}, lon {:.6f}, depth {:.1f} m, {:.2f} m/s, heading {:.1f} deg",
                    nav.lat_deg, nav.lon_deg, nav.depth_m, nav.speed_mps, nav.heading_deg);
    text += outsider.nav_utime ? fmt::format(", {:.1f} s ago\n", age_s) : "\n";
  }
  if (outsider.modem) text += outsider.modem->Text();
  if (outsider.stats) {
    text += fmt::format("    last told of a packet of {}: {}",
                        NameOfPort(outsider.stats->tx_modem_tcp_port),
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
    if (outsider.gps->port() > 0) text += fmt::format(", port {}", outsider.gps->port());
    if (!options.gps.path.empty()) {
      text += fmt::format(", {} ({} not taken)", options.gps.path, outsider.gps->num_lost());
    }
    text += "\n";
  }
  return text;
}

StatusPage NetsimManagerApp::Status() const {
  StatusPage page;
  page.text =
      fmt::format("Configuration:\n    Listens on {}:{}, {} vehicles, warp {}\n", options_.address,
                  port(), outsiders_.size(), options_.allow_warp ? "allowed" : "1 only");
  if (lines_) {
    const TcpServerCounts& counts = lines_->counts();
    page.text +=
        fmt::format("Clients: {} now, {} so far, {} refused, {} broken off, {} idle, {} stalled\n",
                    lines_->num_clients(), counts.accepted, counts.refused, counts.broken,
                    counts.idle, counts.stalled);
    page.text += fmt::format("Lines ({} too long):\n", lines_->num_too_long());
  }
  for (size_t i = 0; i < kNumNetsimOutcomes; ++i) {
    const auto outcome = static_cast<NetsimOutcome>(i);
    if (counts_.Of(outcome) == 0) continue;
    page.text += fmt::format("    {}: {}\n", Word(outcome), counts_.Of(outcome));
  }
  page.text += fmt::format("Receive statistics: {}\nVehicles:\n", num_stats_);
  for (const Outsider& outsider : outsiders_) page.text += OutsiderText(outsider);
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
