// The last control of each rule and vehicle, for a broker that starts in the midst of a mission.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "lib/comms/routing/control.h"
#include "shoal/unc_control_t.hpp"
#include "shoal/unc_controls_t.hpp"

namespace shoal {

class KeptControls {
 public:
  /// An unregistered participant that makes names up must not fill the memory.
  static constexpr size_t kMax = 10'000;

  /// Keeps `control` in place of the one before of its rule and vehicle, names without regard to
  /// case. Requests and values that the rule cannot have change nothing at the broker and are not
  /// kept. Returns false where there is no room for another vehicle.
  [[nodiscard]] bool Keep(const ControlRow& row, const unc_control_t& control);

  /// All that are kept, in order of channel and vehicle.
  unc_controls_t All() const;

 private:
  std::map<std::pair<std::string, std::string>, unc_control_t> kept_;  ///< By channel and vehicle.
};

}  // namespace shoal
