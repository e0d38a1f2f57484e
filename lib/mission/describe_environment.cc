// The table [environment].
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "lib/mission/describe.h"
#include "lib/mission/ocean_of.h"

namespace shoal {
namespace {

/// What a preset says of the current; muNet's seas by their zones.
struct CurrentPreset {
  std::string_view name;
  CurrentWords words;
};

const std::array<CurrentPreset, 3>& Presets() {
  static const std::array<CurrentPreset, 3> presets = {{
      {"calm", {"typical", "northeast", "steady", "steady", "calm", "calm"}},
      {"dead", {"dead", "90", "constant", "constant", "calm", "calm"}},
      {"stormy", {"fast", "any", "unsteady", "unsteady", "choppy", "choppy"}},
  }};
  return presets;
}

void Describe(Fields& fields, CurrentWords& words) {
  if (fields.Has("preset", false)) {
    std::string name;
    std::vector<std::string_view> names;
    for (const CurrentPreset& preset : Presets()) names.push_back(preset.name);
    fields.Word("preset", name, names);
    for (const CurrentPreset& preset : Presets()) {
      if (preset.name == name) words = preset.words;
    }
  }
  fields.Scalar("speed_mps", words.speed_mps);
  fields.Scalar("direction_deg", words.direction_deg);
  fields.Scalar("speed_deviation_mps", words.speed_deviation_mps);
  fields.Scalar("direction_deviation_deg", words.direction_deviation_deg);
  fields.Scalar("speed_half_period_s", words.speed_half_period_s);
  fields.Scalar("direction_half_period_s", words.direction_half_period_s);
  if (!fields.reading()) return;
  for (const CurrentProblem& problem : FindProblems(words))
    fields.Refuse(problem.key, problem.text);
}

void Describe(Fields& fields, FloorOptions& floor) {
  constexpr std::array<std::string_view, 6> kStyles = {"none",    "flat",  "linear",
                                                       "sigmoid", "shelf", "grid"};
  fields.Word("style", floor.style, kStyles);
  fields.Number("depth_m", floor.depth_m, Between(0, 20'000));
  fields.Number("range_m", floor.range_m, Between(0, 20'000));
  fields.Number("size_m", floor.size_m, Between(1, 1e6));
  fields.Number("scale_m", floor.scale_m, Between(1, 1e6));
  fields.Number("slope_east", floor.slope_east, Between(-10, 10));
  fields.Number("slope_north", floor.slope_north, Between(-10, 10));
  if (fields.Has("grid", !floor.grid.empty())) {
    fields.Text("grid", floor.grid, {.min_length = 1, .max_length = 1000});
    if (fields.reading() && floor.style == "none") floor.style = "grid";
  }
  fields.Flag("grid_is_depth", floor.grid_is_depth);
  fields.Pair("grid_origin", floor.grid_origin_m, Between(-1e9, 1e9));
  if (fields.reading() && floor.style == "grid" && !fields.Has("grid", true)) {
    fields.Refuse("style", "style = \"grid\" needs grid = \"bay.asc\", an ESRI ASCII file");
  }
}

}  // namespace

void DescribeEnvironment(Fields& file, Mission& mission) {
  Environment& environment = mission.environment;
  file.Below("environment", [&](Fields& fields) {
    fields.Inline("current", [&](Fields& current) { Describe(current, environment.current); });
    fields.Inline("floor", [&](Fields& floor) { Describe(floor, environment.floor); });
    if (!fields.reading() || !fields.IsSound()) return;
    if (const Result<Ocean> ocean = OceanOf(mission); !ocean.ok()) {
      fields.Refuse("floor", ocean.error());
    }
  });
}

}  // namespace shoal
