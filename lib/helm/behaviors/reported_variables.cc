#include "lib/helm/behaviors/reported_variables.h"

#include <algorithm>
#include <iterator>

namespace shoal {

bool IsReportedVariable(std::string_view name) {
  constexpr std::string_view kBeginnings[] = {
      "CYCLE_",  "LOITER_",     "PSKEEP_", "DIST_TO_",  "OPREG_",   "LEGRUN_",
      "PURSUIT", "REGION",      "TRAIL_",  "PERIODIC_", "PENDING_", "TIME_AT",
      "ZIG",     "GO_TO_DEPTH", "FIXTURN", "BHV_",      "CONTACT_"};
  // WPT_DIST_TO_NEXT has no counterpart.
  constexpr std::string_view kWithSuffix[] = {"WPT_INDEX", "WPT_STAT"};
  const auto has_suffix = [&](std::string_view begin) {
    return name.starts_with(begin) && (name.size() == begin.size() || name[begin.size()] == '_');
  };
  return std::any_of(std::begin(kBeginnings), std::end(kBeginnings),
                     [&](std::string_view begin) { return name.starts_with(begin); }) ||
         std::any_of(std::begin(kWithSuffix), std::end(kWithSuffix), has_suffix) ||
         std::any_of(kOwnVariables.begin(), kOwnVariables.end(),
                     [&](const OwnVariable& own) { return own.name == name; });
}

}  // namespace shoal
