#include "apps/shore_broker/message_checks.h"

#include <cmath>

#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

/// Each text of a message but its value and its destinations: max_msg_length does not count them,
/// and they go out again for every receiver.
constexpr size_t kLongestText_bytes = 1000;

}  // namespace

bool AllNumbersAreFinite(const node_report_t& report) {
  for (const double number :
       {report.x_m, report.y_m, report.depth_m, report.altitude_m, report.lat_deg, report.lon_deg,
        report.speed_mps, report.heading_deg, report.speed_over_ground_mps,
        report.course_over_ground_deg, report.length_m}) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

std::string LegalOrEmpty(const std::string& name) { return IsLegalVehicleName(name) ? name : ""; }

std::string_view ProblemOf(const node_message_t& message) {
  if (!IsLegalVehicleName(message.src_node)) return "src_node is not a vehicle's name";
  if (message.dest_node.empty() && message.dest_group.empty()) {
    return "neither dest_node nor dest_group";
  }
  if (message.var_name.empty()) return "no var_name";
  if (message.is_double != 0 && !message.string_val.empty()) {
    return "both string_val and double_val";
  }
  if (message.is_double != 0 && !std::isfinite(message.double_val)) {
    return "double_val is not a finite number";
  }
  if (message.ack_requested != 0 && message.ack_id.empty()) return "ack_requested without ack_id";
  for (const std::string* text : {&message.src_app, &message.dest_group, &message.var_name,
                                  &message.color, &message.ack_id}) {
    if (text->size() > kLongestText_bytes) {
      return "src_app, dest_group, var_name, color or ack_id has more than 1000 bytes";
    }
  }
  return {};
}

}  // namespace shoal
