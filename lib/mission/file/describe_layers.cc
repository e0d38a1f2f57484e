#include "lib/mission/file/describe_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

/// The layers of a cascade by their names in mission files.
constexpr std::array<std::string_view, 5> kLayers = {"survival", "sonar", "survival_and_sonar",
                                                     "formation", "feed_forward"};
constexpr size_t kNumSurvival = 3;  ///< The first of them.

/// Distances that the layers of a task share.
struct Radii {
  SurvivalGroupLayer group;
  SurvivalSonarLayer sonar;
  FormationLayer formation;
};

VelocityLayer MakeLayer(std::string_view name, const Radii& radii) {
  if (name == "survival") return radii.group;
  if (name == "sonar") return radii.sonar;
  if (name == "survival_and_sonar") {
    return SurvivalLayer{.group = radii.group, .sonar = radii.sonar};
  }
  if (name == "feed_forward") return FeedForwardLayer{};
  FormationLayer formation = radii.formation;
  formation.r_safe_m = radii.group.r_safe_m;
  return formation;
}

/// Takes the radii out of a cascade, where it has them.
void ReadRadii(const VelocityLayer& layer, Radii* radii) {
  if (const auto* formation = std::get_if<FormationLayer>(&layer)) {
    radii->formation = *formation;
    radii->group.r_safe_m = formation->r_safe_m;
  }
  if (const SurvivalGroupLayer* group = GroupOf(layer)) radii->group = *group;
  if (const SurvivalSonarLayer* sonar = SonarOf(layer)) radii->sonar = *sonar;
}

void DescribeRadii(Fields& fields, bool has_formation, Radii& radii) {
  const NumberLimits distance = Above(0, 1e5);
  fields.Number("r_safe_m", radii.group.r_safe_m, distance);
  fields.Number("r_avoid_m", radii.group.r_avoid_m, distance);
  fields.Number("r_pass_m", radii.group.r_pass_m, Between(0, 1e5));
  fields.Number("r_sonar_m", radii.sonar.r_avoid_m, distance);
  fields.Number("r_sonar_pass_m", radii.sonar.r_pass_m, Between(0, 1e5));
  fields.Number("sonar_memory_s", radii.sonar.memory_s, Between(0, 600));
  const auto in_order = [&](std::string_view key, double low_m, double high_m,
                            std::string_view low_key) {
    if (low_m < high_m) return;
    fields.Refuse(
        key, fmt::format("{} = {:g} must be more than {} = {:g}", key, high_m, low_key, low_m));
  };
  in_order("r_avoid_m", radii.group.r_safe_m, radii.group.r_avoid_m, "r_safe_m");
  if (!has_formation) return;
  FormationLayer& formation = radii.formation;
  fields.Number("r_inner_m", formation.r_inner_m, distance);
  fields.Number("r_follow_m", formation.r_follow_m, distance);
  in_order("r_inner_m", radii.group.r_safe_m, formation.r_inner_m, "r_safe_m");
  in_order("r_follow_m", formation.r_inner_m, formation.r_follow_m, "r_inner_m");
}

}  // namespace

LayerRules LayersOfTracking() { return {.words = kLayers}; }

LayerRules LayersOfPath() {
  return {.words = std::span(kLayers).first(kNumSurvival),
          .may_be_none = true,
          .group = {.r_pass_m = 20},
          .sonar = {.r_pass_m = 10, .memory_s = 20}};
}

void DescribeLayers(Fields& fields, const LayerRules& rules, VelocityCascade& cascade) {
  Radii radii = {.group = rules.group, .sonar = rules.sonar, .formation = {}};
  std::vector<std::string> names;
  for (const VelocityLayer& layer : cascade.layers) {
    ReadRadii(layer, &radii);
    names.emplace_back(NameOf(layer));
  }
  fields.Texts("layers", names, rules.words.size());
  if (names.empty() && rules.may_be_none) {
    if (fields.reading()) cascade.layers.clear();
    return;
  }
  fields.Number("alpha", cascade.alpha, Between(0, 1));
  DescribeRadii(fields, rules.words.size() == kLayers.size(), radii);
  if (!fields.reading()) return;
  cascade.layers.clear();
  for (const std::string& name : names) {
    if (std::find(rules.words.begin(), rules.words.end(), name) == rules.words.end()) {
      fields.Refuse("layers", "unknown layer " + Quoted(name) + DidYouMean(name, rules.words) +
                                  "; there are: " + Joined(rules.words));
      continue;
    }
    cascade.layers.push_back(MakeLayer(name, radii));
  }
  if (names.empty()) fields.Refuse("layers", "a cascade needs a layer: " + Joined(rules.words));
}

}  // namespace shoal
