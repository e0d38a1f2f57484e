#include "lib/mission/file/load_media.h"

#include <algorithm>
#include <optional>

#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/swarm_plan.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/table_reader.h"
#include "lib/mission/toml/table_writer.h"

namespace shoal {
namespace {

void DescribeAlone(Fields& file, MediaSetup& setup) {
  Acoustics& acoustics = setup.acoustics;
  if (file.Has("is_used", !acoustics.is_used)) file.Flag("is_used", acoustics.is_used);
  if (file.Has("packets_over", setup.packets_over != MediaSetup().packets_over)) {
    DescribeMedia(file, "packets_over", setup.packets_over);
  }
  file.List("packets", setup.packets_of, [](Fields& fields, MediaSetup::PacketsOf& packets) {
    fields.Require("vehicle", "vehicle = \"alpha\"");
    fields.Text("vehicle", packets.vehicle, {.min_length = 1});
    DescribeMedia(fields, "over", packets.over);
  });
  file.List("modem", setup.hanging_modems, [](Fields& fields, MediaSetup::HangingModem& modem) {
    fields.Require("vehicle", "vehicle = \"alpha\"");
    fields.Text("vehicle", modem.vehicle, {.min_length = 1});
    fields.Number("depth_m", modem.depth_m, Between(0, 1000));
  });
  file.Require("acoustics", "[acoustics], followed by crc = true");
  file.Below("acoustics", [&](Fields& fields) { Describe(fields, acoustics, std::nullopt); });
  file.List("medium", setup.media,
            [](Fields& fields, MediumOptions& medium) { Describe(fields, medium, std::nullopt); });
  if (file.Has("floor", setup.floor.has_value())) {
    if (!setup.floor) setup.floor.emplace();
    file.Below("floor", [&](Fields& fields) { Describe(fields, *setup.floor); });
  }
  file.List("vehicle", setup.of_vehicles,
            [](Fields& fields, VehicleMedia& media) { Describe(fields, media); });
}

}  // namespace

std::vector<const Acoustics*> MediaSetup::Networks() const {
  std::vector<const Acoustics*> networks = {&acoustics};
  for (const MediumOptions& medium : media) {
    if (medium.kind == MediumKind::kAcoustic) networks.push_back(&medium.acoustics);
  }
  return networks;
}

std::vector<std::string> MediaSetup::Names() const {
  std::vector<std::string> names = {std::string(kDirectMedium), std::string(kAcousticMedium)};
  for (const MediumOptions& medium : media) names.push_back(medium.name);
  return names;
}

const MediaChoice& MediaSetup::PacketsOver(std::string_view vehicle) const {
  const auto found = std::ranges::find_if(packets_of, [&](const PacketsOf& each) {
    return VehicleKey(each.vehicle) == VehicleKey(vehicle);
  });
  return found == packets_of.end() ? packets_over : found->over;
}

double MediaSetup::ModemDepth_m(std::string_view vehicle) const {
  const auto found = std::ranges::find_if(hanging_modems, [&](const HangingModem& each) {
    return VehicleKey(each.vehicle) == VehicleKey(vehicle);
  });
  return found == hanging_modems.end() ? 0 : found->depth_m;
}

MediaSetup MediaOf(const Mission& mission) {
  MediaSetup setup = {.acoustics = mission.acoustics,
                      .media = mission.media,
                      .packets_over = PacketsOver(mission),
                      .of_vehicles = {}};
  for (const SwarmOptions& swarm : mission.swarms) {
    if (swarm.over == setup.packets_over) continue;
    setup.packets_of.push_back({.vehicle = swarm.leader, .over = swarm.over});
    for (const std::string& name : swarm.followers) {
      setup.packets_of.push_back({.vehicle = name, .over = swarm.over});
    }
  }
  for (const Vehicle& vehicle : mission.vehicles) {
    if (vehicle.modem_depth_m <= 0) continue;
    setup.hanging_modems.push_back({.vehicle = vehicle.name, .depth_m = vehicle.modem_depth_m});
  }
  for (const Acoustics* network : setup.Networks()) {
    const std::optional<RayChannelOptions>& rays = network->options.rays;
    if (rays && rays->follows_floor) setup.floor = mission.environment.floor;
  }
  if (!mission.HasMedia()) return setup;
  for (const Vehicle& vehicle : mission.vehicles) setup.of_vehicles.push_back(vehicle.media);
  return setup;
}

std::string ExplainMedia(const MediaSetup& setup) {
  TableWriter writer;
  MediaSetup copy = setup;
  DescribeAlone(writer, copy);
  std::string text = writer.TakeText();
  text.erase(0, text.find_first_not_of('\n'));
  return text;
}

LoadedMedia LoadMediaText(std::string_view text, const std::string& name) {
  LoadedMedia loaded;
  loaded.setup.acoustics.is_used = true;
  Problems problems(name, {});
  if (const std::optional<Value> root = ParseToml(text, problems)) {
    TableReader file(*root, "the text", problems);
    DescribeAlone(file, loaded.setup);
    const TablePlace whole(*root, problems);
    const TablePlace place = whole.Below("acoustics");
    if (place.IsSound()) ValidateNetwork(place, loaded.setup.acoustics.options, AnyNode());
    ValidateMedia(loaded.setup, whole);
  }
  loaded.errors = problems.InOrder();
  return loaded;
}

std::vector<AcousticNode> AnyNode() { return {{.name = "any", .address = 1, .is_leader = true}}; }

}  // namespace shoal
