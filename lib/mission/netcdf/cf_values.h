// The numbers of a NetCDF variable, from what is in the file.
#pragma once

#include <vector>

#include "lib/mission/netcdf/netcdf_header.h"

namespace shoal {

/// Returns value * scale_factor + add_offset for each ("CF Conventions" 1.11, section 8.1), NaN
/// where there is no data: at _FillValue, missing_value, beyond valid_range, valid_min or
/// valid_max, and, without _FillValue, at the type's default ("NetCDF Users Guide", fill values)
/// and at -32768 of shorts. All of them count before unpacking; but bounds of packed integers that
/// are floats or doubles count after it ("NetCDF Users Guide", attribute conventions). _Unsigned =
/// "true" makes negative numbers of bytes, shorts and integers, bounds too, the large ones.
[[nodiscard]] std::vector<double> Unpacked(const NetcdfVariable& variable,
                                           std::vector<double> values);

}  // namespace shoal
