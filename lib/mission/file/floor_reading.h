// Whether the numbers of a sea floor are depths or elevations, by what a file states, its names and
// its signs, and what is wrong with a map that is read so.
//
//   const FloorReading reading = ReadingOf(variable, signs, options, where, notes);
//   const std::string problem = LandProblem(signs, reading, false);
#pragma once

#include <string>

#include "lib/mission/file/grid_files.h"
#include "lib/mission/model/environment.h"
#include "lib/mission/netcdf/cf_variables.h"
#include "lib/sea/ocean/floor_signs.h"

namespace shoal {

/// How the numbers of a floor are read, and why.
struct FloorReading {
  bool are_depths = false;
  std::string by = {};  ///< For messages; empty: grid_is_depth, or its default.
};

/// Decides what the numbers of a variable are: by what its attributes state, by grid_is_depth where
/// they state nothing, or cannot be right, and at last by its name.
[[nodiscard]] FloorReading ReadingOf(const NetcdfVariable& variable, const FloorSigns& signs,
                                     const FloorOptions& options, const std::string& where,
                                     GridNotes& notes);

/// Returns why it cannot be decided what the numbers of a floor are; empty: it can. A variable that
/// is called depth, and of which more numbers are negative, has depths of much land, or elevations.
[[nodiscard]] std::string SignsProblem(const NetcdfVariable& variable, const FloorSigns& signs,
                                       const FloorOptions& options);

/// Returns why a map cannot be a sea floor as it is read; empty: it can. A user who stated the
/// reading may have a map with very little water.
[[nodiscard]] std::string LandProblem(const FloorSigns& signs, const FloorReading& reading,
                                      bool is_stated);

/// Warns of land, by its share.
void WarnOfLand(const FloorSigns& signs, const FloorReading& reading, const std::string& file,
                GridNotes& notes);

}  // namespace shoal
