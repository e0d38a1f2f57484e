// Which MOOS files describe vehicles, and what shoal can call those.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/moos_file.h"

namespace shoal {

/// True for an app that only vehicles have. `app_class` is as AppClass() writes it.
[[nodiscard]] bool IsVehicleApp(std::string_view app_class);

/// True for types of vehicles that dive, as pNodeReporter knows them.
[[nodiscard]] bool IsUnderwaterType(std::string_view platform_type);

/// Returns "uXMS" of ANTLER's `Run = uXMS @ NewConsole = true ~ name`.
[[nodiscard]] std::string AppNameOfRun(std::string_view value);

/// Returns the class of the app that ANTLER's `Run = uXMS @ NewConsole = true ~ name` starts.
[[nodiscard]] std::string AppOfRun(std::string_view value);

/// True where the file has a block of an app that only vehicles have, or ANTLER runs one.
[[nodiscard]] bool DescribesVehicle(const MoosFile& file);

/// Returns the last value of a global, whose name is in lower case; empty where it is absent.
[[nodiscard]] std::string GlobalValue(const MoosFile& file, std::string_view key);

/// Returns the vehicles to which the file's uFldNodeComms gives stealth or earange, in order.
[[nodiscard]] std::vector<std::string> VehiclesOfRules(const MoosFile& file);

/// Returns "meta_abe" for "missions/meta_abe.moos".
[[nodiscard]] std::string Stem(std::string_view path);

/// The names that a mission's vehicles have, unique without regard to case.
class VehicleNames {
 public:
  /// Returns a legal name near `wanted` that is still free, and takes it.
  std::string Take(std::string_view wanted);
  bool IsTaken(std::string_view name) const;

 private:
  std::set<std::string> taken_;  ///< In lower case.
};

}  // namespace shoal
