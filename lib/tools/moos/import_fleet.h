// The vehicles of an imported mission, each with its file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/import_losses.h"
#include "lib/tools/moos/import_vehicle.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {

class FleetImport {
 public:
  /// Makes one vehicle for each file that describes one. If no file does, it makes those that the
  /// broker's rules name, or else a single one with an invented name.
  void Name(const std::vector<MoosFile>& files, ImportLosses* losses);

  std::vector<VehicleImport>& vehicles() { return vehicles_; }
  const std::vector<VehicleImport>& vehicles() const { return vehicles_; }
  std::vector<std::string> Names() const;

  /// Returns the vehicle that the file with this index describes; nullptr: it is the shore's.
  VehicleImport* OfFile(size_t file);
  /// How many are described; those that are made up have no file.
  size_t num_described() const { return file_of_vehicle_.size(); }
  /// @pre vehicle < num_described()
  size_t FileOf(size_t vehicle) const { return file_of_vehicle_[vehicle]; }

  /// Returns true where behaviors of the vehicle go by a variable.
  bool HasVariable(std::string_view name, std::string_view variable) const;

 private:
  void MakeUpVehicle(const std::string& name);

  std::vector<VehicleImport> vehicles_;
  std::vector<size_t> file_of_vehicle_;
};

}  // namespace shoal
