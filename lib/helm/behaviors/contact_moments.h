// Moments of an encounter at which flags are set: "@cpa PASSED = true", "@<50 NEAR = true".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/helm/colregs/encounter_geometry.h"
#include "lib/helm/modes/flag.h"

namespace shoal {

/// A flag and the moment at which it is set.
struct MomentFlag {
  std::string moment;        ///< "cpa", "os_passes_cn_port", ...; empty: by range.
  bool falls_below = false;  ///< Of a range: "@<50", else "@>50".
  double range_m = 0;
  Flag flag;
};

/// Parses each; the error names the one that is wrong. docs/vehicles/modes.md lists the moments.
[[nodiscard]] Result<std::vector<MomentFlag>> ParseMomentFlags(
    const std::vector<std::string>& texts);

/// Notices the moments between one iteration and the next.
class ContactMoments {
 public:
  /// Returns the flags whose moment has come since the last call. In the first one none has.
  std::vector<const Flag*> Update(const VesselMotion& own, const VesselMotion& contact,
                                  const std::vector<MomentFlag>& flags);
  /// The contact is not known now: what comes next is a first call again.
  void Forget() { before_.reset(); }

 private:
  /// Where each is in the frame of the other: ahead of the beam, to starboard; m.
  struct Encounter {
    double range_m = 0;
    double range_rate_mps = 0;
    double own_ahead_m = 0;
    double own_right_m = 0;
    double contact_ahead_m = 0;
    double contact_right_m = 0;
  };

  static Encounter EncounterOf(const VesselMotion& own, const VesselMotion& contact);

  std::optional<Encounter> before_;
};

}  // namespace shoal
