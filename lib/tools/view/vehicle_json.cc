#include "lib/tools/view/vehicle_json.h"

#include "lib/tools/view/json_writer.h"

namespace shoal {

namespace {

void WriteColumn(std::span<const ChartPoint> points, std::string_view key,
                 float ChartPoint::*member, int decimals, JsonWriter* json) {
  json->Key(key).BeginArray();
  for (const ChartPoint& point : points) json->Number(point.*member, decimals);
  json->EndArray();
}

void WriteContact(const Scene& scene, const swarm_contact_t& contact, JsonWriter* json) {
  json->BeginObject()
      .Text("name", contact.name)
      .Boolean("target", contact.is_target != 0)
      .Boolean("received", contact.is_heard != 0)
      .Boolean("known", contact.is_known != 0)
      .Key("age_s");
  if (contact.is_heard) {
    json->Number(scene.now_s() - scene.SecondsOf(contact.report_utime), kMilliseconds);
  } else {
    json->Null();
  }
  json->Key("position");
  if (contact.is_known) {
    json->BeginArray()
        .Number(contact.x_m, kCentimetres)
        .Number(contact.y_m, kCentimetres)
        .Number(contact.z_m, kCentimetres)
        .EndArray();
  } else {
    json->Null();
  }
  json->Boolean("silent", contact.is_silent != 0).Key("recovered").BeginArray();
  for (const std::string& field : contact.recovered) json->Text(field);
  json->EndArray().EndObject();
}

void WriteSwarm(const Scene& scene, const swarm_t& swarm, JsonWriter* json) {
  json->BeginObject()
      .Number("t", scene.SecondsOf(swarm.utime), kMilliseconds)
      .Integer("num_sent", swarm.num_said)
      .Key("contacts")
      .BeginArray();
  for (const swarm_contact_t& contact : swarm.contacts) WriteContact(scene, contact, json);
  json->EndArray().EndObject();
}

void WriteReceivedSources(const Scene& scene, std::string_view vehicle, JsonWriter* json) {
  const LinkBook& book = scene.links();
  const int32_t to = book.names().Find(vehicle);
  json->BeginArray();
  for (const LinkCounts& link : book.links()) {
    if (link.to != to || link.last_received_utime == LinkCounts::kNeverReceived) continue;
    json->BeginObject()
        .Text("name", book.names().at(link.from))
        .Number("last_received_s", scene.SecondsOf(link.last_received_utime), kMilliseconds)
        .EndObject();
  }
  json->EndArray();
}

}  // namespace

std::string VehicleJson(const Scene& scene, const SceneVehicle& vehicle,
                        std::span<const ChartPoint> points) {
  JsonWriter json;
  json.BeginObject().Text("name", vehicle.name).Key("t").BeginArray();
  for (const ChartPoint& point : points) json.Number(point.t_s, kMilliseconds);
  json.EndArray();
  WriteColumn(points, "heading", &ChartPoint::heading_deg, kTenths, &json);
  WriteColumn(points, "desired_heading", &ChartPoint::desired_heading_deg, kTenths, &json);
  WriteColumn(points, "speed", &ChartPoint::speed_mps, 2, &json);
  WriteColumn(points, "desired_speed", &ChartPoint::desired_speed_mps, 2, &json);
  WriteColumn(points, "depth", &ChartPoint::depth_m, kCentimetres, &json);
  WriteColumn(points, "desired_depth", &ChartPoint::desired_depth_m, kCentimetres, &json);
  WriteColumn(points, "altitude", &ChartPoint::altitude_m, kCentimetres, &json);
  json.Key("swarm");
  if (vehicle.swarm) {
    WriteSwarm(scene, *vehicle.swarm, &json);
  } else {
    json.Null();
  }
  json.Key("receives_from");
  WriteReceivedSources(scene, vehicle.name, &json);
  json.EndObject();
  return json.Take();
}

std::string TrailsJson(const Scene& scene, std::span<const Trail> trails) {
  std::vector<std::string> names;
  for (const SceneVehicle& vehicle : scene.vehicles()) names.push_back(vehicle.name);
  return TrailsJson(names, trails);
}

std::string TrailsJson(const std::vector<std::string>& names, std::span<const Trail> trails) {
  JsonWriter json;
  json.BeginObject().Integer("begin_s", 0).Key("trails").BeginObject();
  for (size_t i = 0; i < trails.size() && i < names.size(); ++i) {
    json.KeyText(names[i]).BeginArray();
    for (const TrailPoint& point : trails[i].points()) {
      json.BeginArray()
          .Number(point.t_s, kMilliseconds)
          .Number(point.x_m, kCentimetres)
          .Number(point.y_m, kCentimetres)
          .EndArray();
    }
    json.EndArray();
  }
  json.EndObject().EndObject();
  return json.Take();
}

}  // namespace shoal
