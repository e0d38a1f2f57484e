#include "lib/run/run/grouping.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <thread>

#include "lib/base/text/numbers.h"

namespace shoal {

namespace {

constexpr int kMaxHostProcesses = 1000;

/// False for what has a process of its own in every grouping.
bool CanShare(const RosterEntry& entry) {
  return entry.provider == Provider::kShoal && !entry.app.empty() && !entry.vehicle.empty();
}

/// Returns the process of each vehicle, by its name.
std::map<std::string, std::string> GroupsOfVehicles(const std::vector<RosterEntry>& roster,
                                                    const Grouping& grouping) {
  std::map<std::string, std::vector<std::string>> vehicles_of;  // By host.
  for (const RosterEntry& entry : roster) {
    if (!CanShare(entry)) continue;
    std::vector<std::string>& vehicles = vehicles_of[entry.host];
    if (vehicles.empty() || vehicles.back() != entry.vehicle) vehicles.push_back(entry.vehicle);
  }
  std::map<std::string, std::string> groups;
  for (const auto& [host, vehicles] : vehicles_of) {
    const std::string prefix = host.empty() ? "group-" : "group-" + host + "-";
    const size_t num_processes =
        std::min(vehicles.size(), static_cast<size_t>(std::max(grouping.num_processes, 1)));
    for (size_t i = 0; i < vehicles.size(); ++i) {
      groups[vehicles[i]] =
          grouping.kind == Grouping::Kind::kVehicle
              ? "group-" + vehicles[i]
              : fmt::format("{}{}", prefix, i * num_processes / vehicles.size() + 1);
    }
  }
  return groups;
}

}  // namespace

Result<Grouping> ParseGrouping(std::string_view text) {
  if (text == "app") return Grouping{.kind = Grouping::Kind::kApp};
  if (text == "vehicle") return Grouping{.kind = Grouping::Kind::kVehicle};
  if (text == "host") {
    const int num_processors = static_cast<int>(std::thread::hardware_concurrency());
    return Grouping{.kind = Grouping::Kind::kHost,
                    .num_processes = std::clamp(num_processors, 1, kMaxHostProcesses)};
  }
  constexpr std::string_view kHostPrefix = "host=";
  if (text.starts_with(kHostPrefix)) {
    const std::string_view number = text.substr(kHostPrefix.size());
    Grouping grouping{.kind = Grouping::Kind::kHost};
    grouping.num_processes = ReadNumber<int>(number).value_or(0);
    if (grouping.num_processes >= 1 && grouping.num_processes <= kMaxHostProcesses) {
      return grouping;
    }
  }
  return Error{fmt::format(
      "'{}' is not a grouping: app (a process per participant), vehicle (a process per vehicle), "
      "host=N (N processes for all vehicles of a computer, 1 to {}) or host (as many as there are "
      "processors)",
      text, kMaxHostProcesses)};
}

std::string Name(const Grouping& grouping) {
  switch (grouping.kind) {
    case Grouping::Kind::kApp:
      return "app";
    case Grouping::Kind::kVehicle:
      return "vehicle";
    case Grouping::Kind::kHost:
      break;
  }
  return fmt::format("host={}", grouping.num_processes);
}

std::vector<RosterProcess> ShareOut(const std::vector<RosterEntry>& roster,
                                    const Grouping& grouping) {
  std::vector<RosterProcess> processes;
  const std::map<std::string, std::string> groups = GroupsOfVehicles(roster, grouping);
  std::map<std::string, size_t> places;  // Of groups, in `processes`.
  for (const RosterEntry& entry : roster) {
    if (grouping.kind == Grouping::Kind::kApp || !CanShare(entry)) {
      processes.push_back({.name = entry.name, .entries = {entry}});
      continue;
    }
    const std::string& group = groups.at(entry.vehicle);
    const auto [place, is_new] = places.try_emplace(group, processes.size());
    if (is_new) processes.push_back({.name = group, .entries = {}});
    processes[place->second].entries.push_back(entry);
  }
  for (RosterProcess& process : processes) {
    if (!process.is_group()) process.name = process.entries.front().name;
  }
  return processes;
}

}  // namespace shoal
