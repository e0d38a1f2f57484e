#include "lib/mission/model/names.h"

#include <algorithm>
#include <array>

#include "lib/base/text/letters.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr size_t kLongestName = 32;
constexpr std::array<std::string_view, 4> kOwnProcesses = {"shoal", "shore_broker", "recorder",
                                                           "netsim_manager"};
constexpr std::array<std::string_view, 4> kVehicleProcesses = {"vehicle_sim_", "helm_",
                                                               "node_reporter_", "acomms_"};

}  // namespace

std::string NameProblem(std::string_view name) {
  if (IsLegalVehicleName(name)) return "";
  if (name.empty()) return "a name must not be empty";
  if (!std::all_of(name.begin(), name.end(), IsNameCharacter)) {
    return "the name " + Quoted(name) + " may hold only letters, digits and '_'";
  }
  if (name.size() > kLongestName) {
    return "the name " + Quoted(name) + " has " + std::to_string(name.size()) +
           " characters; allowed: at most " + std::to_string(kLongestName);
  }
  return Quoted(name) + " is reserved, as local, unc and all are: choose another";
}

std::optional<std::string_view> GroupNamed(std::string_view text) {
  constexpr std::string_view kPrefix = "group:";
  if (!text.starts_with(kPrefix)) return std::nullopt;
  return text.substr(kPrefix.size());
}

std::string_view VehicleOfProcess(std::string_view participant_name) {
  const std::string lower = LowerCase(participant_name);
  for (const std::string_view prefix : kVehicleProcesses) {
    if (lower.starts_with(prefix)) return participant_name.substr(prefix.size());
  }
  return {};
}

bool IsOwnProcess(std::string_view participant_name) {
  const auto* found =
      std::find(kOwnProcesses.begin(), kOwnProcesses.end(), LowerCase(participant_name));
  return found != kOwnProcesses.end();
}

}  // namespace shoal
