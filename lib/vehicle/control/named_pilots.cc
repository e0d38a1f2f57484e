#include "lib/vehicle/control/named_pilots.h"

#include "lib/base/geometry/angles.h"

namespace shoal {

AuvPilotParams FossenRemusPilot() {
  constexpr double kLambda = 0.1;
  constexpr double kTime_s = 1;
  constexpr double kNomotoGain = 5.0 / 20;
  constexpr double kSigma = 0.5 + 0.05 / 0.1;
  constexpr double kDepth = 0.1;
  constexpr double kDepthTime_s = 100;
  const double max_fin_rad = DegToRad(15);
  return {
      .heading = {.kp = -(kTime_s * kLambda * kLambda + 2 * kLambda * (1 + kSigma)) / kNomotoGain,
                  .ki = -kLambda * kLambda * (1 + kSigma) / kNomotoGain,
                  .kd = -(2 * kLambda * kTime_s + kSigma) / kNomotoGain,
                  .max_output_rad = max_fin_rad},
      .pitch = {.kp = 5, .ki = 0.3, .kd = 2, .max_output_rad = max_fin_rad},
      .depth = {.kp = kDepth, .ki = kDepth / kDepthTime_s, .max_pitch_rad = DegToRad(30)}};
}

std::optional<AuvPilotParams> RemusPilotByName(std::string_view name) {
  if (name == "default") return DefaultRemusPilot();
  if (name == "munet") return MunetRemusPilot();
  if (name == "fossen") return FossenRemusPilot();
  return std::nullopt;
}

}  // namespace shoal
