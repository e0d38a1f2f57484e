// What vehicles and participants may be called.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace shoal {

/// No mission has more; also the most that the broker keeps.
constexpr size_t kMaxVehicles = 10'000;

/// Returns why no vehicle and no participant can be called `name`; empty where
/// IsLegalVehicleName (lib/comms/routing/vehicle_name.h). Names become parts of LCM channel names,
/// which have 63 characters at most; NODE_REPORT_LOCAL, NODE_REPORT_UNC and "all" mean something
/// else.
std::string NameProblem(std::string_view name);

/// Returns NAME of "group:NAME", which stands for the vehicles of a group; nothing for other text.
std::optional<std::string_view> GroupNamed(std::string_view text);

/// Returns what follows the kind of process in the name of one of shoal's own ("alpha" of
/// "helm_alpha"); empty for other names.
std::string_view VehicleOfProcess(std::string_view participant_name);

/// Returns true for shoal's processes that every mission has or may have: shoal, shore_broker,
/// recorder.
bool IsOwnProcess(std::string_view participant_name);

}  // namespace shoal
