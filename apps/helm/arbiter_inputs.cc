#include "apps/helm/arbiter_inputs.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

constexpr size_t kMaxSettings = 1000;
constexpr char kManySettings[] = "more than 1000 settings of variables in one decision: dropped";
constexpr char kUncertaintyVariable[] = "NAV_UNCERTAINTY_M";
constexpr char kFixVariable[] = "GPS_UPDATE_RECEIVED";  // Of periodic_surface.

}  // namespace

ArbiterInputs::ArbiterInputs(const Vehicle& vehicle)
    : is_used_(!vehicle.behaviors.empty()), ledger_(vehicle.name) {}

void ArbiterInputs::OnNodeReport(const node_report_t& report, int64_t utime) {
  if (!is_used_) return;
  Take({.name = report.name,
        .group = report.group,
        .type = report.type,
        .motion = {.position_m = {report.x_m, report.y_m},
                   .heading_deg = report.heading_deg,
                   .speed_mps = report.speed_mps},
        .depth_m = report.depth_m,
        .length_m = report.length_m,
        .made_s = Seconds(report.utime),
        .received_s = Seconds(utime),
        .source = ContactSource::kNodeReport});
}

void ArbiterInputs::OnSwarm(const swarm_t& swarm, int64_t utime) {
  if (!is_used_) return;
  for (const swarm_contact_t& contact : swarm.contacts) {
    if (!contact.is_known || !contact.is_heard) continue;
    const Eigen::Vector2d velocity_mps(contact.x_mps, contact.y_mps);
    Take({.name = contact.name,
          .motion = {.position_m = {contact.x_m, contact.y_m},
                     .heading_deg = RadToDeg(HeadingOf(velocity_mps)),
                     .speed_mps = velocity_mps.norm()},
          .depth_m = contact.z_m,
          .made_s = Seconds(contact.report_utime),
          .received_s = Seconds(utime),
          .source = ContactSource::kSwarm});
  }
}

void ArbiterInputs::OnSonar(const sonar_t& ping, const nav_t& own, int64_t utime) {
  if (!is_used_) return;
  const sonar_beam_t* nearest = nullptr;
  for (const sonar_beam_t& beam : ping.beams) {
    const bool is_echo = beam.range_m >= 0 && std::isfinite(beam.range_m) &&
                         std::isfinite(beam.azimuth_deg) && std::isfinite(beam.elevation_deg);
    if (is_echo && (nearest == nullptr || beam.range_m < nearest->range_m)) nearest = &beam;
  }
  if (nearest == nullptr) return;
  const double bearing_rad = DegToRad(own.heading_deg + nearest->azimuth_deg);
  const double distance_m = nearest->range_m * Cos(DegToRad(nearest->elevation_deg));
  Take({.name = "sonar",
        .type = "echo",
        .motion = {.position_m = Eigen::Vector2d(own.x_m, own.y_m) +
                                 distance_m * UnitVector(WrapTwoPi(bearing_rad))},
        .depth_m = own.z_m,
        .made_s = Seconds(ping.utime),
        .received_s = Seconds(utime),
        .source = ContactSource::kSonar});
}

void ArbiterInputs::OnNavigation(const navigation_t& navigation) {
  if (!is_used_) return;
  Set({.variable = kUncertaintyVariable, .value = navigation.ellipse_major_m}, "navigation");
  if (navigation.num_gps > num_gps_) {
    Set({.variable = kFixVariable, .value = static_cast<double>(navigation.num_gps)}, "navigation");
  }
  num_gps_ = navigation.num_gps;
}

void ArbiterInputs::OnNodeMessage(const node_message_t& message) {
  if (!is_used_) return;
  VariablePost setting{.variable = message.var_name, .value = message.string_val};
  if (message.is_double != 0) setting.value = message.double_val;
  Set(setting, message.src_node);
}

void ArbiterInputs::Set(const VariablePost& setting, std::string_view source) {
  if (!is_used_) return;
  if (settings_.size() >= kMaxSettings) {
    warnings_.emplace_back(kManySettings);
    return;
  }
  settings_.push_back(
      {.variable = setting.variable, .value = setting.value, .source = std::string(source)});
}

void ArbiterInputs::Take(const ContactReport& report) {
  const ContactIntake intake = ledger_.Take(report, own_position_m_);
  // Sonar echoes jump from one obstacle to the next; what comes late or from afar is not a fault.
  const bool is_usual = intake == ContactIntake::kTaken || intake == ContactIntake::kTooOld ||
                        intake == ContactIntake::kOutOfOrder || intake == ContactIntake::kTooFar ||
                        (intake == ContactIntake::kJumped && report.name == "sonar");
  if (!is_usual) {
    warnings_.push_back(fmt::format("contact {}: {}", Printable(report.name), TextOf(intake)));
  }
}

std::vector<ReceivedSetting> ArbiterInputs::TakeSettings() { return std::exchange(settings_, {}); }

const Contacts& ArbiterInputs::ContactsAt(double time_s,
                                          const std::optional<Eigen::Vector2d>& own_position_m) {
  if (own_position_m) own_position_m_ = *own_position_m;
  return ledger_.At(time_s, own_position_m_);
}

std::vector<std::string> ArbiterInputs::TakeWarnings() { return std::exchange(warnings_, {}); }

}  // namespace shoal
