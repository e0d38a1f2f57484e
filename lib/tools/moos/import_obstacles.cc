#include "lib/tools/moos/import_obstacles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/tools/moos/bhv_points.h"
#include "lib/tools/moos/import_settings.h"
#include "lib/tools/moos/point_cluster.h"

namespace shoal {
namespace {

constexpr size_t kMostObstacles = 1'000;
constexpr size_t kLongestId = 60;

/// Returns what follows "label=" or "label,".
std::string LabelOf(std::string_view text) {
  constexpr std::string_view kLabel = "label";
  const size_t at = text.find(kLabel);
  if (at == text.npos || at + kLabel.size() >= text.size()) return {};
  text.remove_prefix(at + kLabel.size());
  if (text[0] != '=' && text[0] != ',') return {};
  text.remove_prefix(1);
  return std::string(Trimmed(text.substr(0, text.find_first_of(",:}\"")))).substr(0, kLongestId);
}

/// Returns the polygon of `var=KNOWN_OBSTACLE_ALL, val="pts={...},label=a", time=5`; nothing for
/// other events.
std::optional<std::string> ObstacleOfEvent(std::string_view event) {
  constexpr std::string_view kVariable = "var=";
  constexpr std::string_view kValue = "val=";
  const size_t variable = event.find(kVariable);
  const size_t value = event.find(kValue);
  if (variable == event.npos || value == event.npos) return std::nullopt;
  const std::string_view name = Trimmed(event.substr(variable + kVariable.size()));
  if (!name.starts_with("KNOWN_OBSTACLE") && !name.starts_with("GIVEN_OBSTACLE")) {
    return std::nullopt;
  }
  std::string_view text = Trimmed(event.substr(value + kValue.size()));
  if (text.starts_with('"')) {
    text.remove_prefix(1);
    return std::string(text.substr(0, text.find('"')));
  }
  // Without quotes: to the next part of the event.
  size_t end = text.size();
  for (const std::string_view part : {"time=", "amt=", "var="}) {
    const size_t at = text.find(part);
    if (at != text.npos) end = std::min(end, text.rfind(',', at));
  }
  return std::string(Trimmed(text.substr(0, end)));
}

}  // namespace

void ObstacleImport::Add(const MoosFile& file, MissionDraft* draft) {
  for (const MoosBlock& block : file.blocks) {
    const std::string app_class = AppClass(block.app);
    for (const MoosLine& line : block.lines) {
      const std::string key = LowerCase(line.key);
      if (app_class == "pobstaclemgr" && key == "given_obstacle") {
        AddOne(line, line.value, draft);
      } else if (app_class == "ufldobstaclesim" && key == "obstacle_file") {
        AddFile(line, file.name, draft);
      } else if (app_class == "utimerscript" && key == "event") {
        if (const auto polygon = ObstacleOfEvent(line.value)) AddOne(line, *polygon, draft);
      }
    }
  }
}

void ObstacleImport::AddFile(const MoosLine& line, const std::string& from, MissionDraft* draft) {
  const auto source = find_ == nullptr ? std::nullopt : find_(line.value, from);
  if (!source) {
    warnings_.push_back(
        fmt::format("{}: {}: the file is not there: its obstacles are lost; name its folder with "
                    "--path",
                    line.origin, line.text));
    return;
  }
  lines_.insert(line.origin);
  const MoosFile file =
      ParseMoosFile(Plug({.name = source->name, .text = source->text}, defines_, {}));
  for (const MoosLine& each : file.globals) {
    if (LowerCase(each.key) == "poly") AddOne(each, each.value, draft);
  }
}

void ObstacleImport::AddOne(const MoosLine& line, const std::string& value, MissionDraft* draft) {
  if (!lines_.insert(line.origin).second) return;  // Of several vehicles' files.
  const auto polygon = ParseBhvPolygon(value);
  if (!polygon.ok() || polygon->points_m.size() < 3) {
    warnings_.push_back(fmt::format("{}: {}: {}: the obstacle is lost", line.origin, line.text,
                                    polygon.ok() ? "fewer than three corners" : polygon.error()));
    return;
  }
  AddTable(LabelOf(value), TomlPoints(polygon->points_m),
           {.key = "", .value = "", .origin = line.origin, .text = line.text, .reason = ""}, draft);
}

void ObstacleImport::AddTable(std::string id, const std::string& corners, const DraftLine& from,
                              MissionDraft* draft) {
  // The same obstacle that each vehicle's manager is given.
  if (!corners_.insert(corners).second || corners_.size() > kMostObstacles) return;
  for (char& c : id) {
    if (!IsNameCharacter(c) && c != '.' && c != '-') c = '_';
  }
  if (id.empty()) id = "obstacle";
  const std::string wanted = id;
  for (int i = 2; !ids_.insert(id).second; ++i) id = fmt::format("{}_{}", wanted, i);
  const std::string table = "obstacle " + id;
  draft->AddTable(table, "[[obstacle]]");
  const auto set = [&](std::string key, std::string written, std::string origin,
                       std::string reason) {
    draft->Set(table, {.key = std::move(key),
                       .value = std::move(written),
                       .origin = std::move(origin),
                       .text = from.text,
                       .reason = std::move(reason),
                       .is_essential = true});
  };
  set("id", TomlString(id), from.origin, from.reason);
  set("polygon", corners, "", "");
}

void ObstacleImport::AddPoints(const std::vector<TimerEvent>& points,
                               const std::vector<MoosFile>& files, MissionDraft* draft) {
  const PointCluster settings = ClusterSettings(files);
  using ClusterName = std::pair<int, std::string>;  // The script, and the label.
  std::map<ClusterName, PointCluster> clusters;
  std::vector<ClusterName> names;  // In the order of the scripts.
  for (const TimerEvent& event : points) {
    const ClusterName name(event.point->script, event.point->label);
    const auto [at, is_new] = clusters.emplace(name, settings);
    if (is_new) {
      names.push_back(name);
      at->second.origin = event.origin;
      at->second.text = event.text;
    }
    std::vector<Eigen::Vector2d>& own_m = at->second.points_m;
    if (own_m.size() < settings.most_points) own_m.push_back(event.point->position_m);
  }
  for (const ClusterName& name : names) {
    const PointCluster& cluster = clusters.at(name);
    AddTable(name.second.substr(0, kLongestId), TomlPoints(HullOf(cluster)),
             {.key = "",
              .value = "",
              .origin = cluster.origin,
              .text = cluster.text,
              .reason = "Assumed: there from the start, and to the end."},
             draft);
  }
  if (corners_.size() > kMostObstacles) {
    warnings_.push_back(fmt::format("{}: {}: {} obstacles are left out: {} are the most",
                                    points.front().origin, points.front().text,
                                    corners_.size() - kMostObstacles, kMostObstacles));
  }
}

}  // namespace shoal
