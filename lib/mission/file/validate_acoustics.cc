// The acoustic network of the mission's vehicles, and what [comms] sends over it.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/mission/file/validate.h"
#include "lib/mission/toml/suggest.h"
#include "lib/sea/acoustics/validate_options.h"

namespace shoal {
namespace {

constexpr size_t kMaxNamesShown = 5;

std::vector<AcousticNode> NodesOf(const Mission& mission, std::string_view medium) {
  std::vector<AcousticNode> nodes;
  for (const Vehicle& vehicle : mission.vehicles) {
    if (!vehicle.HasMedium(medium)) continue;
    nodes.push_back({.name = vehicle.name,
                     .address = vehicle.acoustic_address,
                     .is_leader = vehicle.acoustic_leader});
  }
  return nodes;
}

/// Returns "'alpha', 'bravo' and 3 more".
std::string Listed(const std::vector<std::string_view>& names) {
  const size_t shown = std::min(names.size(), kMaxNamesShown);
  std::string text;
  for (size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + Quoted(names[i]);
  if (shown < names.size()) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

void CheckAddresses(const Mission& mission, const TablePlace& file) {
  const int broadcast = mission.acoustics.options.broadcast_address;
  std::map<int, std::vector<std::string_view>> users;
  for (const Vehicle& vehicle : mission.vehicles) {
    users[vehicle.acoustic_address].push_back(vehicle.name);
  }
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    const std::vector<std::string_view>& names = users[vehicle.acoustic_address];
    const bool is_second = names.size() > 1 && names[1] == vehicle.name;
    if (is_second) {
      file.Below("vehicle", i)
          .Refuse("acoustic_address",
                  fmt::format("several vehicles have the acoustic_address {}: {}; give each one "
                              "of its own (the default is the vehicle's place in the mission)",
                              vehicle.acoustic_address, Listed(names)));
    }
    if (vehicle.acoustic_address == broadcast) {
      file.Below("vehicle", i)
          .Refuse("acoustic_address",
                  fmt::format("acoustic_address = {} is the broadcast_address of [acoustics]; "
                              "choose another of the two",
                              broadcast));
    }
  }
}

}  // namespace

void ValidateNetwork(const TablePlace& place, const AcousticOptions& options,
                     const std::vector<AcousticNode>& nodes, std::string_view instead_of_key) {
  for (const OptionProblem& problem : FindProblems(options, nodes)) {
    std::string text = problem.message;
    if (text.starts_with("must be ")) text.insert(0, problem.option + " ");
    if (problem.option == "access_mode") {
      text += "; write acoustic_leader = true in the [[vehicle]] that leads";
    }
    if (!instead_of_key.empty()) text += " (in [acoustics])";
    place.Refuse(instead_of_key.empty() ? problem.option : instead_of_key, std::move(text));
  }
}

void ValidateAcoustics(const Mission& mission, const TablePlace& file) {
  const TablePlace acoustics = file.Below("acoustics");
  if (!file.Has("acoustics") && mission.acoustics.is_used) {
    const bool reports = mission.comms.reports_over.Has(kAcousticMedium);
    ValidateNetwork(file.Below("comms"), mission.acoustics.options,
                    NodesOf(mission, kAcousticMedium), reports ? "reports_over" : "messages_over");
  } else if (file.Has("acoustics") && acoustics.IsSound()) {
    ValidateNetwork(acoustics, mission.acoustics.options, NodesOf(mission, kAcousticMedium));
  }
  for (size_t i = 0; i < mission.media.size(); ++i) {
    const MediumOptions& medium = mission.media[i];
    const TablePlace place = file.Below("medium", i);
    if (medium.kind != MediumKind::kAcoustic || !place.IsSound()) continue;
    ValidateNetwork(place, medium.acoustics.options, NodesOf(mission, medium.name));
  }
  CheckAddresses(mission, file);
}

}  // namespace shoal
