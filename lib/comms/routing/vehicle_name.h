// What a vehicle may be called.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns true for 1 to 32 letters (ASCII), digits and '_' that are not, in any case, one of the
/// reserved words "local", "unc" and "all".
[[nodiscard]] bool IsLegalVehicleName(std::string_view name);

/// Returns the name in lower case: two names are one vehicle's where their keys are equal.
[[nodiscard]] std::string VehicleKey(std::string_view name);

}  // namespace shoal
