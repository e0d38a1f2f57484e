#include "apps/netsim_manager/netsim_manager_app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/kind.h"
#include "lib/mission/netsim/gprmc.h"

namespace shoal {

namespace {

constexpr double kNoSnr_db = -900;  ///< acoustic_path_t has -999 where there is none.
constexpr size_t kMaxStatsPerStep = 1000;
constexpr size_t kMaxReceivedPerStep = 1000;
/// Vehicle simulators send several times per second: what is silent for so long gives its place to
/// a client that comes.
constexpr int64_t kSilence_us = 10'000'000;

/// A driver such as Goby's wants its modem's clock within 1 s of its own.
constexpr int64_t kMaxLag_us = 500'000;

/// Differences of such times are numbers still.
bool IsMissionTime(int64_t utime) {
  constexpr int64_t kLatest_us = 1'000'000'000'000'000'000;
  return utime >= 0 && utime <= kLatest_us;
}

}  // namespace

NetsimManagerApp::NetsimManagerApp(const Mission& mission, Bus& bus)
    : mission_(mission),
      options_(mission.netsim.value_or(NetsimOptions())),
      frame_({.lat_deg = mission.origin_lat_deg, .lon_deg = mission.origin_lon_deg}),
      bus_(bus) {
  for (const NetsimVehicle& vehicle : options_.vehicles) {
    OutsideVehicle outsider;
    outsider.options = vehicle;
    outsider.vehicle = mission_.FindVehicle(vehicle.name);
    SHOAL_CHECK(outsider.vehicle != nullptr, "the mission file was checked");
    outsiders_.push_back(std::move(outsider));
  }
  Open();
  for (size_t i = 0; i < outsiders_.size(); ++i) {
    if (outsiders_[i].modem == nullptr) continue;
    Subscribe(bus, channels::AcousticRx(outsiders_[i].options.name),
              [this, i](const acoustic_rx_t& packet) {
                std::vector<acoustic_rx_t>& received = outsiders_[i].received;
                if (received.size() < kMaxReceivedPerStep) received.push_back(packet);
              });
  }
  Subscribe(bus, channels::CommsFates(), [this](const comms_fates_t& fates) { TakeFates(fates); });
}

void NetsimManagerApp::Open() {
  const TcpServerOptions server = {
      .address = options_.address,
      .port = options_.port,
      .max_connections = options_.max_connections,
      .idle_timeout_us = static_cast<int64_t>(options_.idle_timeout_s * 1e6),
      .silence_us = kSilence_us};
  auto lines = LineServer::Listen(
      server, static_cast<size_t>(options_.max_line_bytes),
      [this](const std::string& address, std::string_view line) { return OnLine(address, line); });
  if (!lines.ok()) {
    fault_ = lines.error();
    return;
  }
  lines_ = std::move(*lines);
  Await(lines_->fd());
  for (OutsideVehicle& outsider : outsiders_) {
    if (!Take(&outsider)) return;
  }
}

/// Opens the ports of one vehicle; false and a fault where that cannot be.
bool NetsimManagerApp::Take(OutsideVehicle* outsider) {
  const auto on_event = [this](const std::string& text) { Event(text); };
  const auto opened = OpenPorts(mission_, options_.address, on_event, outsider);
  if (!opened.ok()) {
    fault_ = opened.error();
    return false;
  }
  if (outsider->modem) Await(outsider->modem->fd());
  if (outsider->gps && outsider->gps->fd() >= 0) Await(outsider->gps->fd());
  return fault_.empty();
}

void NetsimManagerApp::Event(const std::string& text) {
  log_.Event(utime_.value_or(mission_.start_utime), text);
}

void NetsimManagerApp::Await(int fd) {
  if (!served_.Add(fd)) fault_ = "too many open files: raise `ulimit -n`";
}

int NetsimManagerApp::ModemPortOf(std::string_view vehicle) const {
  for (const OutsideVehicle& outsider : outsiders_) {
    if (outsider.options.name == vehicle && outsider.modem) return outsider.modem->port();
  }
  return 0;
}

int NetsimManagerApp::GpsPortOf(std::string_view vehicle) const {
  for (const OutsideVehicle& outsider : outsiders_) {
    if (outsider.options.name == vehicle && outsider.gps) return outsider.gps->port();
  }
  return 0;
}

std::string NetsimManagerApp::OnLine(const std::string& address, std::string_view line) {
  const NetsimReply reply = AnswerLine(line, address, options_);
  counts_.Add(reply.outcome);
  if (!reply.problem.empty()) {
    Event(fmt::format("{}: {}", Printable(address), Printable(reply.problem, kLongestSentence)));
  }
  for (const NetsimPosition& position : reply.positions) TakePosition(position);
  for (const NetsimReceiveStats& stats : reply.stats) TakeStats(stats);
  return reply.answer;
}

void NetsimManagerApp::TakePosition(const NetsimPosition& position) {
  for (OutsideVehicle& outsider : outsiders_) {
    if (outsider.options.name != position.vehicle) continue;
    outsider.nav = position.nav;
    outsider.nav_is_new = true;
    ++outsider.num_navs;
    if (!outsider.gps) continue;
    outsider.gps->Write(GprmcSentence(position.nav, utc_us_));
    ++outsider.num_sentences;
  }
}

void NetsimManagerApp::TakeStats(const NetsimReceiveStats& stats) {
  ++num_stats_;
  for (OutsideVehicle& outsider : outsiders_) {
    if (outsider.options.modem_tcp_port == stats.modem_tcp_port) outsider.stats = stats;
  }
  if (stats_.size() >= kMaxStatsPerStep) {
    log_.Warn("receive statistics: more than 1000 in a step; further ones are not published");
    return;
  }
  modem_stats_t published{};
  published.receiver = NameOfPort(stats.modem_tcp_port);
  published.sender = NameOfPort(stats.tx_modem_tcp_port);
  published.is_good = stats.packet_success ? 1 : 0;
  if (stats.modem) {
    published.has_modem = 1;
    published.mode = stats.modem->mode;
    published.rate = stats.modem->rate;
    published.source = stats.modem->source;
    published.destination = stats.modem->destination;
    published.num_frames = stats.modem->num_frames;
    published.num_bad_frames = stats.modem->num_bad_frames;
    published.snr_in_db = stats.modem->snr_in_db;
    published.snr_out_db = stats.modem->snr_out_db;
    published.mse_equalizer_db = stats.modem->mse_equalizer_db;
  }
  stats_.push_back(published);
}

std::string NetsimManagerApp::NameOfPort(int32_t port) const {
  for (const OutsideVehicle& outsider : outsiders_) {
    if (outsider.options.modem_tcp_port == port) return outsider.options.name;
  }
  return fmt::format("port {}", port);
}

void NetsimManagerApp::TakeFates(const comms_fates_t& fates) {
  for (const fate_t& fate : fates.fates) {
    if (fate.kind != KindText(Kind::kPacket) || fate.path.empty()) continue;
    const bool is_ours = std::any_of(
        outsiders_.begin(), outsiders_.end(),
        [&](const OutsideVehicle& outsider) { return outsider.options.name == fate.destination; });
    if (is_ours) paths_[{fate.destination, fate.source, fate.number}] = fate.path[0];
  }
}

void NetsimManagerApp::Tick(int64_t utime) {
  utime_ = utime;
  tick_wall_us_.reset();
  mission_us_ = std::max(mission_us_, utime - mission_.start_utime);
  for (OutsideVehicle& outsider : outsiders_) {
    PassReceived(&outsider, mission_us_);
    if (outsider.modem) {
      for (ModemTransmission& sent : outsider.modem->TakeTransmissions(mission_us_)) {
        modem_tx_t packet{};
        packet.utime = utime;
        packet.source = outsider.options.name;
        packet.data_rate_bps = sent.data_rate_bps;
        packet.num_bytes = static_cast<int32_t>(sent.bytes.size());
        packet.payload = std::move(sent.bytes);
        Publish(bus_, channels::ModemTx(), packet);
      }
    }
    if (std::exchange(outsider.nav_is_new, false)) Report(&outsider, utime);
  }
  for (modem_stats_t& stats : std::exchange(stats_, {})) {
    stats.utime = utime;
    Publish(bus_, channels::ModemStats(), stats);
  }
  paths_.clear();
}

void NetsimManagerApp::PassReceived(OutsideVehicle* outsider, int64_t mission_us) {
  const AcousticOptions& acoustics = mission_.acoustics.options;
  for (acoustic_rx_t& packet : std::exchange(outsider->received, {})) {
    const size_t on_air_bytes =
        packet.payload.size() + (mission_.acoustics.crc ? kPacketCrcBytes : 0);
    const auto path = paths_.find(std::tuple(outsider->options.name, packet.source, packet.number));
    double air_s = acoustics.data_rate_bps > 0
                       ? 8 * static_cast<double>(on_air_bytes) / acoustics.data_rate_bps
                       : 0;
    // A modem's packet has a rate of its own.
    if (path != paths_.end() && path->second.air_s > 0) air_s = path->second.air_s;
    if (path == paths_.end() && outsider->options.modem != NetsimModem::kRaw) {
      Event(
          fmt::format("{}: packet {} of {} has no fate in COMMS_FATES: its times assume {:g} "
                      "bit/s, and its SNR is not known",
                      outsider->options.name, packet.number, Printable(packet.source),
                      acoustics.data_rate_bps));
    }
    const bool is_sound = IsMissionTime(packet.arrived_utime) && IsMissionTime(packet.sent_utime);
    if (!is_sound) {
      log_.Warn("ACOUSTIC_RX with times that cannot be: ignored");
      continue;
    }
    const int64_t start_utime = packet.arrived_utime - Microseconds(air_s);
    ModemPacket arrival{.bytes = std::move(packet.payload),
                        .start_us = start_utime - mission_.start_utime,
                        .travel_us = std::max<int64_t>(start_utime - packet.sent_utime, 0),
                        .snr_db = std::nullopt};
    if (path != paths_.end() && path->second.snr_db > kNoSnr_db) {
      arrival.snr_db = path->second.snr_db;
    }
    outsider->modem->Receive(arrival, mission_us);
  }
}

void NetsimManagerApp::Report(OutsideVehicle* outsider, int64_t utime) {
  const NetsimNav& nav = *outsider->nav;
  const auto local_m = frame_.ToLocal({.lat_deg = nav.lat_deg, .lon_deg = nav.lon_deg});
  if (!local_m) {
    log_.Warn(fmt::format("{} is more than {:g} km from the mission's origin: not published",
                          outsider->options.name, LocalFrame::kReach_m / 1000));
    return;
  }
  const node_report_t report = ReportOf(*outsider, *local_m, utime);
  ++outsider->num_reports;
  outsider->nav_utime = utime;
  Publish(bus_, channels::NodeReportFromOutside(), report);
}

int64_t NetsimManagerApp::MissionTime_us(int64_t wall_us) {
  if (!utime_) return 0;
  if (!tick_wall_us_) tick_wall_us_ = wall_us;
  const double elapsed_us = static_cast<double>(wall_us - *tick_wall_us_) * warp_;
  const int64_t since_tick_us = std::clamp<int64_t>(std::llround(elapsed_us), 0, mission_.tick_us);
  mission_us_ = std::max(mission_us_, *utime_ - mission_.start_utime + since_tick_us);
  return mission_us_;
}

void NetsimManagerApp::Serve(int64_t now_us, int64_t utc_us) {
  if (!fault_.empty()) return;
  utc_us_ = utc_us;
  const int64_t mission_us = MissionTime_us(now_us);
  lines_->Serve(now_us);
  if (utime_) WatchClocks(mission_us);
  for (OutsideVehicle& outsider : outsiders_) {
    if (outsider.modem) outsider.modem->Serve(now_us, mission_us);
    if (outsider.gps) outsider.gps->Serve(now_us);
  }
}

void NetsimManagerApp::WatchClocks(int64_t mission_us) {
  if (!utc_at_zero_us_) {
    utc_at_zero_us_ = utc_us_ - mission_us;
    for (OutsideVehicle& outsider : outsiders_) {
      if (outsider.modem) outsider.modem->SetClock(utc_us_, mission_us);
    }
  }
  // At another warp the mission's time is not meant to be the wall's.
  if (warp_ != 1 || has_lagged_ || !HasMicroModem() || Lag_us() <= kMaxLag_us) return;
  has_lagged_ = true;
  log_.Warn(
      "the clocks of Micro-Modems fell more than 0.5 s behind this machine's, since the mission "
      "was "
      "paused or the machine stalled: hosts set them right with CCCLK or CCTMS");
}

bool NetsimManagerApp::HasMicroModem() const {
  return std::any_of(outsiders_.begin(), outsiders_.end(), [](const OutsideVehicle& outsider) {
    return outsider.modem && outsider.options.modem != NetsimModem::kRaw;
  });
}

StatusPage NetsimManagerApp::Status() const {
  StatusPage page;
  page.text =
      fmt::format("Configuration:\n    Listens on {}:{}, {} vehicles, warp {}\n", options_.address,
                  port(), outsiders_.size(), options_.allow_warp ? "allowed" : "1 only");
  if (lines_) {
    const TcpServerCounts& counts = lines_->counts();
    page.text += fmt::format(
        "Clients: {} now, {} so far, {} refused, {} broken off, {} idle, {} stalled, {} "
        "silent and closed for others\n",
        lines_->num_clients(), counts.accepted, counts.refused, counts.broken, counts.idle,
        counts.stalled, counts.displaced);
    page.text += fmt::format("Lines ({} too long):\n", lines_->num_too_long());
  }
  for (size_t i = 0; i < kNumNetsimOutcomes; ++i) {
    const auto outcome = static_cast<NetsimOutcome>(i);
    if (counts_.Of(outcome) == 0) continue;
    page.text += fmt::format("    {}: {}\n", Word(outcome), counts_.Of(outcome));
  }
  page.text += fmt::format("Receive statistics: {}\n", num_stats_);
  if (HasMicroModem()) {
    const double lag_s = Seconds(Lag_us());
    page.text += fmt::format(
        "Clocks of Micro-Modems: {:.1f} s {} this machine's, where no host has set them since the "
        "start\n",
        std::abs(lag_s), lag_s > -0.05 ? "behind" : "ahead of");
  }
  page.text += "Vehicles:\n";
  for (const OutsideVehicle& outsider : outsiders_) {
    const int32_t sender = outsider.stats ? outsider.stats->tx_modem_tcp_port : 0;
    page.text += TextOf(outsider, utime_.value_or(0), NameOfPort(sender));
  }
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
