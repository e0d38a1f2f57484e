#include "lib/mission/file/key_homes.h"

#include <functional>
#include <map>
#include <sstream>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/mission/file/load.h"

namespace shoal {

namespace {

using Homes = std::map<std::string, std::string, std::less<>>;

/// Reads them from a mission that has one of the tables that users meet first.
Homes FindHomes() {
  Mission mission;
  mission.acoustics.is_used = true;
  mission.vehicles.emplace_back().name = "alpha";
  mission.vehicles.front().tasks.push_back({.name = "way", .what = WaypointsTask()});
  Homes homes;
  std::istringstream lines(Explain(mission));
  std::string table;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) table = line.substr(0, line.rfind(']') + 1);
    const size_t end = line.find(" = ");
    if (end == std::string::npos || table.empty() || !IsLetter(line.front())) continue;
    homes.emplace(line.substr(0, end), table);
  }
  return homes;
}

}  // namespace

std::string HomeOfKey(std::string_view key) {
  static const Homes homes = FindHomes();
  const auto found = homes.find(key);
  return found == homes.end() ? std::string() : found->second;
}

}  // namespace shoal
