#include "lib/comms/routing/vehicle_name.h"

#include <algorithm>

#include "lib/base/text/letters.h"

namespace shoal {

namespace {

constexpr size_t kMaxNameLength = 32;

}  // namespace

bool IsLegalVehicleName(std::string_view name) {
  if (name.empty() || name.size() > kMaxNameLength) return false;
  if (!std::all_of(name.begin(), name.end(), IsNameCharacter)) return false;
  const std::string key = VehicleKey(name);
  return key != "local" && key != "unc" && key != "all";
}

std::string VehicleKey(std::string_view name) { return LowerCase(name); }

}  // namespace shoal
