#include "lib/tools/view/plan_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "lib/base/check/enum_table.h"
#include "lib/mission/file/load.h"
#include "lib/mission/plan/plan_text.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/view/json_writer.h"
#include "lib/tools/view/setup_json.h"

namespace shoal {

namespace {

using Json = nlohmann::json;
constexpr size_t kMaxPlanPoints = 1000;
constexpr int kMaxNumber = 1'000'000;

/// Takes the members of an edit; the first that is wrong is kept.
class EditReader {
 public:
  explicit EditReader(const Json& edit) : edit_(edit) {}

  size_t Number(const char* key) {
    const auto found = edit_.find(key);
    if (found != edit_.end() && found->is_number_unsigned() && *found <= kMaxNumber) {
      return found->get<size_t>();
    }
    Refuse(fmt::format("an edit needs \"{}\", a number from 0", key));
    return 0;
  }
  std::string Text(const char* key) {
    const auto found = edit_.find(key);
    if (found != edit_.end() && found->is_string()) return found->get<std::string>();
    Refuse(fmt::format("an edit needs \"{}\", a text", key));
    return {};
  }
  std::vector<Eigen::Vector2d> Points(const char* key) {
    std::vector<Eigen::Vector2d> points_m;
    const auto found = edit_.find(key);
    if (found == edit_.end() || !found->is_array() || found->empty() ||
        found->size() > kMaxPlanPoints) {
      Refuse(fmt::format("an edit needs \"{}\", [[x, y], ...], at most {}", key, kMaxPlanPoints));
      return points_m;
    }
    for (const Json& point : *found) {
      if (!point.is_array() || point.size() != 2 || !point[0].is_number() ||
          !point[1].is_number()) {
        Refuse(fmt::format("an edit needs \"{}\", [[x, y], ...]", key));
        return {};
      }
      points_m.emplace_back(point[0].get<double>(), point[1].get<double>());
    }
    return points_m;
  }
  Eigen::Vector2d Point(const char* key) {
    const auto points_m = Points(key);
    return points_m.empty() ? Eigen::Vector2d(0, 0) : points_m.front();
  }
  void Refuse(std::string error) {
    if (error_.empty()) error_ = std::move(error);
  }
  const std::string& error() const { return error_; }

 private:
  const Json& edit_;
  std::string error_;
};

Result<PlanEdit> ReadEdit(const Json& json) {
  if (!json.is_object()) return Error{"\"edit\" is an object"};
  EditReader reader(json);
  const std::string action = reader.Text("do");
  PlanEdit edit;
  if (action == "move") {
    edit = MovePoint{reader.Number("handle"), reader.Number("point"), reader.Point("points")};
  } else if (action == "insert") {
    edit = InsertPoint{reader.Number("handle"), reader.Number("point"), reader.Point("points")};
  } else if (action == "remove") {
    edit = RemovePoint{reader.Number("handle"), reader.Number("point")};
  } else if (action == "task") {
    edit = AddTask{reader.Text("vehicle"), reader.Text("kind"), reader.Points("points")};
  } else if (action == "obstacle") {
    edit = AddObstacle{reader.Points("points")};
  } else if (action == "area") {
    edit = AddArea{reader.Points("points")};
  } else {
    reader.Refuse(fmt::format("unknown edit {}: move, insert, remove, task, obstacle and area are",
                              Quoted(action)));
  }
  if (!reader.error().empty()) return Error{reader.error()};
  return edit;
}

void WriteTexts(const char* key, const std::vector<std::string>& texts, JsonWriter* json) {
  json->Key(key).BeginArray();
  for (const std::string& text : texts) json->Text(text);
  json->EndArray();
}

void WriteHandle(const PlanHandle& handle, JsonWriter* json) {
  constexpr EnumTable<PlanShape, std::string_view> kShapes = {"point", "line", "polygon"};
  json->BeginObject()
      .Text("vehicle", handle.vehicle)
      .Text("name", handle.name)
      .Text("kind", handle.kind)
      .Text("key", handle.key)
      .Text("updates", handle.updates)
      .Text("shape", kShapes[handle.shape])
      .Key("points")
      .BeginArray();
  for (const PlanPoint& point : handle.points) {
    json->BeginArray().Number(point.x_m, 3).Number(point.y_m, 3).EndArray();
  }
  json->EndArray().EndObject();
}

}  // namespace

Result<PlanQuestion> ParsePlanQuestion(std::string_view body) {
  const Json json = Json::parse(body, nullptr, false);
  if (!json.is_object()) return Error{R"(a question is JSON like {"text": "[mission] ..."})"};
  PlanQuestion question;
  for (const auto& [key, value] : json.items()) {
    if (key == "text" && value.is_string()) {
      question.text = value.get<std::string>();
    } else if (key == "edit") {
      Result<PlanEdit> edit = ReadEdit(value);
      if (!edit.ok()) return Error{edit.error()};
      question.edit = std::move(*edit);
    } else {
      return Error{
          fmt::format("unknown in a question: {}; it has \"text\" and \"edit\"", Quoted(key))};
    }
  }
  return question;
}

std::string PlanJson(const std::string& text, const PlanFacts& facts) {
  const LoadedMission loaded = LoadMissionText(text, facts.file, facts.overrides);
  JsonWriter json;
  json.BeginObject()
      .Text("file", facts.file)
      .Text("text", text)
      .Boolean("may_write", facts.may_write);
  WriteTexts("errors", loaded.errors, &json);
  WriteTexts("warnings", loaded.warnings, &json);
  json.Key("handles").BeginArray();
  const std::optional<PlanText> plan = ReadPlan(text);
  if (plan) {
    for (const PlanHandle& handle : plan->handles) WriteHandle(handle, &json);
  }
  json.EndArray().Key("vehicles").BeginArray();
  if (plan) {
    for (const PlanVehicle& vehicle : plan->vehicles) json.Text(vehicle.name);
  }
  json.EndArray().Key("setup");
  if (loaded.errors.empty()) {
    json.Raw(SetupJson(loaded.mission, {.mode = "planned", .boot = "", .notes = {}}, "null"));
  } else {
    json.Null();
  }
  json.EndObject();
  return json.Take();
}

}  // namespace shoal
