// Other vessels as a helm knows them: only from what it received, extrapolated, with the age of the
// knowledge.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

#include "lib/helm/colregs/encounter_geometry.h"

namespace shoal {

/// Where knowledge of a contact comes from.
enum class ContactSource { kNodeReport, kSonar, kSwarm };

/// A contact at the time of an iteration.
struct ContactView {
  std::string name;
  std::string group = {};
  std::string type = {};
  ContactSource source = ContactSource::kNodeReport;
  VesselMotion reported = {};  ///< As received last.
  VesselMotion now = {};       ///< Extrapolated to the time of the iteration.
  double depth_m = 0;
  double length_m = 0;
  double age_s = 0;  ///< Since the report was made.
};

/// All contacts that a helm has at one time, by name.
using Contacts = std::map<std::string, ContactView, std::less<>>;

}  // namespace shoal
