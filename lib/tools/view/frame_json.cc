#include "lib/tools/view/frame_json.h"

#include <algorithm>

#include "lib/comms/routing/control.h"
#include "lib/tools/view/json_writer.h"

namespace shoal {

namespace {

template <class T, class F>
void WriteOrNull(const std::optional<T>& value, JsonWriter* json, F write) {
  if (value) {
    write(*value);
  } else {
    json->Null();
  }
}

void WriteClock(const ViewClock& clock, JsonWriter* json) {
  json->BeginObject().Text("state", clock.state).Key("warp");
  WriteOrNull(clock.warp, json, [&](double warp) { json->Number(warp, 3); });
  json->Key("factor");
  WriteOrNull(clock.factor, json, [&](double factor) { json->Number(factor, 2); });
  json->Key("awaited").BeginArray();
  for (const std::string& name : clock.awaited) json->Text(name);
  json->EndArray().Text("note", clock.note).EndObject();
}

void WriteNav(const Scene& scene, const nav_t& nav, JsonWriter* json) {
  json->BeginObject()
      .Number("t", scene.SecondsOf(nav.utime), kMilliseconds)
      .Number("x", nav.x_m, kCentimetres)
      .Number("y", nav.y_m, kCentimetres)
      .Number("depth", nav.z_m, kCentimetres)
      .Number("heading", nav.heading_deg, kTenths)
      .Number("speed", nav.speed_mps, 2)
      .Number("course", nav.course_over_ground_deg, kTenths)
      .Number("sog", nav.speed_over_ground_mps, 2)
      .Number("pitch", nav.pitch_deg, kTenths)
      .Number("roll", nav.roll_deg, kTenths)
      .Key("altitude");
  if (nav.altitude_m < 0) {
    json->Null();
  } else {
    json->Number(nav.altitude_m, kCentimetres);
  }
  json->EndObject();
}

void WriteReport(const Scene& scene, const ReceivedReport& report, JsonWriter* json) {
  json->BeginObject()
      .Number("t", scene.SecondsOf(report.utime), kMilliseconds)
      .Number("x", report.x_m, kCentimetres)
      .Number("y", report.y_m, kCentimetres)
      .Number("depth", report.depth_m, kCentimetres)
      .Number("heading", report.heading_deg, kTenths)
      .Number("speed", report.speed_mps, 2)
      .Integer("index", report.index)
      .EndObject();
}

void WriteHelm(const Scene& scene, const helm_state_t& helm, JsonWriter* json) {
  json->BeginObject()
      .Number("t", scene.SecondsOf(helm.utime), kMilliseconds)
      .Text("state", helm.state)
      .Text("task", helm.task)
      .Text("kind", helm.task_kind)
      .Text("all_stop", helm.all_stop)
      .Integer("waypoint", helm.waypoint_index)
      .Integer("laps", helm.laps_done)
      .Key("to");
  if (helm.waypoint_index < 0) {
    json->Null();
  } else {
    json->BeginArray()
        .Number(helm.waypoint_x_m, kCentimetres)
        .Number(helm.waypoint_y_m, kCentimetres)
        .Number(helm.waypoint_z_m, kCentimetres)
        .EndArray();
  }
  json->Number("distance", helm.distance_m, kCentimetres)
      .Number("cross_track", helm.cross_track_error_m, kCentimetres)
      .EndObject();
}

void WriteVehicle(const Scene& scene, const SceneVehicle& vehicle, JsonWriter* json) {
  json->BeginObject()
      .Text("name", vehicle.name)
      .Text("type", vehicle.type)
      .Text("color", vehicle.color)
      .Text("group", vehicle.group)
      .Number("length_m", vehicle.length_m, kCentimetres)
      .Key("nav");
  WriteOrNull(vehicle.nav, json, [&](const nav_t& nav) { WriteNav(scene, nav, json); });
  json->Key("report");
  WriteOrNull(vehicle.report, json,
              [&](const ReceivedReport& report) { WriteReport(scene, report, json); });
  json->Boolean("stale", scene.IsStale(vehicle)).Key("helm");
  WriteOrNull(vehicle.helm, json, [&](const helm_state_t& helm) { WriteHelm(scene, helm, json); });
  ForEachShownChannel([&]<class Row, size_t kRow>() {
    json->Key(Row::kKey);
    WriteOrNull(std::get<kRow>(vehicle.shown), json,
                [&](const auto& message) { Row::Write(message, json); });
  });
  json->Text("mode", vehicle.report ? std::string_view(vehicle.report->mode) : "")
      .Boolean("outside", vehicle.outside)
      .EndObject();
}

void WriteRules(const RulesInForce& rules, JsonWriter* json) {
  json->BeginObject()
      .Number("comms_range_m", rules.comms_range_m, kCentimetres)
      .Number("critical_range_m", rules.critical_range_m, kCentimetres)
      .Number("stale_time_s", rules.stale_time_s, kMilliseconds)
      .Number("drop_percentage", rules.drop_percentage, 3)
      .Text("reports_over", TextOf(rules.reports_over))
      .Text("messages_over", TextOf(rules.messages_over))
      .Key("factors")
      .BeginObject();
  for (const auto& [vehicle, factors] : rules.factors) {
    json->KeyText(vehicle)
        .BeginObject()
        .Number("stealth", factors.stealth, 3)
        .Number("earange", factors.earange, 3)
        .EndObject();
  }
  json->EndObject().Key("shown").BeginObject();
  for (const ControlRow& row : ControlTable()) {
    if (!row.of_vehicle) json->Text(row.rule, ShownValue(row, rules));
  }
  json->EndObject().EndObject();
}

void WritePulse(const Scene& scene, const ViewPulse& pulse, JsonWriter* json) {
  json->BeginObject()
      .Integer("id", pulse.id)
      .Number("t", scene.SecondsOf(pulse.utime), kMilliseconds)
      .Key("from")
      .BeginArray()
      .Number(pulse.sx_m, kCentimetres)
      .Number(pulse.sy_m, kCentimetres)
      .EndArray()
      .Key("to")
      .BeginArray()
      .Number(pulse.tx_m, kCentimetres)
      .Number(pulse.ty_m, kCentimetres)
      .EndArray()
      .Number("width", pulse.width_m, kCentimetres)
      .Number("duration", pulse.duration_s, kMilliseconds)
      .Number("fill", pulse.fill, 3)
      .Text("label", pulse.label)
      .Text("kind", pulse.of_message ? "message" : "report")
      .Text("color", pulse.color)
      .EndObject();
}

void WritePacket(const Scene& scene, const AcousticPacket& packet, JsonWriter* json) {
  json->BeginObject().Integer("id", packet.id).Text("source", packet.source).Key("from");
  WriteOrNull(packet.from_m, json, [&](const std::pair<double, double>& from_m) {
    json->BeginArray()
        .Number(from_m.first, kCentimetres)
        .Number(from_m.second, kCentimetres)
        .EndArray();
  });
  json->Number("sent", scene.SecondsOf(packet.sent_utime), kMilliseconds)
      .Number("air", packet.air_s, 4)
      .Text("kind", KindText(packet.kind))
      .Key("to")
      .BeginArray();
  for (const AcousticPacket::Arrival& arrival : packet.to) {
    json->BeginObject()
        .Text("name", arrival.name)
        .Number("arrives", scene.SecondsOf(arrival.utime), kMilliseconds)
        .Text("cause", CauseText(arrival.cause))
        .EndObject();
  }
  json->EndArray().EndObject();
}

void WriteDrawing(const MapDrawing& drawing, JsonWriter* json) {
  json->BeginObject()
      .Text("kind", TextOf(drawing.kind))
      .Text("owner", drawing.owner)
      .Text("label", drawing.label)
      .Text("color", drawing.color)
      .Number("size", drawing.size_px, kTenths)
      .Number("fill", drawing.fill, 2)
      .Number("radius", drawing.radius_m, kCentimetres)
      .Text("text", drawing.text)
      .Key("points")
      .BeginArray();
  for (const auto& [x_m, y_m] : drawing.points_m) {
    json->BeginArray().Number(x_m, kCentimetres).Number(y_m, kCentimetres).EndArray();
  }
  json->EndArray().EndObject();
}

/// Writes as many as do not make a frame too large, and how many are left out.
void WriteDrawings(const std::vector<const MapDrawing*>& drawings, JsonWriter* json) {
  constexpr size_t kMaxPointsOfAll = 20'000;
  size_t num_points = 0;
  int64_t num_left_out = 0;
  json->Key("drawings").BeginArray();
  for (const MapDrawing* drawing : drawings) {
    num_points += drawing->points_m.size();
    if (num_points > kMaxPointsOfAll) {
      ++num_left_out;
    } else {
      WriteDrawing(*drawing, json);
    }
  }
  json->EndArray().Integer("drawings_left_out", num_left_out);
}

void WriteCommand(const CommandRecord& command, JsonWriter* json) {
  json->BeginObject()
      .Integer("id", command.id)
      .Number("t", command.t_s, kMilliseconds)
      .Text("text", command.text)
      .Text("state", command.state)
      .Text("reason", command.reason)
      .EndObject();
}

}  // namespace

std::string FrameJson(const Scene& scene, const FrameParts& parts) {
  constexpr size_t kMaxCommands = 20;
  JsonWriter json;
  json.BeginObject()
      .Number("t", parts.t_s, kMilliseconds)
      .Integer("step", (scene.now_utime() - scene.start_utime()) / scene.tick_us())
      .Key("clock");
  WriteClock(parts.clock, &json);
  json.Key("vehicles").BeginArray();
  for (const SceneVehicle& vehicle : scene.vehicles()) WriteVehicle(scene, vehicle, &json);
  json.EndArray().Key("rules");
  WriteOrNull(scene.rules(), &json, [&](const RulesInForce& rules) { WriteRules(rules, &json); });
  json.Key("pulses").BeginArray();
  for (const ViewPulse* pulse : parts.pulses) WritePulse(scene, *pulse, &json);
  json.EndArray().Integer("pulses_left_out", parts.pulses_left_out).Key("packets").BeginArray();
  for (const AcousticPacket* packet : parts.packets) WritePacket(scene, *packet, &json);
  json.EndArray().Number("sound_mps", scene.sound_mps(), 2);
  WriteDrawings(scene.drawings().At(scene.now_utime()), &json);
  json.Key("commands").BeginArray();
  const size_t num_commands = parts.commands.size();
  for (size_t i = num_commands - std::min(num_commands, kMaxCommands); i < num_commands; ++i) {
    WriteCommand(parts.commands[i], &json);
  }
  json.EndArray()
      .Integer("num_events", parts.num_events)
      .Integer("num_fates", parts.num_fates)
      .EndObject();
  return json.Take();
}

FrameParts WholeFrame(const Scene& scene) {
  FrameParts parts;
  parts.t_s = scene.now_s();
  parts.pulses = scene.pulses().NotOver(scene.now_utime());
  parts.packets = scene.packets().Since(0, scene.now_utime());
  parts.num_fates = scene.links().num_fates();
  return parts;
}

}  // namespace shoal
