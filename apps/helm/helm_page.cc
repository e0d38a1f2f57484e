// The helm's status page.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "apps/helm/helm_app.h"

namespace shoal {

namespace {

constexpr size_t kMaxContactsShown = 10;

std::string TasksText(const Vehicle& vehicle) {
  std::string text;
  for (const Task& task : vehicle.tasks) text += fmt::format(" {} ({})", task.name, KindOf(task));
  return text.empty() ? " none" : text;
}

std::string CommandsText(const std::array<int64_t, kNumOrderKinds>& num_obeyed) {
  std::string text;
  for (size_t i = 0; i < num_obeyed.size(); ++i) {
    if (num_obeyed[i] == 0) continue;
    text += fmt::format(" {} {}", Name(static_cast<OrderKind>(i)), num_obeyed[i]);
  }
  return text.empty() ? " none" : text;
}

}  // namespace

StatusPage HelmApp::Status() const {
  StatusPage page;
  page.text = fmt::format(
      "Configuration:\n"
      "    Vehicle: {} ({})\n"
      "    Tasks:{}\n"
      "    Return point: x {:.1f} m, y {:.1f} m\n"
      "    NAV time-out: {:.1f} s, deploy at start: {}\n"
      "    {}\n",
      vehicle_.name, FactsOfModel(vehicle_.model).name, TasksText(vehicle_),
      vehicle_.return_task.point_m.x(), vehicle_.return_task.point_m.y(),
      vehicle_.helm_options.nav_timeout_s, vehicle_.helm_options.deploy_at_start ? "yes" : "no",
      pilot_->GainsText());
  page.text += fmt::format(
      "State: {} (all-stop: {})\n"
      "    Task: {} ({}), waypoint {}, laps done {}\n"
      "    Steers for: x {:.1f} m, y {:.1f} m, distance {:.1f} m, cross-track error {:.1f} m\n"
      "               Desired   Actual\n"
      "    Heading: {:9.1f}{:9.1f} deg\n"
      "    Speed:   {:9.2f}{:9.2f} m/s\n"
      "    Depth:   {:9.1f}{:9.1f} m\n"
      "    Position: x {:.2f} m, y {:.2f} m\n"
      "    Thrust {:.1f} % ({:.0f} rpm), rudder {:.1f} deg, stern plane {:.1f} deg\n",
      Name(states_.mode()), states_.all_stop(), state_.task.empty() ? "none" : state_.task,
      state_.task_kind, state_.waypoint_index, state_.laps_done, state_.waypoint_x_m,
      state_.waypoint_y_m, state_.distance_m, state_.cross_track_error_m, desired_.heading_deg,
      nav_.heading_deg, desired_.speed_mps, nav_.speed_mps, desired_.depth_m, nav_.z_m, nav_.x_m,
      nav_.y_m, actuators_.thrust_pct, actuators_.propeller_rpm, actuators_.rudder_deg,
      actuators_.stern_plane_deg);
  page.text += fmt::format(
      "Heard:\n"
      "    NAV: {} ({} refused)\n"
      "    Commands:{} ({} refused)\n"
      "    NODE_REPORT: {}\n"
      "    Undecodable: {}\n"
      "{}",
      num_navs_, num_bad_navs_, CommandsText(num_obeyed_), num_refused_, num_reports_,
      bus_.counters().undecodable, ContactsText());
  log_.AppendTo(&page);
  return page;
}

std::string HelmApp::ContactsText() const {
  const Eigen::Vector2d own_position_m(nav_.x_m, nav_.y_m);
  std::vector<std::tuple<double, std::string, double>> rows;  // Range, name, age.
  for (const auto& [name, contact] : contacts_) {
    const double age_s =
        (static_cast<double>(utime_.value_or(0)) - static_cast<double>(contact.reported_utime)) /
        1e6;
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

}  // namespace shoal
