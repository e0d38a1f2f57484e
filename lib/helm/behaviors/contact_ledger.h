// What a helm knows of other vessels: the newest report of each, extrapolated to now, with its age.
//
//   ContactLedger ledger("alpha", {});
//   const ContactIntake intake = ledger.Take({.name = "bravo", .motion = ..., .made_s = 12.4,
//                                             .received_s = 12.6});
//   const Contacts contacts = ledger.At(now_s, own_position_m);  // For every behavior and alert.
//
// One list for alerts and behaviors, and one clock. A report's time is when it was made, by the
// reporter's clock, but never later than when it was received: a clock that is ahead makes a report
// no younger than its reception. Ages are now minus that time, never negative. A clock that is
// behind makes reports older, so they are extrapolated farther and end earlier; it is not guessed
// away.
//
// Extrapolation: straight on along the reported heading at the reported speed up to decay_start_s
// of age, from there with a speed that falls linearly to 0 at decay_end_s. Heading and speed stay
// as reported.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/contact.h"

namespace shoal {

/// One report of a contact, as received.
struct ContactReport {
  std::string name;
  std::string group = {};
  std::string type = {};
  VesselMotion motion = {};  ///< A negative speed counts as 0.
  double depth_m = 0;
  double length_m = 0;
  double made_s = 0;  ///< By the reporter's clock.
  double received_s = 0;
  ContactSource source = ContactSource::kNodeReport;
};

struct ContactLimits {
  double max_age_s = 45;         ///< Older reports do not count; > 0.
  double decay_start_s = 15;     ///< >= 0. Both 0: no extrapolation.
  double decay_end_s = 30;       ///< >= decay_start_s.
  double reject_range_m = 2000;  ///< Farther contacts are not taken; they go at 1.05 times this.
  int max_contacts = 500;
  /// A contact that moved faster than this times the greater of its reported speeds, and
  /// slowest_jump_mps, has jumped.
  double jump_factor = 3;
  double slowest_jump_mps = 2;
  double jump_slack_m = 20;  ///< Error of positions.
};

/// What became of a report.
enum class ContactIntake {
  kTaken,
  kJumped,     ///< Taken, but it can not have come there: a warning is due.
  kNoName,     ///< Refused, as all that follow.
  kOwnName,    ///< Own ship's name: forged, or a second vessel with it.
  kNotFinite,  ///< NaN or infinite, or a position beyond 1e7 m.
  kTooOld,
  kOutOfOrder,  ///< Older than what is known.
  kTooFar,
};

[[nodiscard]] bool IsTaken(ContactIntake intake);

/// Returns one clause that states what became of the report, for warnings.
[[nodiscard]] std::string_view TextOf(ContactIntake intake);

/// Returns the distance, m, that a contact is extrapolated by at an age.
[[nodiscard]] double ExtrapolatedDistance(double speed_mps, double age_s,
                                          const ContactLimits& limits);

class ContactLedger {
 public:
  explicit ContactLedger(std::string own_name, const ContactLimits& limits = {});

  /// `own_position_m`: own ship's, for reject_range_m.
  ContactIntake Take(const ContactReport& report, const Eigen::Vector2d& own_position_m);

  /// Returns all contacts at `now_s`. Those that are too old or too far are forgotten; of more than
  /// max_contacts first those older than half of max_age_s, the oldest first, then the farthest.
  const Contacts& At(double now_s, const Eigen::Vector2d& own_position_m);

  /// Returns the names that At() has forgotten since the last call.
  std::vector<std::string> TakeForgotten();

  const ContactLimits& limits() const { return limits_; }
  size_t size() const { return reports_.size(); }

 private:
  struct Known {
    ContactReport report;
    double made_s = 0;  ///< By the rule of one clock.
  };

  ContactView ViewOf(const Known& known, double now_s) const;
  bool HasJumped(const Known& before, const Known& after) const;
  void Forget(std::string_view name);
  void DropSurplus(double now_s, const Eigen::Vector2d& own_position_m);

  std::string own_name_;
  ContactLimits limits_;
  std::map<std::string, Known, std::less<>> reports_;
  Contacts contacts_;
  std::vector<std::string> forgotten_;
};

}  // namespace shoal
