#include "lib/tools/view/planned_view.h"

#include <fmt/format.h>

#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/view/frame_json.h"
#include "lib/tools/view/json_writer.h"
#include "lib/tools/view/links_json.h"
#include "lib/tools/view/setup_json.h"

namespace shoal {

namespace {

const Error kDoesNotRun{"the mission does not run yet: nothing was sent"};

/// Where a vehicle lies before the mission.
nav_t StartOf(const Mission& mission, const Vehicle& vehicle) {
  nav_t nav{};
  nav.utime = mission.start_utime;
  nav.x_m = vehicle.start.x_m;
  nav.y_m = vehicle.start.y_m;
  nav.z_m = vehicle.start.depth_m;
  nav.heading_deg = vehicle.start.heading_deg;
  nav.course_over_ground_deg = nav.heading_deg;
  nav.altitude_m = -1;
  return nav;
}

}  // namespace

PlannedView::PlannedView(const Mission& mission, const std::string& boot)
    : mission_(mission), scene_(mission) {
  for (const Vehicle& vehicle : mission_.vehicles) {
    Bytes bytes;
    EncodeInto(StartOf(mission_, vehicle), &bytes);
    scene_.Handle(channels::Nav(vehicle.name).name, bytes);
  }
  std::vector<std::string> notes;
  const std::string floor_json = FloorJson(mission_, &notes);
  setup_json_ = shoal::SetupJson(
      mission_, {.mode = "planned", .boot = boot, .notes = std::move(notes)}, floor_json);
}

std::string PlannedView::SetupJson(bool /*commands*/) { return setup_json_; }

std::string PlannedView::FrameJson(double /*t_s*/) {
  FrameParts parts = WholeFrame(scene_);
  parts.t_s = 0;
  parts.clock.state = "planned";
  return shoal::FrameJson(scene_, parts);
}

std::string PlannedView::TrailsJson() { return R"({"begin_s":0,"trails":{}})"; }
std::string PlannedView::LinksJson(double /*t_s*/) { return shoal::LinksJson(scene_); }

Result<std::string> PlannedView::MediumLinksJson(std::string_view medium, double /*t_s*/) {
  return shoal::MediumLinksJson(scene_, medium);
}

std::string PlannedView::FatesJson(const FateQuery& /*query*/, double /*t_s*/) {
  return R"({"fates":[],"kinds":[],"causes":[],"forgotten":0})";
}

std::string PlannedView::EventsJson() { return R"({"events":[]})"; }
std::string PlannedView::VerdictJson() { return R"({"verdict":null})"; }

Result<std::string> PlannedView::LinkJson(std::string_view /*from*/, std::string_view /*to*/,
                                          double /*t_s*/) {
  return kDoesNotRun;
}

Result<std::string> PlannedView::VehicleJson(std::string_view name, double /*t_s*/,
                                             double /*window_s*/) {
  const SceneVehicle* vehicle = scene_.Find(name);
  if (vehicle == nullptr) {
    return Error{fmt::format("no vehicle {} in the mission", Quoted(std::string(name)))};
  }
  JsonWriter json;
  json.BeginObject().Text("name", vehicle->name);
  for (const char* column : {"t", "heading", "desired_heading", "speed", "desired_speed", "depth",
                             "desired_depth", "altitude"}) {
    json.Key(column).Raw("[]");
  }
  json.Key("swarm").Null().Key("receives_from").Raw("[]").EndObject();
  return json.Take();
}

}  // namespace shoal
