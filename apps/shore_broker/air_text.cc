#include "apps/shore_broker/air_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "apps/shore_broker/message_checks.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/comms/swarm/report_message.h"
#include "lib/run/moos_text/node_message_text.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {

namespace {

std::vector<uint8_t> BytesOf(std::string_view text) { return {text.begin(), text.end()}; }

std::string TextOf(std::span<const uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

/// LCM's texts end at the first of these.
bool HasZeroByte(std::span<const uint8_t> bytes) {
  return std::ranges::find(bytes, uint8_t{0}) != bytes.end();
}

/// Any number may be in a report: the difference of two may be no int64_t.
double SecondsAfter(int64_t start_utime, int64_t utime) {
  int64_t passed_us = 0;
  if (!__builtin_sub_overflow(utime, start_utime, &passed_us)) {
    return Seconds(passed_us);
  }
  return (static_cast<double>(utime) - static_cast<double>(start_utime)) / 1e6;
}

void AppendUnlessEmpty(std::string_view key, std::string_view value, std::string* text) {
  if (!value.empty()) AppendField(key, value, text);
}

/// True where a receiver believes these numbers; NaN is neither.
bool IsPlausible(const Eigen::Vector3f& vector, double limit) {
  return vector.cwiseAbs().cast<double>().maxCoeff() <= limit && vector.allFinite();
}

void SetPosition(const Eigen::Vector3f& position_m, const GeoPoint& origin, node_report_t* report) {
  report->x_m = position_m.x();
  report->y_m = position_m.y();
  report->depth_m = position_m.z();
  const GeoPoint point = LocalFrame(origin).ToGeo({report->x_m, report->y_m});
  report->lat_deg = point.lat_deg;
  report->lon_deg = point.lon_deg;
}

void SetVelocity(const Eigen::Vector3f& velocity_mps, node_report_t* report) {
  const Eigen::Vector2d horizontal = velocity_mps.head<2>().cast<double>();
  report->speed_over_ground_mps = horizontal.norm();
  report->course_over_ground_deg = RadToDeg(HeadingOf(horizontal));
  report->speed_mps = report->speed_over_ground_mps;
  report->heading_deg = report->course_over_ground_deg;
}

}  // namespace

std::vector<uint8_t> AirBytes(const node_report_t& report, uint32_t address, int64_t start_utime) {
  const Eigen::Vector2d velocity_mps =
      report.speed_over_ground_mps * UnitVector(DegToRad(report.course_over_ground_deg));
  return EncodeReport(
      {.group_id = report.group.empty() ? uint8_t{0} : static_cast<uint8_t>(report.group.front()),
       .reporter_id = address,
       .position_m = Eigen::Vector3d(report.x_m, report.y_m, report.depth_m).cast<float>(),
       .velocity_mps = Eigen::Vector3d(velocity_mps.x(), velocity_mps.y(), 0).cast<float>(),
       .time_stamp_s = static_cast<float>(SecondsAfter(start_utime, report.utime))});
}

std::vector<uint8_t> AirBytes(const node_message_t& message) {
  std::string text;
  AppendField("src_node", message.src_node, &text);
  AppendUnlessEmpty("src_app", message.src_app, &text);
  AppendUnlessEmpty("dest_node", message.dest_node, &text);
  AppendUnlessEmpty("dest_group", message.dest_group, &text);
  AppendField("var_name", message.var_name, &text);
  if (message.is_double != 0) {
    AppendField("double_val", NumberText(message.double_val), &text);
  } else {
    AppendField("string_val", message.string_val, &text);
  }
  AppendUnlessEmpty("color", message.color, &text);
  if (message.ack_requested != 0) AppendField("ack", "true", &text);
  AppendUnlessEmpty("ack_id", message.ack_id, &text);
  return BytesOf(text);
}

std::vector<uint8_t> AirBytes(const ack_message_t& ack) {
  std::string text;
  AppendField("src_node", ack.src_node, &text);
  AppendField("dest_node", ack.dest_node, &text);
  AppendField("ack_id", ack.ack_id, &text);
  return BytesOf(text);
}

std::optional<node_report_t> UnderstandDamaged(const node_report_t& report,
                                               std::span<const uint8_t> sent,
                                               std::span<const uint8_t> arrived,
                                               const ReportContext& context) {
  const std::optional<ReportMessage> before = DecodeReport(sent);
  const std::optional<ReportMessage> after = DecodeReport(arrived);
  if (!before || !after || after->flag != kReportFlag) return std::nullopt;
  node_report_t understood = report;
  if (after->group_id != before->group_id) {
    if (std::isalnum(after->group_id) == 0) return std::nullopt;
    understood.group = std::string(1, static_cast<char>(after->group_id));
  }
  if (after->reporter_id != before->reporter_id) {
    const std::string_view name = context.vehicle_at(after->reporter_id);
    if (name.empty() || VehicleKey(name) == VehicleKey(context.receiver)) return std::nullopt;
    understood.name = name;
  }
  // Bytes are compared, not numbers: NaN is equal to nothing.
  const auto differs = [&](size_t begin, size_t size) {
    return !std::ranges::equal(sent.subspan(begin, size), arrived.subspan(begin, size));
  };
  constexpr size_t kPosition = 9;
  constexpr size_t kVelocity = 21;
  constexpr size_t kTimeStamp = 33;
  if (differs(kPosition, 12)) {
    if (!IsPlausible(after->position_m, kPlausiblePosition_m)) return std::nullopt;
    SetPosition(after->position_m, context.origin, &understood);
  }
  if (differs(kVelocity, 12)) {
    if (!IsPlausible(after->velocity_mps, kPlausibleSpeed_mps)) return std::nullopt;
    SetVelocity(after->velocity_mps, &understood);
  }
  if (differs(kTimeStamp, 4)) {
    const double now_s = Seconds(context.now_utime - context.start_utime);
    const auto stamp_s = static_cast<double>(after->time_stamp_s);
    if (!(stamp_s >= 0 && stamp_s <= now_s)) return std::nullopt;
    understood.utime = context.start_utime + Microseconds(stamp_s);
  }
  return understood;
}

std::optional<node_message_t> UnderstandDamaged(const node_message_t& message,
                                                std::span<const uint8_t> arrived) {
  if (HasZeroByte(arrived)) return std::nullopt;
  const Result<MoosNodeMessage> parsed = ParseNodeMessage(TextOf(arrived));
  if (!parsed.ok()) return std::nullopt;
  node_message_t understood = message;
  understood.src_node = parsed->src_node;
  understood.src_app = parsed->src_app;
  understood.dest_node = parsed->dest_node;
  understood.dest_group = parsed->dest_group;
  understood.var_name = parsed->var_name;
  understood.string_val = parsed->string_val;
  understood.is_double = parsed->double_val ? 1 : 0;
  understood.double_val = parsed->double_val.value_or(0);
  understood.color = parsed->color;
  understood.ack_requested = parsed->ack ? 1 : 0;
  understood.ack_id = parsed->ack_id;
  if (!ProblemOf(understood).empty()) return std::nullopt;
  return understood;
}

std::optional<ack_message_t> UnderstandDamaged(const ack_message_t& ack,
                                               std::span<const uint8_t> arrived) {
  if (HasZeroByte(arrived)) return std::nullopt;
  const Result<std::vector<MoosField>> fields = ParseFields(TextOf(arrived));
  if (!fields.ok()) return std::nullopt;
  ack_message_t understood = ack;
  int num_keys = 0;
  for (const MoosField& field : *fields) {
    for (const auto& [key, member] : {std::pair{"src_node", &ack_message_t::src_node},
                                      std::pair{"dest_node", &ack_message_t::dest_node},
                                      std::pair{"ack_id", &ack_message_t::ack_id}}) {
      if (field.key != key) continue;
      understood.*member = field.value;
      ++num_keys;
    }
  }
  const bool is_sound = num_keys == 3 && IsLegalVehicleName(understood.src_node) &&
                        IsLegalVehicleName(understood.dest_node) && !understood.ack_id.empty();
  if (!is_sound) return std::nullopt;
  return understood;
}

}  // namespace shoal
