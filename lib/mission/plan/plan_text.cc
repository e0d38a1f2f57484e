#include "lib/mission/plan/plan_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <variant>

#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"

namespace shoal {

namespace {

struct KeyRow {
  std::string_view key;
  PlanShape shape;
};

/// Keys of tasks and behaviors that are places of the plane.
constexpr std::array<KeyRow, 8> kPlaceKeys = {{{"points", PlanShape::kLine},
                                               {"polygon", PlanShape::kPolygon},
                                               {"center", PlanShape::kPoint},
                                               {"point", PlanShape::kPoint},
                                               {"station_pt", PlanShape::kPoint},
                                               {"p1", PlanShape::kPoint},
                                               {"p2", PlanShape::kPoint},
                                               {"core_poly", PlanShape::kPolygon}}};

std::optional<double> NumberOf(const Value& value) {
  if (const auto* whole = std::get_if<int64_t>(&value.data)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  return std::nullopt;
}

const Table* TableAt(const Table& table, std::string_view key) {
  const Value* value = Find(table, key);
  return value == nullptr ? nullptr : std::get_if<Table>(&value->data);
}

/// Returns the tables of [[key]].
std::vector<const Value*> TablesAt(const Table& table, std::string_view key) {
  std::vector<const Value*> tables;
  const Value* value = Find(table, key);
  const auto* array = value == nullptr ? nullptr : std::get_if<Array>(&value->data);
  if (array == nullptr) return tables;
  for (const Value& each : *array) {
    if (std::holds_alternative<Table>(each.data)) tables.push_back(&each);
  }
  return tables;
}

std::string TextAt(const Value& table, std::string_view key) {
  const std::string* text = FindText(table, key);
  return text == nullptr ? std::string() : *text;
}

class PlanReader {
 public:
  explicit PlanReader(std::string_view text) : text_(text) {}

  PlanText Read(const Table& root) {
    if (const Value* mission = Find(root, "mission")) ReadMission(*mission);
    for (const Value* obstacle : TablesAt(root, "obstacle")) {
      AddPlaces(*obstacle, {.name = TextAt(*obstacle, "id"), .kind = "obstacle"});
    }
    for (const Value* vehicle : TablesAt(root, "vehicle")) ReadVehicle(*vehicle);
    std::stable_sort(plan_.handles.begin(), plan_.handles.end(),
                     [](const PlanHandle& a, const PlanHandle& b) {
                       return a.points.front().whole.begin < b.points.front().whole.begin;
                     });
    return std::move(plan_);
  }

 private:
  void ReadMission(const Value& mission) {
    const auto* table = std::get_if<Table>(&mission.data);
    if (table == nullptr) return;
    const size_t begin = text_.ByteAt(mission.place);
    if (text_.text().substr(begin).starts_with("[")) plan_.mission_keys = text_.NextLine(begin);
    Add(*table, "op_area", PlanShape::kPolygon, {.kind = "op_area"});
  }

  void ReadVehicle(const Value& vehicle) {
    const auto& table = std::get<Table>(vehicle.data);
    PlanVehicle known = {.name = TextAt(vehicle, "name")};
    known.end = text_.NextLine(EndOf(vehicle));
    AddStart(table, known.name);
    if (const Table* home = TableAt(table, "return")) {
      Add(*home, "point", PlanShape::kPoint, {.vehicle = known.name, .kind = "return"});
    }
    for (const char* list : {"task", "behavior"}) {
      for (const Value* each : TablesAt(table, list)) {
        const std::string kind = TextAt(*each, "kind");
        const std::string name = TextAt(*each, "name");
        if (list == std::string_view("task")) {
          known.task_names.push_back(name.empty() ? kind : name);
        }
        AddPlaces(*each, {.vehicle = known.name,
                          .name = name.empty() ? kind : name,
                          .kind = kind,
                          .updates = TextAt(*each, "updates")});
      }
    }
    plan_.vehicles.push_back(std::move(known));
  }

  /// Of a vehicle without a start in the file, and without a template that may have one, the place
  /// where it could stand.
  void AddStart(const Table& table, const std::string& name) {
    PlanHandle handle = {.vehicle = name, .kind = "start", .key = "start"};
    if (const Value* start = Find(table, "start")) {
      const auto* keys = std::get_if<Table>(&start->data);
      const Value* x = keys == nullptr ? nullptr : Find(*keys, "x_m");
      const Value* y = keys == nullptr ? nullptr : Find(*keys, "y_m");
      if (x == nullptr || y == nullptr || !NumberOf(*x) || !NumberOf(*y)) return;
      const TextSpan x_span = SpanOf(*x);
      const TextSpan y_span = SpanOf(*y);
      handle.points.push_back(
          {.x_m = *NumberOf(*x),
           .y_m = *NumberOf(*y),
           .x = x_span,
           .y = y_span,
           .whole = {std::min(x_span.begin, y_span.begin), std::max(x_span.end, y_span.end)}});
    } else {
      const Value* named = Find(table, "name");
      if (named == nullptr || Find(table, "template") != nullptr) return;
      if (Find(table, "track") != nullptr) return;  // It has its own.
      const size_t line = text_.NextLine(text_.ByteAt(named->place));
      handle.points.push_back({.whole = {line, line}});
    }
    plan_.handles.push_back(std::move(handle));
  }

  void AddPlaces(const Value& value, const PlanHandle& owner) {
    const auto& table = std::get<Table>(value.data);
    if (Find(table, "points_frame") != nullptr) return;
    for (const KeyRow& row : kPlaceKeys) Add(table, row.key, row.shape, owner);
  }

  void Add(const Table& table, std::string_view key, PlanShape shape, PlanHandle handle) {
    const Value* value = Find(table, key);
    const auto* array = value == nullptr ? nullptr : std::get_if<Array>(&value->data);
    if (array == nullptr) return;
    handle.key = key;
    handle.shape = shape;
    if (shape == PlanShape::kPoint) {
      const auto point = PointOf(*value);
      if (!point) return;
      handle.points.push_back(*point);
    } else {
      for (const Value& each : *array) {
        const auto point = PointOf(each);
        if (!point) return;
        handle.points.push_back(*point);
      }
    }
    if (!handle.points.empty()) plan_.handles.push_back(std::move(handle));
  }

  /// Reads [x, y], or [x, y, depth].
  std::optional<PlanPoint> PointOf(const Value& value) const {
    const auto* array = std::get_if<Array>(&value.data);
    if (array == nullptr || array->size() < 2 || array->size() > 3) return std::nullopt;
    const auto x_m = NumberOf((*array)[0]);
    const auto y_m = NumberOf((*array)[1]);
    if (!x_m || !y_m) return std::nullopt;
    return PlanPoint{.x_m = *x_m,
                     .y_m = *y_m,
                     .x = SpanOf((*array)[0]),
                     .y = SpanOf((*array)[1]),
                     .whole = SpanOf(value)};
  }

  TextSpan SpanOf(const Value& value) const { return text_.ValueAt(text_.ByteAt(value.place)); }

  /// Returns the end of the last thing that the file has of a table.
  size_t EndOf(const Value& value) const {
    size_t end = 0;
    if (const auto* table = std::get_if<Table>(&value.data)) {
      // A header has no value: what follows it belongs to it. An inline table ends itself.
      end = text_.ByteAt(value.place);
      if (text_.text().substr(end).starts_with("{")) return text_.ValueAt(end).end;
      for (const Entry& entry : *table) end = std::max(end, EndOf(entry.value));
      return end;
    }
    const auto* array = std::get_if<Array>(&value.data);
    const bool has_headers =
        array != nullptr && !array->empty() && std::holds_alternative<Table>(array->front().data) &&
        !text_.text().substr(text_.ByteAt(array->front().place)).starts_with("{");
    if (!has_headers) return SpanOf(value).end;
    for (const Value& each : *array) end = std::max(end, EndOf(each));
    return end;
  }

  TomlText text_;
  PlanText plan_;
};

}  // namespace

std::optional<PlanText> ReadPlan(std::string_view text) {
  Problems problems("", {});
  const std::optional<Value> root = ParseToml(text, problems);
  if (!root) return std::nullopt;
  return PlanReader(text).Read(std::get<Table>(root->data));
}

}  // namespace shoal
