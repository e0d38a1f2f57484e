// Which variables something in a mission's files may read.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/import_fleet.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {

class MoosReaders {
 public:
  /// Reads what lines of apps and behaviors name. Lines that only show, log or pass on variables
  /// do not read them.
  MoosReaders(const std::vector<MoosFile>& files, FleetImport* fleet);

  /// Returns false if no line reads the variable `posted` of the file of `vehicle`, or of the
  /// shore's file if `vehicle` is empty. A line reads it by its name, or by its name without _ALL
  /// or without a vehicle's name at its end. `bridged`: another name that it becomes; may be empty.
  /// Variables that apps of MOOS-IvP look at without a line, NAV_X and the like, are read.
  bool MayRead(std::string_view vehicle, std::string_view posted, std::string_view bridged) const;

  /// Returns true where a line or behavior of any file names the variable.
  bool IsNamed(std::string_view variable) const { return IsIn("", variable); }

 private:
  using Words = std::set<std::string, std::less<>>;

  bool IsIn(std::string_view vehicle, std::string_view variable) const;

  std::vector<std::string> vehicles_;
  std::map<std::string, Words, std::less<>> words_;  ///< By vehicle; "": of all files.
};

}  // namespace shoal
