#include "apps/shore_broker/apply_control.h"

#include <fmt/format.h>

#include <string>

#include "lib/bus/bus/control_message.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

void Refuse(const std::string& text, int64_t utime, StatusLog* log) {
  log->Warn(text);
  log->Event(utime, text);
}

bool RequestFullReports(const ControlRow& row, const unc_control_t& control, int64_t utime,
                        Router* router, StatusLog* log) {
  if (router->RequestFullReports(control.vehicle)) {
    log->Event(utime, fmt::format("{}: {} receives the next report of each other vehicle",
                                  row.channel, control.vehicle));
  } else {
    Refuse(fmt::format("{} refused: no vehicle '{}' is known", row.channel,
                       Printable(control.vehicle)),
           utime, log);
  }
  return false;
}

bool ApplyFactor(const ControlRow& row, const unc_control_t& control, int64_t utime, Router* router,
                 StatusLog* log) {
  if (!IsLegalVehicleName(control.vehicle)) {
    Refuse(fmt::format("{} refused: it is for one vehicle, and '{}' is not a vehicle's name",
                       row.channel, Printable(control.vehicle)),
           utime, log);
    return false;
  }
  std::optional<LinkFactors> factors = router->FindFactors(control.vehicle);
  if (!factors) {
    Refuse(fmt::format("{} refused: too many vehicles that are not of the mission", row.channel),
           utime, log);
    return false;
  }
  const double old = GetFactor(row, *factors);
  if (!IsPossible(row, control.value)) {
    Refuse(fmt::format("{} refused: {} for {} is impossible (allowed: {}); {} stays", row.channel,
                       control.value, control.vehicle, row.values, old),
           utime, log);
    return false;
  }
  SetFactor(row, control.value, &*factors);
  router->SetFactors(control.vehicle, *factors);
  log->Event(utime,
             fmt::format("{}: {} {} (was {})", row.channel, control.vehicle, control.value, old));
  return control.value != old;
}

bool ApplyRule(const ControlRow& row, const unc_control_t& control, int64_t utime, Router* router,
               StatusLog* log) {
  RoutingRules rules = router->rules();
  const ControlValue old = GetRule(row, rules);
  const ControlValue value = ValueOf(control);
  const std::string word = Printable(ControlWord(row, value));
  const std::string old_word = Printable(ControlWord(row, old));
  if (!control.vehicle.empty()) {
    Refuse(fmt::format("{} refused: it holds for all, not for one vehicle; {} stays", row.channel,
                       old_word),
           utime, log);
    return false;
  }
  if (!IsPossible(row, value)) {
    const std::string given =
        row.type == ControlType::kText ? Printable(value.text) : fmt::format("{}", value.number);
    Refuse(fmt::format("{} refused: {} is impossible (allowed: {}); {} stays", row.channel, given,
                       row.values, old_word),
           utime, log);
    return false;
  }
  SetRule(row, value, &rules);
  const bool has_changed = rules != router->rules();
  router->SetRules(rules);
  log->Event(utime, fmt::format("{}: {} (was {})", row.channel, word, old_word));
  return has_changed;
}

}  // namespace

bool ApplyControl(const ControlRow& row, const unc_control_t& control, int64_t utime,
                  Router* router, StatusLog* log) {
  if (row.type == ControlType::kRequest) {
    return RequestFullReports(row, control, utime, router, log);
  }
  return row.of_vehicle ? ApplyFactor(row, control, utime, router, log)
                        : ApplyRule(row, control, utime, router, log);
}

}  // namespace shoal
