#include "lib/mission/file/floor_reading.h"

#include <fmt/format.h>

#include <cstddef>
#include <optional>

namespace shoal {

namespace {

std::string ReadingText(bool are_depths) {
  return are_depths ? "depths, positive below it" : "elevations, negative below it";
}

/// Returns how a share of points is called: "12 %", "0.3 %", "all".
std::string ShareText(size_t part, size_t all) {
  if (part == all) return "all";
  return fmt::format("{:.2g} %", 100.0 * static_cast<double>(part) / static_cast<double>(all));
}

}  // namespace

std::string LandProblem(const FloorSigns& signs, const FloorReading& reading, bool is_stated) {
  if (signs.num() == 0) return "has no data at any point; is it the right file, and whole?";
  const size_t num_below = signs.NumBelow(reading.are_depths);
  if (is_stated ? num_below > 0 : !signs.IsHardlyBelow(reading.are_depths)) return "";
  const std::string start = fmt::format(
      "has {} of its {} points below the surface where its numbers are {}{}: ",
      num_below == 0 ? "none" : fmt::format("no more than {}", num_below), signs.num(),
      ReadingText(reading.are_depths), reading.by.empty() ? "" : ", as by " + reading.by);
  if (signs.IsHardlyBelow(!reading.are_depths)) {
    return start + "nor are they the other way round; is it the right map?";
  }
  return fmt::format("{}write grid_is_depth = {} to read them as {}", start, !reading.are_depths,
                     ReadingText(!reading.are_depths));
}

void WarnOfLand(const FloorSigns& signs, const FloorReading& reading, const std::string& file,
                GridNotes& notes) {
  const size_t num_land = signs.num() - signs.NumBelow(reading.are_depths);
  if (num_land == 0) return;
  notes.warnings.push_back(fmt::format(
      "{} of the points of {} are land, at the surface or above it, where its numbers are {}: if "
      "they are not, write grid_is_depth = {}",
      ShareText(num_land, signs.num()), file, ReadingText(reading.are_depths),
      !reading.are_depths));
}

FloorReading ReadingOf(const NetcdfVariable& variable, const FloorSigns& signs,
                       const FloorOptions& options, const std::string& where, GridNotes& notes) {
  const std::optional<FloorStatement> stated = StatementOf(variable);
  if (stated) {
    FloorReading reading = {.are_depths = stated->are_depths, .by = stated->by};
    if (!options.grid_is_depth || *options.grid_is_depth == reading.are_depths) return reading;
    if (signs.IsHardlyBelow(reading.are_depths)) return {.are_depths = *options.grid_is_depth};
    notes.warnings.push_back(fmt::format("{} holds {} by {}: grid_is_depth = {} has no effect",
                                         where, ReadingText(reading.are_depths), reading.by,
                                         *options.grid_is_depth));
    return reading;
  }
  // Of a map with land, more than half lies in the sea, as the name has it: else it may be either.
  if (!options.grid_is_depth && IsNamedAsDepths(variable) && !signs.IsHardlyBelow(true) &&
      signs.NumBelow(true) >= signs.NumBelow(false)) {
    notes.warnings.push_back(
        where +
        " has no attribute that states what its numbers are: by its name and their signs "
        "they are taken as depths; write grid_is_depth = true if they are");
    return {.are_depths = true, .by = "its name"};
  }
  return {.are_depths = options.grid_is_depth.value_or(false)};
}

std::string SignsProblem(const NetcdfVariable& variable, const FloorSigns& signs,
                         const FloorOptions& options) {
  if (StatementOf(variable) || options.grid_is_depth || !IsNamedAsDepths(variable) ||
      signs.IsHardlyBelow(true) || signs.NumBelow(true) >= signs.NumBelow(false)) {
    return "";
  }
  return fmt::format(
      "is named as depths, positive below the surface, and {} of its points are negative: write "
      "grid_is_depth = true if these are land, or false if they are the sea",
      ShareText(signs.num_negative, signs.num()));
}

}  // namespace shoal
