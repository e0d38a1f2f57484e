// How long a NetCDF file of the classic forms must be. libnetcdf reads zeros where the file ends
// too early, so one that was cut off while it was copied would look whole.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace shoal {

/// Returns where the last value of a file ends that begins with `bytes` ("NetCDF Classic Format
/// Specification": CDF-1, CDF-2 and CDF-5). 0 where the number of records is left open. Nothing
/// if the bytes are not a whole header of this kind.
[[nodiscard]] std::optional<uint64_t> ClassicDataEnd(std::span<const uint8_t> bytes);

}  // namespace shoal
