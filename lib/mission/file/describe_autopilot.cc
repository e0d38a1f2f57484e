// The table [vehicle.autopilot], whose keys depend on the vehicle's model.
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <variant>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/mission/file/describe.h"
#include "lib/vehicle/control/named_pilots.h"

namespace shoal {
namespace {

constexpr std::array<std::string_view, 10> kRemus100Keys = {
    "gains",    "heading_observer_hz", "pitch_kp",   "pitch_ki", "pitch_kd", "heave_kd", "depth_kp",
    "depth_ki", "max_pitch_deg",       "max_fin_deg"};
constexpr std::array<std::string_view, 4> kSurfaceCraftKeys = {
    "heading_integral_limit_deg", "speed_kp", "speed_ki", "speed_integral_limit_pct"};

/// What to write instead of a key of the other model.
std::string InsteadOf(std::string_view key) {
  if (key == "heading_integral_limit_deg") return "max_fin_deg limits the whole deflection";
  if (key.starts_with("speed_")) return "its propeller turns as propeller_rpm or speed_mps take";
  return "";
}

void DescribeGains(Fields& fields, AutopilotOptions& options) {
  for (const std::string_view key : kRemus100Keys) {
    fields.NoKey(key,
                 "a key of model = \"remus100\", and this is a surface craft: write that "
                 "model, or leave it out");
  }
  const NumberLimits gain = Between(0, 1000);
  fields.Number("heading_kp", options.heading_kp, gain);
  fields.Number("heading_ki", options.heading_ki, gain);
  fields.Number("heading_kd", options.heading_kd, gain);
  fields.Number("heading_integral_limit_deg", options.heading_integral_limit_deg, Between(0, 180));
  fields.Number("speed_kp", options.speed_kp, gain);
  fields.Number("speed_ki", options.speed_ki, gain);
  fields.Number("speed_integral_limit_pct", options.speed_integral_limit_pct, Between(0, 100));
}

void DescribeGains(Fields& fields, Remus100Gains& gains) {
  for (const std::string_view key : kSurfaceCraftKeys) {
    fields.NoKey(key,
                 "a key of surface craft, and this is a remus100: leave it out; " + InsteadOf(key));
  }
  constexpr std::array<std::string_view, 3> kSets = {"default", "munet", "fossen"};
  fields.Word("gains", gains.gains, kSets);
  if (fields.reading()) gains = Remus100GainsNamed(gains.gains);
  const NumberLimits gain = Between(0, 1000);
  fields.Number("heading_kp", gains.heading_kp, gain);
  fields.Number("heading_ki", gains.heading_ki, gain);
  fields.Number("heading_kd", gains.heading_kd, gain);
  fields.Number("heading_observer_hz", gains.heading_observer_hz, Above(0, 100));
  fields.Number("pitch_kp", gains.pitch_kp, gain);
  fields.Number("pitch_ki", gains.pitch_ki, gain);
  fields.Number("pitch_kd", gains.pitch_kd, gain);
  fields.Number("heave_kd", gains.heave_kd, gain);
  if (gains.heave_kd > 0 && gains.pitch_kd == 0) {
    fields.Refuse("heave_kd", "heave_kd is damping beside pitch_kd: write pitch_kd = 0.1 or more");
  }
  fields.Number("depth_kp", gains.depth_kp, gain);
  fields.Number("depth_ki", gains.depth_ki, gain);
  fields.Number("max_pitch_deg", gains.max_pitch_deg, Above(0, 80));
  fields.Number("max_fin_deg", gains.max_fin_deg, Above(0, 80));
}

/// One line for each model of AnyModel.
struct AutopilotOfModel {
  Fields& fields;
  Vehicle& vehicle;

  void operator()(const SurfaceCraftParams& /*craft*/) const {
    DescribeGains(fields, vehicle.autopilot);
  }
  void operator()(Remus100Options& options) const {
    Remus100Gains gains = GainsOf(options);
    DescribeGains(fields, gains);
    if (!fields.reading()) return;
    options.autopilot.reset();
    if (gains != GainsOf(options)) options.autopilot = gains;
  }
  /// It is moored.
  void operator()(const BuoyParams& /*buoy*/) const {}
  /// It goes where its file has it.
  void operator()(const TrackOptions& /*track*/) const {}
};

/// As a file writes 15 degrees.
double WrittenDegrees(double angle_rad) { return std::round(RadToDeg(angle_rad) * 1e9) / 1e9; }

}  // namespace

void DescribeAutopilot(Fields& fields, Vehicle& vehicle) {
  std::visit(AutopilotOfModel{fields, vehicle}, vehicle.model);
}

Remus100Gains Remus100GainsNamed(std::string_view name) {
  const std::optional<AuvPilotParams> pilot = RemusPilotByName(name);
  SHOAL_CHECK(pilot.has_value(), "a set of gains that exists");
  return {.gains = std::string(name),
          .heading_kp = std::abs(pilot->heading.kp),
          .heading_ki = std::abs(pilot->heading.ki),
          .heading_kd = std::abs(pilot->heading.kd),
          .heading_observer_hz = pilot->heading_observer_hz,
          .pitch_kp = std::abs(pilot->pitch.kp),
          .pitch_ki = std::abs(pilot->pitch.ki),
          .pitch_kd = std::abs(pilot->pitch.kd),
          .heave_kd = name == "fossen" ? kFossenHeaveGain : 0,
          .depth_kp = pilot->depth.kp,
          .depth_ki = pilot->depth.ki,
          .max_pitch_deg = WrittenDegrees(pilot->depth.max_pitch_rad),
          .max_fin_deg = WrittenDegrees(pilot->heading.max_output_rad)};
}

Remus100Gains GainsOf(const Remus100Options& options) {
  if (options.autopilot) return *options.autopilot;
  return Remus100GainsNamed(options.parameters == "munet" ? "munet" : "default");
}

}  // namespace shoal
