// Warns of gains that cannot steer a Remus 100 at the mission's ticks, or not with its parameters.
// docs/vehicles/vehicles.md has the measurements.
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <variant>

#include "lib/base/time/seconds.h"
#include "lib/mission/file/validate.h"

namespace shoal {
namespace {

/// At longer ticks, muNet's and Fossen's laws swing their fins from stop to stop at full
/// revolutions: at twice that at 1525 rpm, at five times that at 1200 rpm.
constexpr int64_t kLongestStiffTick_us = 20'000;

std::string TickText(int64_t tick_us, std::string_view fin, double swing_deg) {
  return fmt::format(
      "in ticks of {:g} s these gains swing the {} by up to {:g} degrees: write tick_s = 0.02 in "
      "[mission]",
      Seconds(tick_us), fin, swing_deg);
}

void WarnOfGains(const TablePlace& place, const Remus100Options& options, int64_t tick_us) {
  const Remus100Gains gains = GainsOf(options);
  const Remus100Gains named = Remus100GainsNamed(gains.gains);
  const TablePlace table = place.Below("autopilot");
  const bool is_long = tick_us > kLongestStiffTick_us;
  if (gains.gains == "munet" && gains.heading_kd == named.heading_kd && is_long) {
    table.Warn("gains", TickText(tick_us, "rudder", gains.max_fin_deg) +
                            ", or heading_kp = 2, heading_ki = 0.1, heading_kd = 4 in "
                            "[vehicle.autopilot]");
  }
  if (gains.gains != "fossen" || gains.pitch_kp != named.pitch_kp) return;
  if (options.parameters == "munet") {
    table.Warn("gains",
               fmt::format("these gains swing the stern plane of parameters = \"munet\" by {:g} "
                           "degrees, as its fins take 1 s: write gains = \"munet\"",
                           gains.max_fin_deg));
  } else if (is_long) {
    table.Warn("gains", TickText(tick_us, "stern plane", gains.max_fin_deg) +
                            ", or gains = \"default\" in [vehicle.autopilot]");
  }
}

}  // namespace

void WarnOfAutopilots(const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const auto* options = std::get_if<Remus100Options>(&mission.vehicles[i].model);
    if (options != nullptr) WarnOfGains(file.Below("vehicle", i), *options, mission.tick_us);
  }
}

}  // namespace shoal
