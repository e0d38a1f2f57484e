#include "lib/helm/behaviors/contact_ledger.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kFarthest_m = 1e7;
constexpr double kFastest_mps = 1e4;
constexpr double kRetireFactor = 1.05;

bool IsFinite(const ContactReport& report) {
  const VesselMotion& motion = report.motion;
  const bool all_finite = motion.position_m.allFinite() && std::isfinite(motion.heading_deg) &&
                          std::isfinite(motion.speed_mps) && std::isfinite(report.depth_m) &&
                          std::isfinite(report.length_m) && std::isfinite(report.made_s) &&
                          std::isfinite(report.received_s);
  return all_finite && motion.position_m.cwiseAbs().maxCoeff() <= kFarthest_m &&
         motion.speed_mps <= kFastest_mps;
}

}  // namespace

bool IsTaken(ContactIntake intake) {
  return intake == ContactIntake::kTaken || intake == ContactIntake::kJumped;
}

std::string_view TextOf(ContactIntake intake) {
  switch (intake) {
    case ContactIntake::kTaken:
      return "taken";
    case ContactIntake::kJumped:
      return "taken, though the contact can not have come there at its speed";
    case ContactIntake::kNoName:
      return "refused: it has no name";
    case ContactIntake::kOwnName:
      return "refused: it has own ship's name";
    case ContactIntake::kNotFinite:
      return "refused: a number is not finite, or out of range";
    case ContactIntake::kTooOld:
      return "refused: it is older than the greatest age of a contact";
    case ContactIntake::kOutOfOrder:
      return "refused: a newer report is known";
    case ContactIntake::kTooFar:
      return "refused: it is beyond the greatest distance of a contact";
  }
  return "";
}

double ExtrapolatedDistance(double speed_mps, double age_s, const ContactLimits& limits) {
  const double steady_s = std::clamp(age_s, 0.0, limits.decay_start_s);
  const double decay_s = limits.decay_end_s - limits.decay_start_s;
  const double decaying_s = std::clamp(age_s - limits.decay_start_s, 0.0, std::max(decay_s, 0.0));
  const double lost_s = decay_s > 0 ? decaying_s * decaying_s / (2 * decay_s) : 0;
  return std::max(0.0, speed_mps) * (steady_s + decaying_s - lost_s);
}

ContactLedger::ContactLedger(std::string own_name, const ContactLimits& limits)
    : own_name_(std::move(own_name)), limits_(limits) {
  SHOAL_CHECK(limits.max_age_s > 0 && limits.decay_start_s >= 0 &&
                  limits.decay_end_s >= limits.decay_start_s && limits.max_contacts >= 0,
              "ages of contacts are in order");
}

ContactView ContactLedger::ViewOf(const Known& known, double now_s) const {
  const ContactReport& report = known.report;
  ContactView view = {.name = report.name,
                      .group = report.group,
                      .type = report.type,
                      .source = report.source,
                      .reported = report.motion,
                      .now = report.motion,
                      .depth_m = report.depth_m,
                      .length_m = report.length_m,
                      .age_s = std::max(0.0, now_s - known.made_s)};
  view.now.position_m += ExtrapolatedDistance(report.motion.speed_mps, view.age_s, limits_) *
                         UnitVector(DegToRad(report.motion.heading_deg));
  return view;
}

bool ContactLedger::HasJumped(const Known& before, const Known& after) const {
  const double passed_s = after.made_s - before.made_s;
  const double speed_mps = std::max(
      {before.report.motion.speed_mps, after.report.motion.speed_mps, limits_.slowest_jump_mps});
  const double moved_m = (after.report.motion.position_m - before.report.motion.position_m).norm();
  return moved_m > limits_.jump_factor * speed_mps * passed_s + limits_.jump_slack_m;
}

ContactIntake ContactLedger::Take(const ContactReport& report,
                                  const Eigen::Vector2d& own_position_m) {
  if (report.name.empty()) return ContactIntake::kNoName;
  if (report.name == own_name_) return ContactIntake::kOwnName;
  if (!IsFinite(report)) return ContactIntake::kNotFinite;
  Known known = {.report = report, .made_s = std::min(report.made_s, report.received_s)};
  known.report.motion.speed_mps = std::max(0.0, report.motion.speed_mps);
  known.report.motion.heading_deg = Wrap360(report.motion.heading_deg);
  if (report.received_s - known.made_s > limits_.max_age_s) return ContactIntake::kTooOld;
  if ((report.motion.position_m - own_position_m).norm() > limits_.reject_range_m) {
    return ContactIntake::kTooFar;
  }
  const auto before = reports_.find(report.name);
  if (before == reports_.end()) {
    reports_.emplace(report.name, std::move(known));
    return ContactIntake::kTaken;
  }
  if (known.made_s < before->second.made_s) return ContactIntake::kOutOfOrder;
  const bool jumped = HasJumped(before->second, known);
  before->second = std::move(known);
  return jumped ? ContactIntake::kJumped : ContactIntake::kTaken;
}

void ContactLedger::Forget(std::string_view name) {
  contacts_.erase(contacts_.find(name));
  reports_.erase(reports_.find(name));
  forgotten_.emplace_back(name);
}

void ContactLedger::DropSurplus(double now_s, const Eigen::Vector2d& own_position_m) {
  const auto most = static_cast<size_t>(limits_.max_contacts);
  if (reports_.size() <= most) return;
  // Those that go first: old ones by age, then all others by distance.
  std::vector<std::tuple<bool, double, std::string>> ranked;
  for (const auto& [name, known] : reports_) {
    const double age_s = now_s - known.made_s;
    const bool is_old = age_s > limits_.max_age_s / 2;
    const double distance_m = (contacts_.at(name).now.position_m - own_position_m).norm();
    ranked.emplace_back(is_old, is_old ? age_s : distance_m, name);
  }
  std::sort(ranked.begin(), ranked.end(), std::greater<>());
  for (size_t i = 0; i < ranked.size() - most; ++i) Forget(std::get<2>(ranked[i]));
}

const Contacts& ContactLedger::At(double now_s, const Eigen::Vector2d& own_position_m) {
  contacts_.clear();
  for (const auto& [name, known] : reports_) contacts_.emplace(name, ViewOf(known, now_s));
  std::vector<std::string> gone;
  for (const auto& [name, contact] : contacts_) {
    const double distance_m = (contact.now.position_m - own_position_m).norm();
    if (contact.age_s > limits_.max_age_s || distance_m > kRetireFactor * limits_.reject_range_m) {
      gone.push_back(name);
    }
  }
  for (const std::string& name : gone) Forget(name);
  DropSurplus(now_s, own_position_m);
  return contacts_;
}

std::vector<std::string> ContactLedger::TakeForgotten() { return std::exchange(forgotten_, {}); }

}  // namespace shoal
