#include <utility>

#include "lib/helm/behaviors/behavior_runner.h"

namespace shoal {
namespace {

/// Calls `each` with the name and the list of each flag that only this kind of behavior has.
template <class Options, class Each>
void EachList(const Options& o, const Each& each) {
  if constexpr (requires { o.wptflag; }) each("wptflag", o.wptflag);
  if constexpr (requires { o.cycleflag; }) each("cycleflag", o.cycleflag);
  if constexpr (requires { o.save_flag; }) each("save_flag", o.save_flag);
  if constexpr (requires { o.savex_flag; }) each("savex_flag", o.savex_flag);
  if constexpr (requires { o.breached_poly_flag; }) {
    each("breached_poly_flag", o.breached_poly_flag);
    each("breached_depth_flag", o.breached_depth_flag);
    each("breached_altitude_flag", o.breached_altitude_flag);
    each("breached_time_flag", o.breached_time_flag);
  }
  if constexpr (requires { o.rng_flag; }) each("rng_flag", o.rng_flag);
  if constexpr (requires { o.cpa_flag; }) each("cpa_flag", o.cpa_flag);
  if constexpr (requires { o.pursueflag; }) each("pursueflag", o.pursueflag);
  if constexpr (requires { o.giveupflag; }) each("giveupflag", o.giveupflag);
  if constexpr (requires { o.capture_flag; }) each("capture_flag", o.capture_flag);
  if constexpr (requires { o.leg_end_flag; }) {
    each("leg_end_flag", o.leg_end_flag);
    each("start_leg_flag", o.start_leg_flag);
    each("mid_flag", o.mid_flag);
    each("start_turn_flag", o.start_turn_flag);
    each("end_turn_flag", o.end_turn_flag);
    each("mid_turn_flag", o.mid_turn_flag);
  }
  if constexpr (requires { o.zigflag; }) {
    each("zigflag", o.zigflag);
    each("zagflag", o.zagflag);
  }
}

/// Calls `each` with each variable whose name the mission gives and that the behavior posts.
template <class Options, class Each>
void EachVariable(const Options& o, const Each& each) {
  if constexpr (requires { o.index_var; }) {
    const std::string suffix = o.post_suffix.empty() ? "" : "_" + o.post_suffix;
    for (const std::string* name : {&o.index_var, &o.cycle_var, &o.status_var}) {
      if (!name->empty()) each(*name + suffix);
    }
    each(o.dist_to_next_var);
    each(o.dist_to_prev_var);
  }
  if constexpr (requires { o.depth_mismatch_var; }) each(o.depth_mismatch_var);
  if constexpr (requires { o.heading_mismatch_var; }) each(o.heading_mismatch_var);
  if constexpr (requires { o.speed_mismatch_var; }) each(o.speed_mismatch_var);
  if constexpr (requires { o.radius_rep_var; }) each(o.radius_rep_var);
  if constexpr (requires { o.depth_slack_var; }) each(o.depth_slack_var);
  if constexpr (requires { o.speed_slack_var; }) each(o.speed_slack_var);
  if constexpr (requires { o.pending_status_var; }) {
    each(o.pending_status_var);
    each(o.atsurface_status_var);
  }
}

}  // namespace

const std::vector<std::string>* OwnFlags(const AnyBehavior& what, std::string_view name) {
  const std::vector<std::string>* found = nullptr;
  const auto look = [&](std::string_view key, const std::vector<std::string>& list) {
    if (key == name) found = &list;
  };
  std::visit([&](const auto& options) { EachList(options, look); }, what);
  return found;
}

std::vector<const std::vector<std::string>*> EachOwnFlags(const AnyBehavior& what) {
  std::vector<const std::vector<std::string>*> lists;
  const auto add = [&](std::string_view, const std::vector<std::string>& list) {
    lists.push_back(&list);
  };
  std::visit([&](const auto& options) { EachList(options, add); }, what);
  return lists;
}

std::vector<std::string> NamedVariables(const AnyBehavior& what) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty()) names.push_back(name);
  };
  std::visit([&](const auto& options) { EachVariable(options, add); }, what);
  return names;
}

}  // namespace shoal
