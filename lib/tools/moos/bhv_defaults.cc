#include "lib/tools/moos/bhv_defaults.h"

#include <fmt/format.h>

#include "lib/base/text/letters.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/tools/moos/contact_templates.h"

namespace shoal {
namespace {

/// Where the distances of avoidance cross, MOOS-IvP moves one of them, and shoal refuses.
void TakeDistances(std::string_view kind, BhvSettings* settings) {
  const bool is_obstacle = kind == "avoid_obstacle";
  if (!is_obstacle && kind != "avoid_collision" && kind != "colregs") return;
  const bool is_plain = kind == "avoid_collision";
  const double outer_m = settings->NumberAt("pwt_outer_dist", is_obstacle ? 50
                                                              : is_plain  ? 200
                                                                          : 100);
  const double inner_m = settings->NumberAt("pwt_inner_dist", is_obstacle ? 10
                                                              : is_plain  ? 50
                                                                          : 90);
  const double completed_m = settings->NumberAt("completed_dist", is_obstacle ? 50
                                                                  : is_plain  ? 500
                                                                              : 100);
  if (inner_m >= outer_m) {
    settings->Move("pwt_inner_dist", TomlNumber(outer_m * 0.9),
                   "Assumed: less than pwt_outer_dist, as it must be.");
  }
  if (completed_m < outer_m) {
    settings->Move("completed_dist", TomlNumber(outer_m),
                   "Assumed: not less than pwt_outer_dist, as it must be.");
  }
}

}  // namespace

void SetBhvDefaults(const BhvBlock& block, std::string_view kind, bool has_duration,
                    BhvSettings* settings, std::vector<std::string>* warnings) {
  const bool has_turns = settings->IsSet("turn1_rad") && settings->IsSet("turn2_rad");
  if (kind == "leg_run" && !has_turns) {
    warnings->push_back(
        fmt::format("{}: Behavior = {}: has no turn_rad: MOOS-IvP's does nothing then, here it "
                    "turns with 20 m",
                    block.origin, block.type));
  }
  if (kind == "cut_range" && AsksForAlerts(block)) {
    settings->Assume("alert_range", TomlNumber(settings->NumberAt("pwt_outer_dist", 0)),
                     "As MOOS-IvP's template asks for alerts.");
  }
  if (kind == "max_depth") {
    settings->Assume("tolerance", "100", "As MOOS-IvP has it where it is not given.");
  }
  if (kind == "op_region" && LowerCase(block.type).ends_with("opregion") &&
      !settings->IsSet("trigger_entry_time")) {
    settings->Assume("trigger_on_poly_entry", "false",
                     "As MOOS-IvP's OpRegion: a start outside is a breach.");
  }
  if (LowerCase(block.type).ends_with("aborttopoint")) {
    settings->Assume("capture_radius", "25", "As MOOS-IvP's AbortToPoint has it.");
    settings->Assume("slip_radius", "200", "As MOOS-IvP's AbortToPoint has it.");
  }
  TakeDistances(kind, settings);
  const bool is_constant = kind.starts_with("constant_");
  if (is_constant && !has_duration && !settings->IsSet("duration")) {
    warnings->push_back(
        fmt::format("{}: Behavior = {}: has no duration: MOOS-IvP ends it at once, here it lasts "
                    "without end",
                    block.origin, block.type));
  }
}

}  // namespace shoal
