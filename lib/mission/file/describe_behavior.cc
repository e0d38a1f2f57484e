// The table [[vehicle.behavior]]: what all kinds have. The keys of each kind are in
// describe_route_behaviors.cc, describe_contact_behaviors.cc and describe_limit_behaviors.cc. The
// same descriptions read updates of a running helm (update_reader.h).
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/helm/behaviors/behavior_runner.h"
#include "lib/helm/modes/condition.h"
#include "lib/helm/modes/value_text.h"
#include "lib/mission/file/behavior_fields.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

void DescribeFlags(Fields& fields, BehaviorFlags& flags) {
  FlagTexts(fields, "runflag", flags.runflag);
  FlagTexts(fields, "runxflag", flags.runxflag);
  FlagTexts(fields, "idleflag", flags.idleflag);
  FlagTexts(fields, "activeflag", flags.activeflag);
  FlagTexts(fields, "inactiveflag", flags.inactiveflag);
  FlagTexts(fields, "endflag", flags.endflag);
  FlagTexts(fields, "spawnflag", flags.spawnflag);
  FlagTexts(fields, "spawnxflag", flags.spawnxflag);
  FlagTexts(fields, "configflag", flags.configflag);
  fields.NoKey("startflag", "write the setting in [vehicle.variables]");
}

void DescribeDuration(Fields& fields, BehaviorOptions& options) {
  if (fields.Has("duration", options.duration.has_value())) {
    double duration_s = options.duration.value_or(0);
    fields.Number("duration", duration_s, kSecondsRange);
    options.duration = duration_s;
  }
  fields.Flag("duration_idle_decay", options.duration_idle_decay);
  fields.Text("duration_reset", options.duration_reset, {.max_length = 200});
  VariableName(fields, "duration_status", options.duration_status);
  TextsOrOne(fields, "nostarve", options.nostarve, kMaxFlags);
  fields.Number("nostarve_s", options.nostarve_s, kSecondsRange);
  if (!options.nostarve.empty() && options.nostarve_s <= 0) {
    fields.Refuse("nostarve", "nostarve needs nostarve_s = 10, the greatest age in seconds");
  }
}

/// They may name the contact.
void CheckConditions(Fields& fields, const BehaviorOptions& options) {
  const auto parsed = ParseConditions(ConditionsOf(options));
  if (!parsed.ok()) fields.Refuse("condition", parsed.error());
}

}  // namespace

void DescribeKindOf(Fields& fields, BehaviorOptions& options) {
  const bool is_recipe = options.templating == Templating::kSpawn || !fields.demands_keys();
  std::visit([&](auto& what) { DescribeKind(fields, what, is_recipe); }, options.what);
}

void DescribeCommon(Fields& fields, BehaviorOptions& options) {
  fields.Number("pwt", options.pwt, Between(0, 1e6));
  fields.CalledElsewhere("pwt", "priority");
  fields.CalledElsewhere("pwt", "weight");
  TextsOrOne(fields, "condition", options.condition, kMaxFlags);
  CheckConditions(fields, options);
  DescribeFlags(fields, options.flags);
  DescribeDuration(fields, options);
  fields.Flag("perpetual", options.perpetual);
}

void Describe(Fields& fields, BehaviorOptions& options) {
  constexpr std::array<std::pair<std::string_view, Templating>, 3> kTemplating = {{
      {"none", Templating::kNone},
      {"spawn", Templating::kSpawn},
      {"clone", Templating::kClone},
  }};
  const std::vector<AnyBehavior> kinds = OneBehaviorOfEachKind();
  std::vector<std::string_view> words;
  words.reserve(kinds.size());
  for (const AnyBehavior& each : kinds) words.push_back(KindOf(each));
  std::string kind(fields.reading() ? "" : KindOf(options.what));
  fields.Require("kind", "kind = \"waypoint\"");
  fields.Word("kind", kind, words);
  if (fields.reading()) {
    for (const AnyBehavior& each : kinds) {
      if (kind == KindOf(each)) options.what = each;
    }
    options.name = kind;
  }
  fields.Text("name", options.name, {.min_length = 1});
  if (!options.name.empty() && !VariableNameProblem(options.name).empty()) {
    fields.Refuse("name", Quoted(options.name) +
                              " is not a name of a behavior: letters, digits and _ . - are");
  }
  if (kind.empty()) {
    fields.SkipRest();  // Which keys are right depends on the kind.
    return;
  }
  DescribeCommon(fields, options);
  VariableName(fields, "updates", options.updates);
  fields.Choice("templating", options.templating, kTemplating);
  const bool keeps_clear = std::holds_alternative<ColregsOptions>(options.what) ||
                           std::holds_alternative<AvoidCollisionOptions>(options.what);
  if (fields.reading() && keeps_clear && !fields.Has("contact", true) &&
      !fields.Has("templating", true)) {
    options.templating = Templating::kSpawn;  // Without a contact every contact is meant.
  }
  if (fields.reading() && options.templating == Templating::kSpawn && !fields.Has("name", true)) {
    options.name += '_';  // The names of what it makes begin with it.
  }
  fields.SmallInteger("max_spawnings", options.max_spawnings, 1, 1'000'000);
  DescribeKindOf(fields, options);
}

}  // namespace shoal
