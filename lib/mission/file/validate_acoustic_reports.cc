// Node reports over the acoustic network: whether packets hold them, and whether they collide.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/mission/file/validate.h"

namespace shoal {
namespace {

/// How often a vehicle may report: the shortest time between two reports.
double ReportInterval_s(const ReporterOptions& reporter) {
  return std::max(1 / reporter.rate_hz,
                  reporter.blackout_interval_s - reporter.blackout_variance_s);
}

bool SendOnOneChannel(AccessMode mode, const Vehicle& a, const Vehicle& b) {
  if (mode == AccessMode::kTdmaLf) return a.acoustic_leader == b.acoustic_leader;
  return mode != AccessMode::kFdma;
}

/// Node_reporters of one rate begin together and stay together, unless chance parts them. Returns
/// the first two vehicles whose reports collide so; two null pointers where none do.
std::pair<const Vehicle*, const Vehicle*> FindReportsInStep(const Mission& mission) {
  const AcousticOptions& options = mission.acoustics.options;
  // It takes a third node to receive two that collide.
  const bool may_collide =
      options.collisions != CollisionModel::kOff && mission.vehicles.size() > 2;
  std::map<double, std::vector<const Vehicle*>> by_interval;
  for (const Vehicle& vehicle : mission.vehicles) {
    const ReporterOptions& reporter = vehicle.reporter_options;
    // What chance adds is rounded up to the reporter's own pace.
    const bool has_clockwork = vehicle.HasMedium(kAcousticMedium) &&
                               vehicle.reporter == Provider::kShoal && !reporter.extrapolate &&
                               reporter.blackout_variance_s < 1 / reporter.rate_hz;
    if (!has_clockwork) continue;
    std::vector<const Vehicle*>& others = by_interval[ReportInterval_s(reporter)];
    for (const Vehicle* other : others) {
      if (options.half_duplex ||
          (may_collide && SendOnOneChannel(options.access_mode, *other, vehicle))) {
        return {other, &vehicle};
      }
    }
    const bool is_new_role = std::ranges::none_of(others, [&](const Vehicle* other) {
      return other->acoustic_leader == vehicle.acoustic_leader;
    });
    if (is_new_role) others.push_back(&vehicle);  // One of each role stands for the rest.
  }
  return {};
}

/// A client of netsim chooses how often it sends positions, and of each step the last becomes a
/// node report: warns where these would take half of the channel's time.
void WarnOfOutsiders(const Mission& mission, const TablePlace& comms, double air_s) {
  constexpr double kMaxOfChannel = 0.5;
  if (!mission.netsim || mission.netsim->vehicles.empty()) return;
  const auto num_vehicles = static_cast<double>(mission.netsim->vehicles.size());
  const double tick_s = Seconds(mission.tick_us);
  const double least_s = num_vehicles * air_s / kMaxOfChannel;
  if (tick_s >= least_s) return;
  comms.Warn(
      "reports_over",
      fmt::format("each position that {} sends over netsim's interface becomes a node report, at "
                  "most one every {:g} s, which takes {:g} s at {:g} bit/s: reports fill the "
                  "network; write reports_over = \"direct\" (what modems and messages_over = "
                  "\"acoustic\" send stays acoustic), or let the client send a position every "
                  "{:.2g} s or more seldom",
                  mission.netsim->vehicles.size() == 1
                      ? mission.netsim->vehicles.front().name
                      : fmt::format("each of {} vehicles", mission.netsim->vehicles.size()),
                  tick_s, air_s, mission.acoustics.options.data_rate_bps, least_s));
}

/// Warns where the reports of all that send on one channel take more time than it has.
void WarnOfFullChannel(const Mission& mission, const TablePlace& comms, double air_s) {
  const AccessMode mode = mission.acoustics.options.access_mode;
  if (mode == AccessMode::kFdma) return;
  double load = 0;
  int num_senders = 0;
  for (const Vehicle& vehicle : mission.vehicles) {
    const bool sends_there = mode != AccessMode::kTdmaLf || !vehicle.acoustic_leader;
    const bool is_sender = vehicle.reporter == Provider::kShoal && sends_there &&
                           vehicle.HasMedium(kAcousticMedium) &&
                           vehicle.reporter_options.rate_hz > 0;
    if (!is_sender) continue;
    load += air_s / ReportInterval_s(vehicle.reporter_options);
    ++num_senders;
  }
  if (num_senders < 2 || load <= 1) return;
  comms.Warn("reports_over",
             fmt::format("the reports of {} vehicles take {:.2g} s of each second of the one "
                         "channel that they share, at {:g} bit/s: most will collide; lower "
                         "rate_hz in [vehicle.reporter], raise data_rate_bps, or write "
                         "access_mode = \"fdma\" in [acoustics]",
                         num_senders, load, mission.acoustics.options.data_rate_bps));
}

}  // namespace

void ValidateAcousticReports(const Mission& mission, const TablePlace& file) {
  if (!mission.comms.reports_over.Has(kAcousticMedium)) return;
  const TablePlace comms = file.Below("comms");
  constexpr int64_t kReport_bytes = 37;
  const AcousticOptions& options = mission.acoustics.options;
  if (options.modem && options.modem->max_packet_bytes > 0 &&
      options.modem->max_packet_bytes < kReport_bytes) {
    comms.Refuse("reports_over",
                 fmt::format("a node report takes {} bytes, and a packet of the {} holds {}: "
                             "choose another modem, or reports_over = \"direct\"",
                             kReport_bytes, options.modem->name, options.modem->max_packet_bytes));
    return;
  }
  if (const auto [one, other] = FindReportsInStep(mission); one != nullptr) {
    comms.Warn(
        "reports_over",
        fmt::format(
            "{} and {} report at the same moments, every {:g} s, {}: many will not be received; "
            "write rate_hz = 10, blackout_interval_s = 10 and blackout_variance_s = 8 in "
            "[vehicle.reporter], so that chance parts them{}",
            one->name, other->name, ReportInterval_s(one->reporter_options),
            options.half_duplex ? "and do not receive while they send (half_duplex)"
                                : "and send on one channel",
            options.half_duplex || options.access_mode == AccessMode::kTdmaLf
                ? ""
                : ", or access_mode = \"fdma\" in [acoustics]"));
  }
  if (!(options.data_rate_bps > 0)) return;
  const int64_t frame_bytes = kReport_bytes + (mission.acoustics.crc ? 4 : 0);
  const double air_s = 8 * static_cast<double>(frame_bytes) / options.data_rate_bps;
  const bool can_collide = options.collisions != CollisionModel::kOff;
  if (can_collide || options.half_duplex) WarnOfOutsiders(mission, comms, air_s);
  if (!can_collide) return;
  const double jitter_s = options.jitter == JitterModel::kUniform ? options.max_jitter_s : 0;
  for (const Vehicle& vehicle : mission.vehicles) {
    const double interval_s = ReportInterval_s(vehicle.reporter_options);
    const bool is_sender =
        vehicle.reporter == Provider::kShoal && vehicle.HasMedium(kAcousticMedium);
    if (!is_sender || interval_s >= air_s + jitter_s) continue;
    comms.Warn("reports_over",
               fmt::format("{} may report every {:g} s, and a report of {} bytes takes {:g} s at "
                           "{:g} bit/s, with jitter up to {:g} s: its own reports {}; "
                           "lower rate_hz in [vehicle.reporter], or raise data_rate_bps",
                           vehicle.name, interval_s, frame_bytes, air_s, options.data_rate_bps,
                           air_s + jitter_s,
                           mission.acoustics.queue
                               ? "are more than its modem sends, and some will be thrown away"
                               : "will collide"));
    return;
  }
  WarnOfFullChannel(mission, comms, air_s);
}

}  // namespace shoal
