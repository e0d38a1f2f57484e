#include "lib/mission/load_media.h"

#include <optional>

#include "lib/mission/describe.h"
#include "lib/mission/parse.h"
#include "lib/mission/problems.h"
#include "lib/mission/table_reader.h"
#include "lib/mission/table_writer.h"
#include "lib/mission/validate.h"

namespace shoal {
namespace {

void DescribeAlone(Fields& file, MediaSetup& setup) {
  Acoustics& acoustics = setup.acoustics;
  if (file.Has("is_used", !acoustics.is_used)) file.Flag("is_used", acoustics.is_used);
  if (file.Has("packets_over", setup.packets_over != MediaSetup().packets_over)) {
    DescribeMedia(file, "packets_over", setup.packets_over);
  }
  file.Require("acoustics", "[acoustics], followed by crc = true");
  file.Below("acoustics", [&](Fields& fields) { Describe(fields, acoustics, std::nullopt); });
  file.List("medium", setup.media,
            [](Fields& fields, MediumOptions& medium) { Describe(fields, medium, std::nullopt); });
  file.List("vehicle", setup.of_vehicles,
            [](Fields& fields, VehicleMedia& media) { Describe(fields, media); });
}

}  // namespace

std::vector<std::string> MediaSetup::Names() const {
  std::vector<std::string> names = {std::string(kDirectMedium), std::string(kAcousticMedium)};
  for (const MediumOptions& medium : media) names.push_back(medium.name);
  return names;
}

MediaSetup MediaOf(const Mission& mission) {
  MediaSetup setup = {.acoustics = mission.acoustics,
                      .media = mission.media,
                      .packets_over = mission.swarm.over,
                      .of_vehicles = {}};
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
