#include "lib/comms/routing/destinations.h"

#include <algorithm>
#include <set>

#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

std::string_view WithoutBlanksAround(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace

Destinations ParseDestinations(std::string_view dest_node) {
  Destinations destinations;
  std::set<std::string, std::less<>> keys;
  for (size_t begin = 0; begin <= dest_node.size();) {
    const size_t end = std::min(dest_node.find(':', begin), dest_node.size());
    const std::string_view name = WithoutBlanksAround(dest_node.substr(begin, end - begin));
    begin = end + 1;
    if (name.empty()) continue;
    std::string key = VehicleKey(name);
    if (key == "all") {
      destinations.all = true;
    } else if (keys.insert(std::move(key)).second) {
      destinations.too_many = destinations.names.size() == Destinations::kMaxNames;
      if (destinations.too_many) break;
      destinations.names.emplace_back(name);
    }
  }
  return destinations;
}

}  // namespace shoal
