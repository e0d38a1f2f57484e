#include "lib/tools/moos/import_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/comms/routing/control.h"
#include "lib/mission/model/names.h"
#include "lib/mission/toml/table_writer.h"

namespace shoal {
namespace {

struct PostedCommand {
  std::string target;  ///< A vehicle, or "all".
  std::string command;
  std::string argument = {};

  bool operator==(const PostedCommand&) const = default;
};

/// The commands that stand for variables of this name.
PostedCommand CommandOf(std::string target, const std::string& variable, const std::string& value) {
  const bool is_true = LowerCase(value) == "true";
  if (is_true && variable == "DEPLOY") return {std::move(target), "deploy"};
  if (is_true && variable == "RETURN") return {std::move(target), "return"};
  if (is_true && variable == "STATION_KEEP") return {std::move(target), "station_keep"};
  return {std::move(target), "set", variable + "=" + value};
}

/// The commands of one posting: one for all vehicles where it reaches all, else one for each.
std::vector<PostedCommand> CommandsOf(std::string_view posted, const std::string& value,
                                      const VehicleImport* own,
                                      const std::vector<VehicleImport>& vehicles) {
  std::vector<PostedCommand> commands;
  const std::string upper = UpperCase(posted);
  if (upper.starts_with("MOOS_MANUAL_OVER")) {
    if (LowerCase(value) != "true") return {};  // Whoever deploys does that.
    return {{own == nullptr ? "all" : own->name(), "park"}};
  }
  for (const VehicleImport& vehicle : vehicles) {
    if (own != nullptr && own != &vehicle) continue;
    const bool is_own = own != nullptr || vehicles.size() == 1;
    const std::string variable = VariableOfPost(posted, is_own, vehicle);
    if (variable.empty() || value.find('$') != value.npos) continue;
    commands.push_back(CommandOf(vehicle.name(), variable, value));
  }
  const bool is_for_all = commands.size() == vehicles.size() && !commands.empty() &&
                          std::all_of(commands.begin(), commands.end(), [&](const auto& each) {
                            return each.command == commands.front().command &&
                                   each.argument == commands.front().argument;
                          });
  if (!is_for_all) return commands;
  commands.resize(1);
  commands.front().target = "all";
  return commands;
}

}  // namespace

std::string VariableOfPost(std::string_view posted, bool is_own, const VehicleImport& vehicle) {
  const std::string name(posted);
  for (const std::string& suffix :
       {std::string(), std::string("_ALL"), "_" + UpperCase(vehicle.name())}) {
    if (!UpperCase(name).ends_with(suffix) || suffix.size() >= name.size()) continue;
    std::string variable = name.substr(0, name.size() - suffix.size());
    if (suffix.empty() && !is_own) continue;
    if (vehicle.behaviors().variables.contains(variable)) return variable;
  }
  return {};
}

std::string OrderImport::NameOf(const MoosButton& button,
                                const std::vector<VehicleImport>& vehicles) {
  constexpr size_t kLongest = 28;  // Of 32, with room for a number.
  std::string label = button.label;
  if (label.empty() && !button.posts.empty()) {
    label = button.posts.front().first + "_" + button.posts.front().second;
  }
  std::string name;
  for (const char c : LowerCase(label).substr(0, kLongest)) {
    if (IsNameCharacter(c)) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (name.ends_with('_')) name.pop_back();
  const auto is_taken = [&](const std::string& wanted) {
    return !NameProblem(wanted).empty() || wanted == "all" || wanted == "clock" ||
           FindControl(wanted) != nullptr ||
           std::find(names_.begin(), names_.end(), wanted) != names_.end() ||
           std::any_of(vehicles.begin(), vehicles.end(), [&](const VehicleImport& vehicle) {
             return LowerCase(vehicle.name()) == wanted;
           });
  };
  if (name.empty()) name = "order";
  std::string free = name;
  for (int i = 2; is_taken(free); ++i) free = fmt::format("{}_{}", name, i);
  names_.push_back(free);
  return free;
}

std::string OrderImport::Add(const MoosButton& button, const VehicleImport* own,
                             const std::vector<VehicleImport>& vehicles, MissionDraft* draft) {
  constexpr size_t kMostTables = 1'000;
  std::vector<PostedCommand> commands;
  for (const auto& [posted, value] : button.posts) {
    for (PostedCommand& command : CommandsOf(posted, value, own, vehicles)) {
      const bool is_new = std::find(commands.begin(), commands.end(), command) == commands.end();
      if (is_new) commands.push_back(std::move(command));
    }
  }
  if (commands.empty() || num_tables_ + commands.size() > kMostTables) return {};
  std::string name = NameOf(button, vehicles);
  for (const PostedCommand& command : commands) {
    const std::string table = fmt::format("order {}", num_tables_++);
    draft->AddTable(table, "[[order]]");
    const auto set = [&](std::string key, std::string value, std::string origin) {
      draft->Set(table, {.key = std::move(key),
                         .value = std::move(value),
                         .origin = std::move(origin),
                         .text = "",
                         .reason = "",
                         .is_essential = true});
    };
    set("name", TomlString(name), button.origins);
    set("vehicle", TomlString(command.target), "");
    set("command", TomlString(command.command), "");
    if (!command.argument.empty()) set("argument", TomlString(command.argument), "");
  }
  return name;
}

}  // namespace shoal
