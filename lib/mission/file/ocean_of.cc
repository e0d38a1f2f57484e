#include "lib/mission/file/ocean_of.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "lib/base/geometry/angles.h"
#include "lib/base/text/numbers.h"
#include "lib/sea/ocean/current_zones.h"

namespace shoal {

namespace {

/// One of the words, what it may be, and where it goes.
struct WordRow {
  std::string_view key;
  std::string CurrentWords::*word;
  std::span<const Zone> zones;
  double low;  ///< Limits of numbers, in the file's unit.
  double high;
  bool is_angle;    ///< In degrees.
  bool is_compass;  ///< And clockwise from North.
  decltype(&CurrentRanges::speed_mps) range;
};

std::array<WordRow, 6> Rows() {
  return {{
      {"speed_mps", &CurrentWords::speed_mps, CurrentSpeedZones(), 0, kMaxCurrent_mps, false, false,
       &CurrentRanges::speed_mps},
      {"direction_deg", &CurrentWords::direction_deg, CurrentDirectionZones(), -360, 360, true,
       true, &CurrentRanges::direction_rad},
      {"speed_deviation_mps", &CurrentWords::speed_deviation_mps, CurrentSpeedDeviationZones(), 0,
       kMaxCurrent_mps, false, false, &CurrentRanges::speed_deviation_mps},
      {"direction_deviation_deg", &CurrentWords::direction_deviation_deg,
       CurrentDirectionDeviationZones(), 0, 180, true, false,
       &CurrentRanges::direction_deviation_rad},
      {"speed_half_period_s", &CurrentWords::speed_half_period_s, CurrentHalfPeriodZones(), 1e-3,
       1e9, false, false, &CurrentRanges::speed_half_period_s},
      {"direction_half_period_s", &CurrentWords::direction_half_period_s, CurrentHalfPeriodZones(),
       1e-3, 1e9, false, false, &CurrentRanges::direction_half_period_s},
  }};
}

/// Returns what a word means, in psi and radians, or nothing.
auto Understand(const WordRow& row, const std::string& word)
    -> std::optional<std::remove_cvref_t<decltype(CurrentRanges().*row.range)>> {
  if (const Zone* zone = FindZone(row.zones, word)) return zone->range;
  const size_t dots = word.find("..");
  const auto low = ReadNumber<double>(word.substr(0, dots));
  const auto high = dots == std::string::npos ? low : ReadNumber<double>(word.substr(dots + 2));
  if (!low || !high || *low < row.low || *high > row.high || *low > *high) return std::nullopt;
  if (row.is_compass) {
    if (*high - *low > 360) return std::nullopt;
    return {{.low = DegToRad(90 - *high), .high = DegToRad(90 - *low)}};
  }
  const double unit = row.is_angle ? DegToRad(1) : 1;
  return {{.low = *low * unit, .high = *high * unit}};
}

Result<SeaFloor> FloorOf(const FloorOptions& options, uint64_t seed, const GridPlacement& placement,
                         GridNotes& notes) {
  if (options.style == "grid") {
    Result<GridRead<DepthGrid>> read = ReadFloorGrid(options, placement);
    if (!read.ok()) return Error{read.error()};
    notes = std::move(read->notes);
    return SeaFloor(std::make_shared<const DepthGrid>(std::move(read->grid)));
  }
  NoiseFloorOptions noise = {.style = FloorStyle::kLinear,
                             .z_m = options.depth_m,
                             .range_m = options.range_m,
                             .size_m = options.size_m,
                             .scale_m = options.scale_m,
                             .south_west_m = Eigen::Vector2d::Constant(-options.size_m / 2),
                             .slope = {options.slope_east, options.slope_north}};
  if (options.style == "flat") noise.style = FloorStyle::kFlat;
  if (options.style == "sigmoid") noise.style = FloorStyle::kSigmoid;
  if (options.style == "shelf") noise.style = FloorStyle::kShelf;
  if (!IsNoiseFloor(noise)) return Error{"a floor cannot be made of these numbers"};
  return SeaFloor(NoiseFloor(noise, StreamKey(seed, "floor")));
}

Plume PlumeOf(const PlumeOptions& options, const std::optional<SeaFloor>& floor) {
  return {.source_m = options.source_m,
          .rate_gps = options.rate_gps,
          .current_mps = options.current_mps,
          .direction_rad = PsiFromHeading(DegToRad(options.direction_deg)),
          .floor_z_m = floor ? floor->DepthAt(options.source_m.head<2>()) : kDeepSea_m};
}

}  // namespace

std::vector<CurrentProblem> FindProblems(const CurrentWords& words) {
  std::vector<CurrentProblem> problems;
  for (const WordRow& row : Rows()) {
    const std::string& word = words.*row.word;
    if (Understand(row, word)) continue;
    std::string zones;
    for (const Zone& zone : row.zones) zones += fmt::format(", {}", zone.name);
    problems.push_back(
        {std::string(row.key),
         fmt::format("{} = '{}' is impossible; write a number from {:g} to {:g}, two "
                     "like \"0.1..0.4\", or one of: {}",
                     row.key, word.substr(0, 40), row.low, row.high, zones.substr(2))});
  }
  return problems;
}

Result<Ocean> OceanOf(const Environment& environment, uint64_t seed,
                      const GridPlacement& placement) {
  const std::vector<CurrentProblem> problems = FindProblems(environment.current);
  if (!problems.empty()) return Error{problems.front().text};
  CurrentRanges ranges;
  for (const WordRow& row : Rows()) {
    ranges.*row.range = *Understand(row, environment.current.*row.word);
  }
  const StreamKey key(seed, "current");
  CurrentParams params = DrawCurrent(ranges, key);
  params.max_speed_mps = std::max(params.max_speed_mps, params.speed_mps.mean);
  if (!IsCurrent(params)) return Error{"a current cannot be made of these numbers"};
  Ocean ocean{.current = Current(params, key),
              .current_grid = nullptr,
              .floor = std::nullopt,
              .plume = std::nullopt};
  if (environment.current_grid.exists()) {
    Result<GridRead<CurrentGrid>> read = ReadCurrentGrid(environment.current_grid, placement);
    if (!read.ok()) return Error{read.error()};
    ocean.current_grid = std::make_shared<const CurrentGrid>(std::move(read->grid));
    ocean.current_notes = std::move(read->notes);
  }
  if (environment.floor.style != "none") {
    Result<SeaFloor> floor = FloorOf(environment.floor, seed, placement, ocean.floor_notes);
    if (!floor.ok()) return Error{floor.error()};
    ocean.floor = std::move(*floor);
  }
  if (environment.plume.exists) ocean.plume = PlumeOf(environment.plume, ocean.floor);
  return ocean;
}

Result<Ocean> OceanOf(const Mission& mission) {
  // A floor takes a tenth of a second to make, and `shoal sim` asks once for each vehicle.
  struct Made {
    Environment environment;
    uint64_t seed = 0;
    GridPlacement placement;
    Ocean ocean;
  };
  thread_local std::optional<Made> last;
  const GridPlacement placement = PlacementOf(mission);
  if (last && last->environment == mission.environment && last->seed == mission.seed &&
      last->placement == placement) {
    NoteGridFilesRead(mission.environment, placement);
    return last->ocean;
  }
  Result<Ocean> ocean = OceanOf(mission.environment, mission.seed, placement);
  if (ocean.ok()) {
    last = Made{.environment = mission.environment,
                .seed = mission.seed,
                .placement = placement,
                .ocean = *ocean};
  }
  return ocean;
}

}  // namespace shoal
