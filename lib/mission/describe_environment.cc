// The table [environment].
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "lib/mission/describe.h"
#include "lib/mission/ocean_of.h"

namespace shoal {
namespace {

/// The current of a preset; muNet's seas by their zones.
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

void Describe(Fields& fields, PlumeOptions& plume) {
  plume.exists = true;
  fields.Triple("source", plume.source_m, Between(-kFarthest_m, kFarthest_m));
  fields.Number("rate_gps", plume.rate_gps, Between(0, 1e9));
  fields.Number("current_mps", plume.current_mps, Between(0, kFastest_mps));
  fields.Number("direction_deg", plume.direction_deg, Between(-360, 360));
  if (plume.source_m.z() < 0 || plume.source_m.z() > 20'000) {
    fields.Refuse("source", "source is [x, y, depth], with a depth from 0 to 20000 m");
  }
}

}  // namespace

void Describe(Fields& fields, Environment& environment) {
  constexpr std::array<std::pair<std::string_view, ContactRule>, 2> kContactRules = {{
      {"ignore", ContactRule::kIgnore},
      {"stop", ContactRule::kStop},
  }};
  fields.Choice("contact", environment.contact, kContactRules);
  fields.Inline("current", [&](Fields& current) { Describe(current, environment.current); });
  fields.Inline("floor", [&](Fields& floor) { Describe(floor, environment.floor); });
  if (fields.Has("plume", environment.plume.exists)) {
    fields.Inline("plume", [&](Fields& plume) { Describe(plume, environment.plume); });
  }
}

}  // namespace shoal
