#include "lib/tools/moos/import_posts.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/base/text/letters.h"
#include "lib/tools/moos/import_settings.h"
#include "lib/tools/moos/import_vehicle.h"

namespace shoal {
namespace {

/// `deploy` leaves STATION_KEEP alone where the button that deploys does.
void KeepStation(const MoosButton& button, VehicleImport* vehicle) {
  const bool is_set = std::any_of(button.posts.begin(), button.posts.end(), [](const auto& posted) {
    return UpperCase(posted.first).starts_with("STATION_KEEP");
  });
  if (!is_set && vehicle->behaviors().variables.contains("STATION_KEEP")) {
    vehicle->KeepStation(button.origins);
  }
}

/// Sets what the button posts besides DEPLOY. `is_own`: it reaches this vehicle alone.
void SetButton(const MoosButton& button, bool is_own, VehicleImport* vehicle) {
  std::vector<std::pair<std::string, std::string>> settings;
  for (const auto& [posted, value] : button.posts) {
    const std::string variable = VariableOfPost(posted, is_own, *vehicle);
    // The order `deploy` sets these itself.
    if (variable.empty() || variable == "DEPLOY" ||
        ((variable == "RETURN" || variable == "STATION_KEEP") && LowerCase(value) == "false") ||
        value.find('$') != value.npos) {
      continue;
    }
    settings.emplace_back(variable, value);
  }
  if (!settings.empty()) vehicle->SetWithDeploy(settings, button.origins);
}

}  // namespace

void PostImport::Read(const std::vector<MoosFile>& files, FleetImport* fleet) {
  // A script that deploys sets what it means to set.
  bool deploys_by_script = false;
  for (const MoosFile& file : files) {
    for (const MoosBlock& block : file.blocks) {
      if (AppClass(block.app) != "utimerscript") continue;
      for (const MoosLine& line : block.lines) {
        deploys_by_script = deploys_by_script || (LowerCase(line.key) == "event" &&
                                                  line.value.find("var=DEPLOY") != line.value.npos);
      }
    }
  }
  for (size_t i = 0; i < files.size(); ++i) {
    for (const MoosBlock& block : files[i].blocks) {
      if (AppClass(block.app) != "pmarineviewer") continue;
      std::vector<MoosButton> buttons = ReadButtons(block);
      const VehicleImport* own = fleet->OfFile(i);
      for (VehicleImport& vehicle : fleet->vehicles()) {
        const MoosButton* deploy = FindDeployButton(buttons, vehicle.name());
        if (deploy == nullptr || (own != nullptr && own != &vehicle)) continue;
        deploy_keys_.insert({&block, deploy->key});
        KeepStation(*deploy, &vehicle);
        if (deploys_by_script) continue;
        SetButton(*deploy, own != nullptr || fleet->vehicles().size() == 1, &vehicle);
      }
      buttons_[&block] = std::move(buttons);
    }
  }
}

bool PostImport::SetsAlone(std::string_view variable) const {
  bool is_set = false;
  for (const auto& [block, buttons] : buttons_) {
    for (const MoosButton& button : buttons) {
      const bool posts = std::any_of(button.posts.begin(), button.posts.end(),
                                     [&](const auto& post) { return post.first == variable; });
      if (posts && deploy_keys_.contains({block, button.key})) return false;
      is_set = is_set || posts;
    }
  }
  return is_set;
}

void PostImport::AddOrders(const std::vector<MoosFile>& files, const std::vector<MoosButton>& pokes,
                           FleetImport* fleet, MissionDraft* draft, ImportLosses* losses) {
  for (size_t i = 0; i < files.size(); ++i) {
    for (const MoosBlock& block : files[i].blocks) {
      const auto buttons = buttons_.find(&block);
      if (buttons == buttons_.end()) continue;
      for (const MoosButton& button : buttons->second) {
        if (deploy_keys_.contains({&block, button.key})) continue;
        const std::string name = orders_.Add(button, fleet->OfFile(i), fleet->vehicles(), draft);
        button_orders_[button.origins] += name.empty() ? "" : "shoal send " + name + "\n";
      }
    }
  }
  for (const MoosButton& poke : pokes) {
    const std::string name = orders_.Add(poke, nullptr, fleet->vehicles(), draft);
    if (name.empty())
      losses->Lose(poke.origins + ": uPokeDB: it sets nothing that behaviors look at");
  }
}

std::string PostImport::Reason(const MoosBlock& block, const MoosLine& line,
                               ImportLosses* losses) const {
  const std::string key = LowerCase(line.key);
  if (deploy_keys_.contains({&block, key})) return "shoal send all deploy sets this";
  for (const MoosButton& button : buttons_.at(&block)) {
    if ((button.key != key && key != "action+") ||
        button.origins.find(line.origin) == button.origins.npos)
      continue;
    std::string orders = button_orders_.at(button.origins);
    if (orders.empty()) break;
    orders.pop_back();
    std::replace(orders.begin(), orders.end(), '\n', ',');
    return "[[order]]: " + orders;
  }
  losses->Lose(
      fmt::format("{}: {}: it sets nothing that behaviors look at", line.origin, line.text));
  return "no counterpart in shoal";
}

}  // namespace shoal
