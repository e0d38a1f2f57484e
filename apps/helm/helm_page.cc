#include "apps/helm/helm_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

constexpr size_t kMaxContactsShown = 10;

std::string TasksText(const Vehicle& vehicle) {
  std::string text;
  for (const Task& task : vehicle.tasks) text += fmt::format(" {} ({})", task.name, KindOf(task));
  return text.empty() ? " none" : text;
}

std::string CommandsText(const std::array<int64_t, kNumOrderKinds>& num_executed) {
  std::string text;
  for (size_t i = 0; i < num_executed.size(); ++i) {
    if (num_executed[i] == 0) continue;
    text += fmt::format(" {} {}", Name(static_cast<OrderKind>(i)), num_executed[i]);
  }
  return text.empty() ? " none" : text;
}

std::string GuidanceText(const guidance_t& guidance, const nav_t& nav) {
  std::string text = fmt::format(
      "Guidance: pitch {:.1f} deg desired, {:.1f} actual; crab angle by ALOS {:.1f} deg\n",
      guidance.pitch_deg, nav.pitch_deg, guidance.crab_deg);
  for (const guidance_layer_t& layer : guidance.layers) {
    text += fmt::format("    {:<18} asks for {:.2f} m/s, weight {:.3f}\n", layer.name,
                        layer.speed_mps, layer.weight);
  }
  return text;
}

std::string ContactsText(const ReportedVehicles& contacts, const nav_t& nav, int64_t utime) {
  const Eigen::Vector2d own_position_m(nav.x_m, nav.y_m);
  std::vector<std::tuple<double, std::string, double>> rows;  // Range, name, age.
  for (const auto& [name, contact] : contacts) {
    const double age_s =
        (static_cast<double>(utime) - static_cast<double>(contact.reported_utime)) / 1e6;
    rows.emplace_back((contact.position_m - own_position_m).norm(), Printable(name), age_s);
  }
  std::sort(rows.begin(), rows.end());
  std::string text = fmt::format("Contacts: {}\n", rows.size());
  for (size_t i = 0; i < std::min(rows.size(), kMaxContactsShown); ++i) {
    const auto& [range_m, name, age_s] = rows[i];
    text += fmt::format("    {:<16} range {:8.1f} m, age {:6.1f} s\n", name, range_m, age_s);
  }
  return text;
}

}  // namespace

std::string HelmPageText(const HelmPageFacts& facts) {
  const Vehicle& vehicle = facts.vehicle;
  const HelmStates& states = facts.states;
  const helm_state_t& state = facts.state;
  const nav_t& nav = facts.nav;
  const desired_t& desired = facts.desired;
  const actuators_t& actuators = facts.actuators;
  const HelmCounters& counters = facts.counters;
  std::string text = fmt::format(
      "Configuration:\n"
      "    Vehicle: {} ({})\n"
      "    Tasks:{}\n"
      "    Return point: x {:.1f} m, y {:.1f} m\n"
      "    NAV time-out: {:.1f} s, deploy at start: {}\n"
      "    {}\n",
      vehicle.name, FactsOfModel(vehicle.model).name, TasksText(vehicle),
      vehicle.return_task.point_m.x(), vehicle.return_task.point_m.y(),
      vehicle.helm_options.nav_timeout_s, vehicle.helm_options.deploy_at_start ? "yes" : "no",
      facts.gains);
  text += fmt::format(
      "State: {} (all-stop: {})\n"
      "    Task: {} ({}), waypoint {}, laps done {}\n"
      "    Steers for: x {:.1f} m, y {:.1f} m, distance {:.1f} m, cross-track error {:.1f} m\n"
      "               Desired   Actual\n"
      "    Heading: {:9.1f}{:9.1f} deg\n"
      "    Speed:   {:9.2f}{:9.2f} m/s\n"
      "    Depth:   {:9.1f}{:9.1f} m\n"
      "    Position: x {:.2f} m, y {:.2f} m\n"
      "    Thrust {:.1f} % ({:.0f} rpm), rudder {:.1f} deg, stern plane {:.1f} deg\n",
      Name(states.mode()), states.all_stop(), state.task.empty() ? "none" : state.task,
      state.task_kind, state.waypoint_index, state.laps_done, state.waypoint_x_m,
      state.waypoint_y_m, state.distance_m, state.cross_track_error_m, desired.heading_deg,
      nav.heading_deg, desired.speed_mps, nav.speed_mps, desired.depth_m, nav.z_m, nav.x_m, nav.y_m,
      actuators.thrust_pct, actuators.propeller_rpm, actuators.rudder_deg,
      actuators.stern_plane_deg);
  if (facts.guidance != nullptr) text += GuidanceText(*facts.guidance, nav);
  text += fmt::format(
      "Received:\n"
      "    NAV: {} ({} refused)\n"
      "    Commands:{} ({} refused)\n"
      "    NODE_REPORT: {}\n"
      "    Undecodable: {}\n"
      "{}",
      counters.num_navs, counters.num_bad_navs, CommandsText(counters.num_executed),
      counters.num_refused, counters.num_reports, counters.num_undecodable,
      ContactsText(facts.contacts, nav, facts.utime));
  return text;
}

}  // namespace shoal
