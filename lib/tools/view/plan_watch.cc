#include "lib/tools/view/plan_watch.h"

#include <algorithm>
#include <utility>

#include "lib/helm/behaviors/behavior_outline.h"
#include "lib/helm/behaviors/update_text.h"
#include "lib/mission/file/behavior_update.h"
#include "lib/tools/view/json_writer.h"
#include "lib/tools/view/outline_json.h"
#include "lib/vehicle/guidance/moved_task.h"

namespace shoal {

namespace {

constexpr std::string_view kUpdate = "update: ";

std::optional<std::string> PlanJson(std::string_view name, std::string_view kind,
                                    const std::vector<TaskOutline>& outlines) {
  JsonWriter json;
  json.BeginObject().Text("name", name).Key("parts").BeginArray();
  for (const TaskOutline& outline : outlines) WriteOutline(name, kind, outline, &json);
  json.EndArray().EndObject();
  std::string text = json.Take();
  if (text.size() > PlanWatch::kMaxPlan_bytes) return std::nullopt;
  return text;
}

std::string JsonOf(const std::vector<TaskOutline>& outlines) {
  return PlanJson("", "", outlines).value_or("");
}

}  // namespace

PlanWatch::PlanWatch(std::vector<BehaviorOptions> behaviors, std::vector<Task> tasks)
    : behaviors_(std::move(behaviors)), tasks_(std::move(tasks)) {}

std::optional<std::string> PlanWatch::OnEvent(std::string_view event,
                                              const Eigen::Vector2d& position_m) {
  if (!event.starts_with(kUpdate)) return std::nullopt;
  const std::string_view rest = event.substr(kUpdate.size());
  const size_t colon = rest.find(": ");
  if (colon == rest.npos) return std::nullopt;
  const auto found =
      std::find_if(behaviors_.begin(), behaviors_.end(),
                   [&](const BehaviorOptions& each) { return each.name == rest.substr(0, colon); });
  auto items = ParseUpdate(rest.substr(colon + 2));
  if (found == behaviors_.end() || !items.ok()) return std::nullopt;
  // The helm has found by it which behavior is meant.
  std::erase_if(*items, [](const UpdateItem& item) { return item.key == "name"; });
  Result<BehaviorOptions> updated = ReadBehaviorUpdate(*found, *items, position_m);
  if (!updated.ok()) return std::nullopt;
  const std::string before = JsonOf(OutlinesOf(found->what));
  *found = std::move(*updated);
  const std::vector<TaskOutline> now = OutlinesOf(found->what);
  if (JsonOf(now) == before) return std::nullopt;
  return PlanJson(found->name, KindOf(found->what), now);
}

std::optional<std::string> PlanWatch::OnMove(std::string_view task,
                                             std::span<const double> values) {
  const auto found = std::find_if(tasks_.begin(), tasks_.end(),
                                  [&](const Task& each) { return each.name == task; });
  if (found == tasks_.end()) return std::nullopt;
  Result<Task> moved = MovedTask(*found, values);
  if (!moved.ok()) return std::nullopt;
  *found = std::move(*moved);
  return PlanJson(found->name, KindOf(*found), {FactsOf(*found).outline});
}

}  // namespace shoal
