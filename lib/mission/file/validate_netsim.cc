// Whether the vehicles of [netsim] come from outside, and whether its table holds together.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geodesy/local_frame.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/swarm_plan.h"
#include "lib/mission/netsim/netsim_options.h"
#include "lib/mission/toml/suggest.h"
#include "lib/sea/acoustics/loss_models.h"
#include "lib/sea/modem/micromodem_rate.h"

namespace shoal {
namespace {

void CheckNetsimVehicle(const NetsimVehicle& vehicle, const Mission& mission,
                        const TablePlace& place) {
  const Vehicle* simulated = mission.FindVehicle(vehicle.name);
  const bool is_elsewhere = simulated == nullptr || (simulated->sim == Provider::kNone &&
                                                     simulated->reporter == Provider::kNone);
  if (!is_elsewhere) {
    place.Refuse("name",
                 fmt::format("shoal simulates {} itself: write outside = true in its [[vehicle]]",
                             vehicle.name));
  }
  if (vehicle.modem != NetsimModem::kNone && !PacketAcousticsOf(mission).is_used) {
    place.Refuse("modem",
                 "a modem sends over an acoustic network: write [acoustics] as well, or name a "
                 "[[medium]] of kind = \"acoustic\" in [swarm] over");
  }
}

void CheckModemAddress(const NetsimVehicle& vehicle, const Mission& mission,
                       const TablePlace& file) {
  if (vehicle.modem != NetsimModem::kMicromodem && vehicle.modem != NetsimModem::kMicromodem2) {
    return;
  }
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& simulated = mission.vehicles[i];
    const bool is_it = &simulated == mission.FindVehicle(vehicle.name);
    if (!is_it || simulated.acoustic_address <= kMaxMicroModemAddress) continue;
    file.Below("vehicle", i)
        .Refuse("acoustic_address",
                fmt::format("acoustic_address = {} of {}: a Micro-Modem's address is 1 to {}; "
                            "choose one of these (the default is the vehicle's place in the "
                            "mission)",
                            simulated.acoustic_address, vehicle.name, kMaxMicroModemAddress));
  }
}

/// Returns true where every position of an environment is within the plane's reach. The farthest of
/// a parallel is one of its ends, or the meridian opposite of the origin; the farthest of a
/// meridian is one of its ends.
bool IsWithinReach(const NetsimEnvironment& environment, const Mission& mission) {
  const LocalFrame frame({.lat_deg = mission.origin_lat_deg, .lon_deg = mission.origin_lon_deg});
  std::vector<double> lons_deg = {environment.lon_min_deg, environment.lon_max_deg};
  for (const int turn : {-3, -1, 1, 3}) {
    const double opposite_deg = mission.origin_lon_deg + 180 * turn;
    const bool is_inside =
        opposite_deg > environment.lon_min_deg && opposite_deg < environment.lon_max_deg;
    if (is_inside) lons_deg.push_back(opposite_deg);
  }
  for (const double lat_deg : {environment.lat_min_deg, environment.lat_max_deg}) {
    for (const double lon_deg : lons_deg) {
      const GeoPoint corner = {.lat_deg = lat_deg, .lon_deg = std::remainder(lon_deg, 360)};
      if (!frame.ToLocal(corner)) return false;
    }
  }
  return true;
}

void CheckReach(const NetsimEnvironment& environment, const Mission& mission,
                const TablePlace& place) {
  if (IsWithinReach(environment, mission)) return;
  place.Refuse("name", fmt::format("environment {} lies in part more than {:g} km from the "
                                   "mission's origin ({:.4f}, {:.4f}), where positions cannot be "
                                   "used: move origin in [mission], or the bounds",
                                   Quoted(environment.name), LocalFrame::kReach_m / 1000,
                                   mission.origin_lat_deg, mission.origin_lon_deg));
}

/// Where the file has the network that modems send over.
TablePlace PlaceOf(const Acoustics& acoustics, const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.media.size(); ++i) {
    if (&mission.media[i].acoustics == &acoustics) return file.Below("medium", i);
  }
  return file.Below("acoustics");
}

/// Warns where models other than a modem's damage nearly every packet, and all that is damaged is
/// thrown away.
void WarnOfBitErrors(const Mission& mission, const TablePlace& file) {
  constexpr int kShort_bytes = 47;   // A Micro-Modem's packet of rate 0, with 32 bytes of data.
  constexpr int kLong_bytes = 2105;  // And one of rate 5, with 8 frames of 256.
  constexpr double kFewest = 0.9;    // Of short packets that a user expects to arrive.
  const Acoustics& acoustics = PacketAcousticsOf(mission);
  const AcousticOptions& options = acoustics.options;
  const bool is_of_formula = options.bit_error_model != BitErrorModel::kOff &&
                             options.bit_error_model != BitErrorModel::kModem;
  if (!acoustics.crc || !is_of_formula) return;
  const double wrong = BitErrorProbability(options, options.nominal_distance_m);
  const auto share = [&](int num_bytes) { return Pow(1 - wrong, 8.0 * (num_bytes + 4)); };
  if (share(kShort_bytes) >= kFewest) return;
  PlaceOf(acoustics, mission, file)
      .Warn("bit_error_model",
            fmt::format(
                "of a modem's packets of {} bytes {:.0f} % arrive whole at {:g} m, of those "
                "of {} bytes {:.0f} %: {} flips one bit of {:.0f}, and crc = true throws "
                "damaged packets away. Leave the models out, for those of a modem "
                "(docs/communication/acoustic_network.md)",
                kShort_bytes, 100 * share(kShort_bytes), options.nominal_distance_m, kLong_bytes,
                100 * share(kLong_bytes), ChoiceText(options.bit_error_model), 1 / wrong));
}

/// Warns where programs of the mission would answer a modem, and the default range stops what they
/// send.
void WarnOfRange(const Mission& mission, const TablePlace& file) {
  if (file.Has("comms") && file.Below("comms").Has("comms_range")) return;
  const bool has_others =
      !mission.participants.empty() ||
      std::ranges::any_of(mission.vehicles, [](const Vehicle& each) { return !each.is_outside; });
  if (!has_others) return;
  file.Below("netsim").Warn(
      "",
      fmt::format("comms_range is the default, {:g} m: reports, and packets that programs of the "
                  "mission send on ACOUSTIC_TX, are received nearer than that only, while what "
                  "a modem sends has no range rule; write comms_range in [comms]",
                  mission.comms.comms_range_m));
}

/// `where`: as FindNetsimProblems names a table.
void RefuseAt(const TablePlace& place, std::string_view where,
              const std::vector<NetsimProblem>& problems) {
  for (const NetsimProblem& problem : problems) {
    if (problem.where != where) continue;
    const std::string key = problem.key == "gps_tcp_port" ? "gps" : problem.key;
    place.Refuse(key, problem.key + " " + problem.message);
  }
}

}  // namespace

void ValidateNetsim(const Mission& mission, const TablePlace& file) {
  if (!mission.netsim) return;
  const NetsimOptions& options = *mission.netsim;
  const TablePlace netsim = file.Below("netsim");
  bool has_modem = false;
  for (size_t i = 0; i < options.vehicles.size(); ++i) {
    CheckNetsimVehicle(options.vehicles[i], mission, netsim.Below("vehicle", i));
    CheckModemAddress(options.vehicles[i], mission, file);
    has_modem = has_modem || options.vehicles[i].modem != NetsimModem::kNone;
  }
  const Acoustics& acoustics = PacketAcousticsOf(mission);
  const bool is_written = &acoustics != &mission.acoustics || file.Has("acoustics");
  if (has_modem && is_written && PlaceOf(acoustics, mission, file).IsSound()) {
    WarnOfBitErrors(mission, file);
    WarnOfRange(mission, file);
  }
  if (!netsim.IsSound()) return;
  for (size_t i = 0; i < options.environments.size(); ++i) {
    CheckReach(options.environments[i], mission, netsim.Below("environment", i));
  }
  const std::vector<NetsimProblem> problems = FindNetsimProblems(options);
  RefuseAt(netsim, "netsim", problems);
  for (size_t i = 0; i < options.environments.size(); ++i) {
    RefuseAt(netsim.Below("environment", i),
             fmt::format("netsim.environment '{}'", options.environments[i].name), problems);
  }
  for (size_t i = 0; i < options.vehicles.size(); ++i) {
    RefuseAt(netsim.Below("vehicle", i),
             fmt::format("netsim.vehicle '{}'", options.vehicles[i].name), problems);
  }
}

}  // namespace shoal
