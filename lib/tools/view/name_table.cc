#include "lib/tools/view/name_table.h"

#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

NameTable::NameTable(const std::vector<std::string>& names) {
  for (const std::string& name : names) Add(name);
}

int32_t NameTable::Find(std::string_view name) const {
  const auto exact = numbers_.find(name);  // Nearly always spelled as it was at first.
  if (exact != numbers_.end()) return exact->second;
  const auto found = numbers_.find(VehicleKey(name.substr(0, kLongestName)));
  return found == numbers_.end() ? -1 : found->second;
}

int32_t NameTable::Add(std::string_view name) {
  name = name.substr(0, kLongestName);
  const int32_t known = Find(name);
  if (known >= 0) return known;
  const auto number = static_cast<int32_t>(names_.size());
  names_.emplace_back(name);
  numbers_.emplace(name, number);
  numbers_.emplace(VehicleKey(name), number);
  return number;
}

}  // namespace shoal
