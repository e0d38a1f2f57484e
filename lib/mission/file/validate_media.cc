// Media and gateways: what names them, and whether they fit together.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/file/load_media.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

bool Has(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::string Listed(const std::vector<std::string>& names) {
  std::vector<std::string_view> words(names.begin(), names.end());
  return Joined(words);
}

void CheckNames(const TablePlace& place, std::string_view key,
                const std::vector<std::string>& names, const std::vector<std::string>& media) {
  const std::vector<std::string_view> words(media.begin(), media.end());
  for (const std::string& name : names) {
    if (Has(media, name)) continue;
    place.Refuse(key, fmt::format("unknown medium {}{}; one of: {}", Quoted(name),
                                  DidYouMean(name, words), Joined(words)));
  }
}

void CheckMedium(const TablePlace& place, const std::vector<MediumOptions>& media, size_t number) {
  const std::string& name = media[number].name;
  if (name.empty()) return;  // Refused already.
  if (name == kDirectMedium || name == kAcousticMedium) {
    place.Refuse(
        "name", fmt::format("every mission has a medium {} ({}): choose another name", Quoted(name),
                            name == kDirectMedium ? "at once and without loss"
                                                  : "with the options of [acoustics]"));
  } else if (!IsLegalVehicleName(name)) {
    place.Refuse("name", Quoted(name) + " is not a name: a medium's has letters, digits and '_'");
  }
  for (size_t i = 0; i < number; ++i) {
    if (media[i].name != name) continue;
    place.Refuse("name", fmt::format("a medium {} exists already; give each a name of its own",
                                     Quoted(name)));
    return;
  }
}

void CheckGateway(const TablePlace& place, const VehicleMedia& media,
                  const std::vector<std::string>& names) {
  const TablePlace table = place.Below("gateway");
  const GatewayOptions& gateway = media.gateway;
  if (Has(gateway.from, kDirectMedium)) {
    table.Refuse("from", "what comes by direct has reached everywhere already: leave it out");
  }
  for (const auto& [key, list] : {std::pair{"from", &gateway.from}, std::pair{"to", &gateway.to}}) {
    CheckNames(table, key, *list, names);
    if (list->empty()) {
      table.Refuse(key, fmt::format("{} names no medium; one of: {}", key, Listed(names)));
    }
    for (const std::string& name : *list) {
      if (name == kDirectMedium || !Has(names, name) || Has(media.names, name)) continue;
      table.Refuse(key, fmt::format("the gateway has no {}: write media = [{}{}\"{}\"] in its "
                                    "[[vehicle]]",
                                    name, media.names.empty() ? "" : "\"" + Listed(media.names),
                                    media.names.empty() ? "" : "\", ", name));
    }
  }
}

/// Vehicles that dive, and receive by direct what no sea lets through.
void WarnOfDirect(const Mission& mission, const TablePlace& file) {
  const RoutingRules& rules = mission.comms;
  const bool is_asked =
      mission.HasMedia() || !rules.reports_over.is_direct() || !rules.messages_over.is_direct();
  if (!is_asked || mission.vehicles.size() < 2) return;
  const auto diver = std::ranges::find_if(mission.vehicles, [](const Vehicle& vehicle) {
    return FactsOfModel(vehicle.model).is_underwater;
  });
  if (diver == mission.vehicles.end()) return;
  const auto warn = [&](std::string_view key, std::string_view what, const MediaChoice& choice) {
    if (!choice.Has(kDirectMedium)) return;
    file.Below("comms").Warn(
        key, fmt::format("{} receives {} by direct, at once and without loss, however deep it is; "
                         "write {} = \"acoustic\", or a list of media without direct",
                         diver->name, what, key));
  };
  warn("reports_over", "reports", rules.reports_over);
  warn("messages_over", "messages", rules.messages_over);
}

}  // namespace

void ValidateChoice(const TablePlace& place, std::string_view key, const MediaChoice& choice,
                    const std::vector<std::string>& media) {
  CheckNames(place, key, choice.names, media);
}

void ValidateMedia(const MediaSetup& setup, const TablePlace& file) {
  const std::vector<std::string> names = setup.Names();
  for (size_t i = 0; i < setup.media.size(); ++i) {
    CheckMedium(file.Below("medium", i), setup.media, i);
  }
  for (size_t i = 0; i < setup.of_vehicles.size(); ++i) {
    const VehicleMedia& media = setup.of_vehicles[i];
    const TablePlace place = file.Below("vehicle", i);
    CheckNames(place, "media", media.names, names);
    if (media.gateway.exists) CheckGateway(place, media, names);
  }
}

void ValidateMedia(const Mission& mission, const TablePlace& file) {
  const MediaSetup setup = MediaOf(mission);
  const std::vector<std::string> names = setup.Names();
  ValidateMedia(setup, file);
  ValidateChoice(file.Below("comms"), "reports_over", mission.comms.reports_over, names);
  ValidateChoice(file.Below("comms"), "messages_over", mission.comms.messages_over, names);
  for (size_t i = 0; i < mission.swarms.size(); ++i) {
    ValidateChoice(TableOfSwarm(mission, file, i), "over", mission.swarms[i].over, names);
  }
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    const TablePlace place = file.Below("vehicle", i);
    if (place.Has("media") && vehicle.media.names.empty()) {
      place.Refuse("media", "media names none; write media = [\"direct\"]");
    }
    if (!vehicle.media.gateway.exists) continue;
    if (vehicle.is_outside || vehicle.reporter == Provider::kNone) {
      place.Refuse("gateway",
                   "the broker must know where a gateway is: let it have shoal's "
                   "node_reporter");
    }
  }
  WarnOfDirect(mission, file);
}

void FillInMedia(Mission& mission, const TablePlace& file) {
  if (!mission.HasMedia()) return;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    Vehicle& vehicle = mission.vehicles[i];
    std::vector<std::string>& names = vehicle.media.names;
    if (file.Below("vehicle", i).Has("media")) continue;
    const auto add = [&](std::string_view name) {
      if (!Has(names, name)) names.emplace_back(name);
    };
    const bool dives = FactsOfModel(vehicle.model).is_underwater;
    add(kDirectMedium);
    if (dives && mission.acoustics.is_used) add(kAcousticMedium);
    for (const MediumOptions& medium : mission.media) {
      if (dives || medium.kind == MediumKind::kRadio) add(medium.name);
    }
    for (const std::string& name : vehicle.media.gateway.from) add(name);
    for (const std::string& name : vehicle.media.gateway.to) add(name);
  }
}

}  // namespace shoal
