#include "lib/comms/routing/vehicle_name.h"

#include <algorithm>

namespace shoal {

namespace {

// <cctype> asks the locale.
bool IsUpper(char c) { return c >= 'A' && c <= 'Z'; }
char ToLower(char c) { return IsUpper(c) ? static_cast<char>(c - 'A' + 'a') : c; }
bool MayStandInAName(char c) {
  return IsUpper(c) || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

constexpr size_t kMaxNameLength = 32;

}  // namespace

bool IsLegalVehicleName(std::string_view name) {
  if (name.empty() || name.size() > kMaxNameLength) return false;
  if (!std::all_of(name.begin(), name.end(), MayStandInAName)) return false;
  const std::string key = VehicleKey(name);
  return key != "local" && key != "unc" && key != "all";
}

std::string VehicleKey(std::string_view name) {
  std::string key(name);
  std::transform(key.begin(), key.end(), key.begin(), ToLower);
  return key;
}

}  // namespace shoal
