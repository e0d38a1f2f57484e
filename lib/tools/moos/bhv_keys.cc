#include "lib/tools/moos/bhv_keys.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace bhv_keys {

using enum BhvValue;

constexpr std::array kTypes = std::to_array<BhvType>({
    {"waypoint", "waypoint"},
    {"loiter", "loiter"},
    {"stationkeep", "station_keep"},
    {"constantdepth", "constant_depth"},
    {"avoidcollision", "avoid_collision"},
    {"avdcolregs*", "colregs"},
    {"constantspeed", "constant_speed"},
    {"constantheading", "constant_heading"},
    {"avoidobstacle*", "avoid_obstacle"},
    {"timer", "timer"},
    {"periodicsurface", "periodic_surface"},
    {"trail", "trail"},
    {"maxdepth", "max_depth"},
    {"maxspeed", "max_speed"},
    {"cutrange", "cut_range"},
    {"convoy*", "convoy"},
    {"gotodepth", "go_to_depth"},
    {"legrun*", "leg_run"},
    {"opregion", "op_region"},
    {"opregionv24", "op_region"},
    {"memoryturnlimit", "memory_turn_limit"},
    {"periodicspeed", "periodic_speed"},
    {"shadow", "shadow"},
    {"fixedturn", "fixed_turn"},
    {"fixturn", "fixed_turn"},
    {"zigzag", "zigzag"},
    {"fullstop", "full_stop"},
    {"testfailure", "test_failure"},
    {"maintainheading", "maintain_heading"},
    {"headingbias", "heading_bias"},
    {"hysteresis", "hysteresis"},
    {"headinghysteresis", "hysteresis"},
    {"minaltitudex", "min_altitude"},
    {"rubberband", "rubber_band"},
    {"aborttopoint", "waypoint"},
    {"simplewaypoint", "waypoint"},
    {"timeout", "op_region"},
    {"opregionrecover", "op_region"},
});

constexpr std::string_view kContactKinds = "avoid_collision colregs trail shadow cut_range convoy";

constexpr std::array kKeys = std::to_array<BhvKey>({
    {"*", "name", "name", kText},
    {"*", "descriptor", "name", kText},
    {"*", "updates", "updates", kText},
    {"*", "duration_reset", "duration_reset", kText},
    {"*", "duration_status", "duration_status", kPosted},
    {"*", "pwt", "pwt", kNumber},
    {"*", "priority", "pwt", kNumber},
    {"*", "priwt", "pwt", kNumber},
    {"*", "condition", "condition", kTexts, true},
    {"*", "runflag", "runflag", kTexts},
    {"*", "run_flag", "runflag", kTexts},
    {"*", "runxflag", "runxflag", kTexts},
    {"*", "runx_flag", "runxflag", kTexts},
    {"*", "idleflag", "idleflag", kTexts},
    {"*", "idle_flag", "idleflag", kTexts},
    {"*", "activeflag", "activeflag", kTexts},
    {"*", "active_flag", "activeflag", kTexts},
    {"*", "inactiveflag", "inactiveflag", kTexts},
    {"*", "inactive_flag", "inactiveflag", kTexts},
    {"*", "endflag", "endflag", kTexts},
    {"*", "end_flag", "endflag", kTexts},
    {"*", "spawnflag", "spawnflag", kTexts},
    {"*", "spawn_flag", "spawnflag", kTexts},
    {"*", "spawnxflag", "spawnxflag", kTexts},
    {"*", "spawnx_flag", "spawnxflag", kTexts},
    {"*", "configflag", "configflag", kTexts},
    {"*", "config_flag", "configflag", kTexts},
    {"*", "duration", "duration", kNumber},
    {"*", "duration_idle_decay", "duration_idle_decay", kFlag},
    {"*", "perpetual", "perpetual", kFlag},
    {"*", "templating", "templating", kWord, true},
    {"*", "max_spawnings", "max_spawnings", kInteger},
    {"waypoint", "points", "points", kPoints, true},
    {"waypoint", "polygon", "points", kPoints, true},
    {"waypoint", "point", "points", kPoints, true},
    {"waypoint loiter", "speed", "speed", kNumber},
    {"waypoint loiter", "speed_alt", "speed_alt", kNumber},
    {"waypoint loiter", "use_alt_speed", "use_alt_speed", kFlag},
    {"waypoint", "wpt_index_var", "index_var", kPosted},
    {"waypoint", "wpt_index", "index_var", kPosted},
    {"waypoint", "cycle_index_var", "cycle_var", kPosted},
    {"waypoint", "cycle_index", "cycle_var", kPosted},
    {"waypoint", "wpt_status_var", "status_var", kPosted},
    {"waypoint", "wpt_status", "status_var", kPosted},
    {"waypoint", "wpt_dist_to_next", "dist_to_next_var", kPosted},
    {"waypoint", "wpt_dist_to_prev", "dist_to_prev_var", kPosted},
    {"waypoint leg_run", "capture_radius", "capture_radius", kNumber},
    {"waypoint leg_run", "capture", "capture_radius", kNumber},
    {"waypoint leg_run", "radius", "capture_radius", kNumber},
    {"waypoint leg_run", "slip_radius", "slip_radius", kNumber},
    {"waypoint leg_run", "nm_radius", "slip_radius", kNumber},
    {"waypoint leg_run", "lead", "lead", kNumber},
    {"waypoint leg_run", "lead_damper", "lead_damper", kNumber},
    {"waypoint", "lead_to_start", "lead_to_start", kFlag},
    {"waypoint", "greedy_tour", "greedy_tour", kFlag},
    {"waypoint", "wptflag_on_start", "wptflag_on_start", kFlag},
    {"waypoint", "reset_on_idle", "reset_on_idle", kFlag},
    {"waypoint", "lead_condition", "lead_condition", kText},
    {"waypoint", "order", "order", kWord},
    {"waypoint", "currix", "currix", kInteger},
    {"waypoint loiter", "ipf_type", "ipf_type", kWord},
    {"waypoint loiter", "ipf-type", "ipf_type", kWord},
    {"waypoint loiter leg_run", "patience", "patience", kNumber},
    {"waypoint loiter leg_run", "crs_spd_zaic_ratio", "patience", kNumber},
    {"waypoint", "wptflag", "wptflag", kTexts},
    {"waypoint", "wpt_flag", "wptflag", kTexts},
    {"waypoint", "cycleflag", "cycleflag", kTexts},
    {"waypoint", "cycle_flag", "cycleflag", kTexts},
    {"waypoint loiter", "post_suffix", "post_suffix", kText},
    {"loiter", "polygon", "polygon", kPoints, true},
    {"loiter", "clockwise", "clockwise", kWord},
    {"loiter", "radius", "radius", kNumber},
    {"loiter", "capture_radius", "radius", kNumber},
    {"loiter", "slip_radius", "slip_radius", kNumber},
    {"loiter", "nm_radius", "slip_radius", kNumber},
    {"loiter", "acquire_dist", "acquire_dist", kNumber},
    {"loiter", "spiral_factor", "spiral_factor", kNumber},
    {"loiter", "slingshot", "slingshot", kNumber},
    {"loiter station_keep", "center_activate", "center_activate", kFlag},
    {"station_keep", "station_pt", "station_pt", kPoint, true},
    {"station_keep", "point", "station_pt", kPoint, true},
    {"station_keep", "swing_time", "swing_time", kNumber},
    {"station_keep", "inner_radius", "inner_radius", kNumber},
    {"station_keep", "outer_radius", "outer_radius", kNumber},
    {"station_keep", "outer_speed", "outer_speed", kNumber},
    {"station_keep", "transit_speed", "transit_speed", kNumber},
    {"station_keep", "extra_speed", "transit_speed", kNumber},
    {"station_keep", "hibernation_radius", "hibernation_radius", kNumber},
    {"constant_depth", "depth", "depth", kNumber},
    {"constant_depth", "depth_mismatch_var", "depth_mismatch_var", kPosted},
    {"constant_heading", "heading", "heading", kNumber},
    {"constant_heading", "complete_thresh", "complete_thresh", kNumber},
    {"constant_heading", "heading_mismatch_var", "heading_mismatch_var", kPosted},
    {"constant_speed", "speed", "speed", kNumber},
    {"constant_speed", "speed_mismatch_var", "speed_mismatch_var", kPosted},
    {"constant_depth constant_heading constant_speed", "peakwidth", "peakwidth", kNumber},
    {"constant_depth constant_heading constant_speed", "basewidth", "basewidth", kNumber},
    {"constant_depth constant_heading constant_speed", "summitdelta", "summitdelta", kNumber},
    {"constant_depth constant_heading constant_speed", "summit_delta", "summitdelta", kNumber},
    {"@", "contact", "contact", kText},
    {"@", "them", "contact", kText},
    {"@", "on_no_contact_ok", "on_no_contact_ok", kFlag},
    {"@", "exit_on_filter_group", "exit_on_filter_group", kFlag},
    {"@", "post_per_contact_info", "post_per_contact_info", kFlag},
    {"@", "match_name", "match_name", kNames},
    {"@", "ignore_name", "ignore_name", kNames},
    {"@", "match_group", "match_group", kNames},
    {"@", "ignore_group", "ignore_group", kNames},
    {"@", "match_type", "match_type", kNames},
    {"@", "ignore_type", "ignore_type", kNames},
    {"@", "match_contact_group", "match_group", kNames},
    {"@", "ignore_contact_group", "ignore_group", kNames},
    {"@", "contact_type_required", "match_type", kNames},
    {"@", "cnflag", "cnflag", kTexts},
    {"@", "cn_flag", "cnflag", kTexts},
    {"avoid_collision colregs avoid_obstacle", "pwt_outer_dist", "pwt_outer_dist", kNumber},
    {"avoid_collision colregs avoid_obstacle", "pwt_inner_dist", "pwt_inner_dist", kNumber},
    {"avoid_collision colregs avoid_obstacle", "completed_dist", "completed_dist", kNumber},
    {"avoid_collision colregs avoid_obstacle", "min_util_cpa_dist", "min_util_cpa_dist", kNumber},
    {"avoid_collision colregs avoid_obstacle", "max_util_cpa_dist", "max_util_cpa_dist", kNumber},
    {"avoid_collision colregs", "active_outer_distance", "pwt_outer_dist", kNumber},
    {"avoid_collision colregs", "active_inner_distance", "pwt_inner_dist", kNumber},
    {"avoid_collision colregs", "completed_distance", "completed_dist", kNumber},
    {"avoid_collision colregs", "collision_distance", "min_util_cpa_dist", kNumber},
    {"avoid_collision colregs", "all_clear_distance", "max_util_cpa_dist", kNumber},
    {"avoid_collision colregs", "pwt_grade", "pwt_grade", kWord},
    {"avoid_collision colregs cut_range", "time_on_leg", "time_on_leg", kNumber},
    {"avoid_collision", "collision_depth", "collision_depth", kNumber},
    {"colregs", "turn_radius", "turn_radius", kNumber},
    {"colregs", "giveway_bow_dist", "giveway_bow_dist", kNumber},
    {"colregs", "headon_only", "headon_only", kFlag},
    {"colregs", "pts_port_turns_ok", "pts_port_turns_ok", kFlag},
    {"colregs", "can_disable", "can_disable", kFlag},
    {"avoid_obstacle", "id", "id", kText},
    {"avoid_obstacle", "polygon", "polygon", kPoints},
    {"avoid_obstacle", "poly", "polygon", kPoints},
    {"avoid_obstacle", "allowable_ttc", "allowable_ttc", kNumber},
    {"avoid_obstacle", "turn_radius", "turn_radius", kNumber},
    {"avoid_obstacle", "holonomic_ok", "holonomic_ok", kFlag},
    {"avoid_obstacle", "allstop_on_breach", "allstop_on_breach", kFlag},
    {"avoid_obstacle", "rng_flag", "rng_flag", kTexts},
    {"avoid_obstacle", "cpa_flag", "cpa_flag", kTexts},
    {"trail", "trail_range", "trail_range", kNumber},
    {"trail", "trail_angle", "trail_angle", kNumber},
    {"trail", "radius", "radius", kNumber},
    {"trail", "nm_radius", "nm_radius", kNumber},
    {"trail", "trail_angle_type", "trail_angle_type", kWord},
    {"trail shadow cut_range", "pwt_outer_dist", "pwt_outer_dist", kNumber},
    {"shadow", "max_range", "pwt_outer_dist", kNumber},
    {"shadow", "heading_peakwidth", "heading_peakwidth", kNumber},
    {"shadow", "heading_basewidth", "heading_basewidth", kNumber},
    {"shadow", "speed_peakwidth", "speed_peakwidth", kNumber},
    {"shadow", "speed_basewidth", "speed_basewidth", kNumber},
    {"cut_range", "pwt_inner_dist", "pwt_inner_dist", kNumber},
    {"cut_range", "giveup_dist", "giveup_dist", kNumber},
    {"cut_range", "patience", "patience", kNumber},
    {"cut_range", "pursueflag", "pursueflag", kTexts},
    {"cut_range", "pursue_flag", "pursueflag", kTexts},
    {"cut_range", "giveupflag", "giveupflag", kTexts},
    {"cut_range", "giveup_flag", "giveupflag", kTexts},
    {"convoy", "ideal_convoy_range", "range", kNumber},
    {"convoy", "radius", "radius", kNumber},
    {"convoy", "capture_radius", "radius", kNumber},
    {"convoy", "slip_radius", "nm_radius", kNumber},
    {"convoy", "nm_radius", "nm_radius", kNumber},
    {"convoy", "inter_mark_range", "mark_spacing", kNumber},
    {"convoy", "spd_max", "spd_max", kNumber},
    {"go_to_depth", "depth", "depths", kPairs, true},
    {"go_to_depth", "depths", "depths", kPairs, true},
    {"go_to_depth", "repeat", "repeat", kInteger},
    {"go_to_depth", "capture_delta", "capture_delta", kNumber},
    {"go_to_depth", "arrival_delta", "capture_delta", kNumber},
    {"go_to_depth", "capture_flag", "capture_flag", kTexts},
    {"go_to_depth", "arrival_flag", "capture_flag", kTexts},
    {"leg_run", "p1", "p1", kPoint, true},
    {"leg_run", "vx1", "p1", kPoint, true},
    {"leg_run", "p2", "p2", kPoint, true},
    {"leg_run", "vx2", "p2", kPoint, true},
    {"leg_run", "speed", "speed", kNumber},
    {"leg_run", "turn1_rad", "turn1_rad", kNumber},
    {"leg_run", "turn2_rad", "turn2_rad", kNumber},
    {"leg_run", "turn1_bias", "turn1_bias", kNumber},
    {"leg_run", "turn2_bias", "turn2_bias", kNumber},
    {"leg_run", "turn1_ext", "turn1_ext", kNumber},
    {"leg_run", "turn2_ext", "turn2_ext", kNumber},
    {"leg_run", "leg_spds", "leg_spds", kNumbers},
    {"leg_run", "turn1_dir", "turn1_dir", kWord},
    {"leg_run", "turn2_dir", "turn2_dir", kWord},
    {"leg_run", "leg_end_flag", "leg_end_flag", kTexts},
    {"leg_run", "legflag", "leg_end_flag", kTexts},
    {"leg_run", "leg_flag", "leg_end_flag", kTexts},
    {"leg_run", "leg_endflag", "leg_end_flag", kTexts},
    {"leg_run", "start_leg_flag", "start_leg_flag", kTexts},
    {"leg_run", "mid_flag", "mid_flag", kTexts},
    {"leg_run", "midflag", "mid_flag", kTexts},
    {"leg_run", "mid_leg_flag", "mid_flag", kTexts},
    {"leg_run", "midlegflag", "mid_flag", kTexts},
    {"leg_run", "midturnflag", "mid_turn_flag", kTexts},
    {"leg_run", "turn_end_flag", "end_turn_flag", kTexts},
    {"leg_run", "turn_endflag", "end_turn_flag", kTexts},
    {"leg_run", "start_turn_flag", "start_turn_flag", kTexts},
    {"leg_run", "end_turn_flag", "end_turn_flag", kTexts},
    {"leg_run", "mid_turn_flag", "mid_turn_flag", kTexts},
    {"op_region", "core_poly", "core_poly", kPoints, true},
    {"op_region", "core_polly", "core_poly", kPoints, true},
    {"op_region", "polygon", "core_poly", kPoints, true},
    {"op_region", "save_poly", "save_poly", kPoints, true},
    {"op_region", "halt_poly", "halt_poly", kPoints, true},
    {"op_region", "save_dist", "save_dist", kNumber},
    {"op_region", "halt_dist", "halt_dist", kNumber},
    {"op_region", "max_depth", "max_depth", kNumber},
    {"op_region", "min_altitude", "min_altitude", kNumber},
    {"op_region", "max_time", "max_time", kNumber},
    {"op_region", "trigger_entry_time", "trigger_entry_time", kNumber},
    {"op_region", "trigger_exit_time", "trigger_exit_time", kNumber},
    {"op_region", "recover_spd", "recover_spd", kNumber},
    {"op_region", "trigger_on_poly_entry", "trigger_on_poly_entry", kFlag},
    {"op_region", "soft_poly_breach", "soft_poly_breach", kFlag},
    {"op_region", "reset_var", "reset_var", kText},
    {"op_region", "save_flag", "save_flag", kTexts},
    {"op_region", "savex_flag", "savex_flag", kTexts},
    {"op_region", "breached_poly_flag", "breached_poly_flag", kTexts},
    {"op_region", "breached_depth_flag", "breached_depth_flag", kTexts},
    {"op_region", "breached_altitude_flag", "breached_altitude_flag", kTexts},
    {"op_region", "breached_time_flag", "breached_time_flag", kTexts},
    {"max_depth", "max_depth", "max_depth", kNumber},
    {"max_depth", "tolerance", "tolerance", kNumber},
    {"max_depth", "basewidth", "tolerance", kNumber},
    {"max_depth", "depth_slack_var", "depth_slack_var", kPosted},
    {"max_speed", "max_speed", "max_speed", kNumber},
    {"max_speed", "tolerance", "tolerance", kNumber},
    {"max_speed", "basewidth", "tolerance", kNumber},
    {"max_speed", "speed_slack_var", "speed_slack_var", kPosted},
    {"memory_turn_limit", "memory_time", "memory_time", kNumber},
    {"memory_turn_limit", "turn_range", "turn_range", kNumber},
    {"periodic_speed", "period_lazy", "period_lazy", kNumber},
    {"periodic_speed", "period_busy", "period_busy", kNumber},
    {"periodic_speed", "period_speed", "period_speed", kNumber},
    {"periodic_speed", "peakwidth", "peakwidth", kNumber},
    {"periodic_speed", "basewidth", "basewidth", kNumber},
    {"periodic_speed", "summit_delta", "summitdelta", kNumber},
    {"periodic_speed", "summitdelta", "summitdelta", kNumber},
    {"periodic_speed", "initially_busy", "initially_busy", kFlag},
    {"periodic_speed", "reset_upon_running", "reset_upon_running", kFlag},
    {"periodic_surface", "period", "period", kNumber},
    {"periodic_surface", "ascent_speed", "ascent_speed", kNumber},
    {"periodic_surface", "zero_speed_depth", "zero_speed_depth", kNumber},
    {"periodic_surface", "max_time_at_surface", "max_time_at_surface", kNumber},
    {"periodic_surface", "mark_variable", "mark_variable", kText},
    {"periodic_surface", "pending_status_var", "pending_status_var", kPosted},
    {"periodic_surface", "atsurface_status_var", "atsurface_status_var", kPosted},
    {"periodic_surface", "ascent_grade", "ascent_grade", kWord},
    {"fixed_turn", "fix_turn", "fix_turn", kNumber},
    {"fixed_turn", "mod_hdg", "mod_hdg", kNumber},
    {"fixed_turn", "timeout", "timeout", kNumber},
    {"fixed_turn", "turn_delay", "turn_delay", kNumber},
    {"fixed_turn", "turn_dir", "turn_dir", kWord},
    {"fixed_turn", "radius_rep_var", "radius_rep_var", kPosted},
    {"zigzag", "stem_hdg", "stem_hdg", kNumber},
    {"zigzag", "speed", "speed", kNumber},
    {"zigzag", "zig_angle", "zig_angle", kNumber},
    {"zigzag", "hdg_thresh", "hdg_thresh", kNumber},
    {"zigzag", "max_stem_odo", "max_stem_odo", kNumber},
    {"zigzag", "max_stem_dist", "max_stem_odo", kNumber},
    {"zigzag", "max_zig_legs", "max_zig_legs", kInteger},
    {"zigzag", "stem_on_active", "stem_on_active", kFlag},
    {"zigzag", "speed_on_active", "speed_on_active", kFlag},
    {"zigzag", "spd_on_active", "speed_on_active", kFlag},
    {"zigzag", "fierce_zigging", "fierce_zigging", kFlag},
    {"zigzag", "zig_first", "zig_first", kWord},
    {"zigzag", "zigflag", "zigflag", kTexts},
    {"zigzag", "zig_flag", "zigflag", kTexts},
    {"zigzag", "portflag", "zigflag", kTexts},
    {"zigzag", "zagflag", "zagflag", kTexts},
    {"zigzag", "zag_flag", "zagflag", kTexts},
    {"zigzag", "starflag", "zagflag", kTexts},
    {"test_failure", "burn_time", "burn_time", kNumber},
    {"maintain_heading", "peakwidth", "peakwidth", kNumber},
    {"maintain_heading", "basewidth", "basewidth", kNumber},
    {"maintain_heading", "summitdelta", "summitdelta", kNumber},
    {"heading_bias", "bias", "bias", kWord},
    {"hysteresis", "memory_time", "memory_time", kNumber},
    {"hysteresis", "min_heading_window", "min_heading_window", kNumber},
    {"hysteresis", "max_heading_window", "max_heading_window", kNumber},
    {"hysteresis", "max_window_utility", "max_window_utility", kNumber},
    {"min_altitude", "min_altitude", "min_altitude", kNumber},
    {"min_altitude", "missing_altitude_critical", "missing_altitude_critical", kFlag},
    {"rubber_band", "point", "point", kPoint},
    {"rubber_band", "points", "point", kPoint},
    {"rubber_band", "inner_radius", "inner_radius", kNumber},
    {"rubber_band", "outer_radius", "outer_radius", kNumber},
    {"rubber_band", "outer_speed", "outer_speed", kNumber},
    {"rubber_band", "extra_speed", "extra_speed", kNumber},
    {"rubber_band", "stiffness", "stiffness", kNumber},
    {"op_region", "buffer_dist", "save_dist", kNumber},
});

constexpr std::array kLostKeys = std::to_array<BhvLostKey>({
    {"*", "visual_hints", "how it is drawn: the viewer has a way of its own", false},
    {"*", "bearing_line_config", "how it is drawn: the viewer has a way of its own", false},
    {"*", "bearing_lines", "how it is drawn: the viewer has a way of its own", false},
    {"*", "bearing_line_show", "how it is drawn: the viewer has a way of its own", false},
    {"*", "bearing_line_label_show", "how it is drawn: the viewer has a way of its own", false},
    {"*", "draw_halt_status", "how it is drawn: the viewer has a way of its own", false},
    {"*", "draw_save_status", "how it is drawn: the viewer has a way of its own", false},
    {"*", "use_refinery", "not needed: the decision is exact", false},
    {"*", "check_plateaus", "not needed: the decision is exact", false},
    {"*", "check_validity", "not needed: the decision is exact", false},
    {"*", "pcheck_thresh", "not needed: the decision is exact", false},
    {"*", "build_info", "not needed: the decision is exact", false},
    {"*", "precision", "not needed: the decision is exact", false},
    {"*", "eval_tol", "not needed: the decision is exact", false},
    {"*", "us", "not needed", false},
    {"*", "i_understand_this_behavior_is_deprecated", "not needed", false},
    {"*", "warn_overshoot", "not needed", false},
    {"*", "post_recap_verbose", "not needed", false},
    {"*", "comms_policy", "what goes off-board is decided by flags and the broker", false},
    {"*", "post_mapping", "posted variables have the names of docs/reference/behaviors.md", true},
    {"*", "efficiency_measure", "posted variables have the names of docs/reference/behaviors.md",
     false},
    {"*", "time_remaining_var", "not posted here", false, true},
    {"*", "opregion_poly_var", "not posted here", false, true},
    {"*", "post_trail_dist_on_idle",
     "posted variables have the names of docs/reference/behaviors.md", false},
    {"@", "extrapolate", "contacts are extrapolated by their age: docs/vehicles/contacts.md",
     false},
    {"@", "decay", "contacts are extrapolated by their age: docs/vehicles/contacts.md", false},
    {"@", "decay_end", "contacts are extrapolated by their age: docs/vehicles/contacts.md", false},
    {"@ avoid_obstacle", "no_alert_request",
     "not needed: alerts follow from the behavior's own distances", false},
    {"@ avoid_obstacle", "obstacle_key",
     "not needed: alerts follow from the behavior's own distances", false},
    {"@", "match_region", "regions of contacts have no counterpart", true},
    {"@", "ignore_region", "regions of contacts have no counterpart", true},
    {"@", "exit_on_filter_region", "regions of contacts have no counterpart", true},
    {"@", "exit_on_filter_vname", "only exit_on_filter_group has a counterpart", true},
    {"@", "exit_on_filter_vtype", "only exit_on_filter_group has a counterpart", true},
    {"@", "exit_on_filter_name", "only exit_on_filter_group has a counterpart", true},
    {"@", "exit_on_filter_type", "only exit_on_filter_group has a counterpart", true},
    {"@", "strict_ignore", "only exit_on_filter_group has a counterpart", true},
    {"avoid_collision colregs", "roc_max_dampen", "without effect in MOOS-IvP too", false},
    {"avoid_collision colregs", "roc_max_heighten", "without effect in MOOS-IvP too", false},
    {"avoid_collision colregs", "roc_max_dampening", "without effect in MOOS-IvP too", false},
    {"avoid_collision colregs", "roc_max_heightening", "without effect in MOOS-IvP too", false},
    {"colregs", "avoid_mode", "the mode follows from the encounter", true},
    {"colregs", "avoid_submode", "the mode follows from the encounter", true},
    {"colregs", "velocity_filter", "distances do not depend on the contact's speed here", true},
    {"waypoint", "eager_prev_index_flag", "not needed", false},
    {"leg_run", "turn_pt_gap", "not needed", false},
    {"leg_run", "id", "not needed", false},
    {"fixed_turn full_stop", "stale_nav_thresh", "not needed", false},
    {"fixed_turn", "turn_spec", "one turn only: write a behavior for each", true},
    {"fixed_turn", "schedule_repeat", "one turn only: write a behavior for each", true},
    {"fixed_turn", "schedule", "one turn only: write a behavior for each", true},
    {"waypoint", "end_spd", "write end_speed, end_slow_dist and end_stop_dist", true},
    {"op_region", "dynamic_region_var", "the region is given in the file or by updates", true},
});

}  // namespace bhv_keys

namespace {

using bhv_keys::kContactKinds;
using bhv_keys::kLostKeys;
using bhv_keys::kTypes;

bool HasWord(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const size_t end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

bool IsOfKind(std::string_view kinds, std::string_view kind) {
  return kinds == "*" || HasWord(kinds, kind) || (HasWord(kinds, "@") && IsContactKind(kind));
}

template <class Row, size_t N>
const Row* FindRow(const std::array<Row, N>& rows, std::string_view kind,
                   std::string_view moos_key) {
  const std::string key = LowerCase(moos_key.substr(0, 64));
  for (const Row& row : rows) {
    if (row.moos_key == key && IsOfKind(row.kinds, kind)) return &row;
  }
  return nullptr;
}

}  // namespace

std::string_view KindOfBhv(std::string_view type) {
  constexpr std::string_view kPrefix = "bhv_";
  std::string name = LowerCase(type.substr(0, 64));
  if (name.starts_with(kPrefix)) name.erase(0, kPrefix.size());
  for (const BhvType& row : kTypes) {
    const bool has_versions = row.type.ends_with('*');
    const std::string_view stem = row.type.substr(0, row.type.size() - (has_versions ? 1 : 0));
    if (name == stem) return row.kind;
    // A version, "v22" or "x", but not another word.
    if (has_versions && name.starts_with(stem) && name.size() <= stem.size() + 4) return row.kind;
  }
  return {};
}

std::optional<std::string_view> NearestKind(std::string_view type) {
  // Of others' behaviors, as their missions use them.
  constexpr auto kNearest = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"scout", "waypoint"},
      {"zigleg", "zigzag"},
      {"pulse", ""},
      {"bearingline", ""},
      {"pmodelview", ""},
      {"hsline", ""},
  });
  constexpr std::string_view kPrefix = "bhv_";
  std::string name = LowerCase(type.substr(0, 64));
  if (name.starts_with(kPrefix)) name.erase(0, kPrefix.size());
  for (const auto& [known, kind] : kNearest) {
    if (name == known) return kind;
  }
  return std::nullopt;
}

bool IsContactKind(std::string_view kind) { return HasWord(kContactKinds, kind); }

const BhvKey* FindBhvKey(std::string_view kind, std::string_view moos_key) {
  return FindRow(bhv_keys::kKeys, kind, moos_key);
}

const BhvLostKey* FindLostBhvKey(std::string_view kind, std::string_view moos_key) {
  return FindRow(kLostKeys, kind, moos_key);
}

std::vector<BhvType> AllBhvTypes() { return {kTypes.begin(), kTypes.end()}; }

std::vector<BhvKey> AllBhvKeys() { return {bhv_keys::kKeys.begin(), bhv_keys::kKeys.end()}; }

}  // namespace shoal
