#include "lib/mission/file/expand.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/mission/model/names.h"
#include "lib/mission/model/vehicle.h"
#include "lib/mission/toml/fields.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_reader.h"

namespace shoal {
namespace {

// A short hostile file could ask for a template of megabytes times ten thousand vehicles.
constexpr int64_t kMaxValues = 2'000'000;

/// `[[fleet]]`: like vehicles in rows, the first at the origin, rows from West to East, each row
/// North of the one before.
struct Fleet {
  std::string template_name;
  std::string name_pattern = "boat_{n}";
  int64_t count = 0;
  double origin_x_m = 0;
  double origin_y_m = 0;
  double spacing_m = 20;
  int64_t columns = 0;  ///< 0: all in one row.
  double heading_deg = 0;
  bool has_heading = false;  ///< Otherwise the template's.
};

void Describe(Fields& fields, Fleet& fleet) {
  fields.Require("template", "template = \"survey_boat\", together with a [template.survey_boat]");
  fields.Text("template", fleet.template_name, {});
  fields.Require("count", "count = 10");
  fields.Integer("count", fleet.count, 1, static_cast<int64_t>(kMaxVehicles));
  fields.Text("name", fleet.name_pattern, {});
  fields.Inline("origin", [&](Fields& origin) {
    origin.Number("x_m", fleet.origin_x_m, Between(-1e6, 1e6));
    origin.Number("y_m", fleet.origin_y_m, Between(-1e6, 1e6));
  });
  fields.Number("spacing_m", fleet.spacing_m, Above(0, 1e5));
  fields.Integer("columns", fleet.columns, 1, static_cast<int64_t>(kMaxVehicles));
  fleet.has_heading = fields.Has("heading_deg", fleet.has_heading);
  fields.Number("heading_deg", fleet.heading_deg, Between(-360, 360));
}

/// A name with a number in it, from "boat_{n}" or, with leading zeros, "boat_{n:02}".
struct NamePattern {
  std::string before;
  std::string after;
  int width = 0;

  std::string NameOf(int64_t n) const { return fmt::format("{}{:0{}}{}", before, n, width, after); }
};

std::optional<NamePattern> ParseNamePattern(std::string_view text) {
  const size_t open = text.find("{n");
  const size_t close = text.find('}');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
    return std::nullopt;
  }
  const std::string_view width = text.substr(open + 2, close - open - 2);
  NamePattern pattern = {std::string(text.substr(0, open)), std::string(text.substr(close + 1))};
  if (width.empty()) return pattern;
  if (width.size() != 3 || width[0] != ':' || width[1] != '0' || width[2] < '1' || width[2] > '9') {
    return std::nullopt;
  }
  pattern.width = width[2] - '0';
  return pattern;
}

/// Lays `over` onto `under`: tables are merged, anything else is replaced.
void LayOver(Table& under, const Table& over) {
  for (const Entry& entry : over) {
    Value* below = Find(under, entry.key);
    Table* below_table = below == nullptr ? nullptr : std::get_if<Table>(&below->data);
    const Table* table = std::get_if<Table>(&entry.value.data);
    if (below_table != nullptr && table != nullptr) {
      LayOver(*below_table, *table);
    } else {
      Set(under, entry.key, entry.key_place, entry.value);
    }
  }
}

struct NamedFleet {
  Fleet fleet;
  std::optional<NamePattern> names;  ///< Absent where the name is wrong, which has been reported.
};

NamedFleet ReadFleet(const Value& source, Problems& problems) {
  NamedFleet read;
  TableReader reader(source, "fleet", problems);
  Describe(reader, read.fleet);
  read.names = ParseNamePattern(read.fleet.name_pattern);
  if (!read.names) {
    reader.Refuse("name", "the name " + Quoted(read.fleet.name_pattern) +
                              " of a fleet must hold its number: boat_{n}, or boat_{n:02} for "
                              "boat_01, boat_02, ...");
  }
  return read;
}

void Remove(Table& table, std::string_view key) {
  std::erase_if(table, [&](const Entry& entry) { return entry.key == key; });
}

/// Returns the template, a table, that `user` names; reports where there is none.
const Value* FindTemplate(const Table& templates, const Table& user, Problems& problems) {
  const Value* name = Find(user, "template");
  if (name == nullptr) return nullptr;
  const auto* text = std::get_if<std::string>(&name->data);
  if (text == nullptr) {
    problems.Add(name->place, "template must be a string in quotes, not " + WhatIs(*name));
    return nullptr;
  }
  if (const Value* found = Find(templates, *text)) {
    // One that is not a table is reported where templates are checked.
    return std::holds_alternative<Table>(found->data) ? found : nullptr;
  }
  std::vector<std::string_view> known;
  for (const Entry& entry : templates) known.push_back(entry.key);
  std::string hint = DidYouMean(*text, known);
  if (hint.empty()) hint = "; add a table [template.NAME] with the keys that its vehicles share";
  problems.Add(name->place, "unknown template " + Quoted(*text) + hint);
  return nullptr;
}

/// Lays templates over those that they inherit from.
class Inheritance {
 public:
  Inheritance(const Table& templates, Problems& problems)
      : templates_(templates), problems_(problems) {}

  /// Returns the template in full, without the key `template`.
  Table Resolve(const Entry& entry) {
    const std::vector<const Entry*> line = LineOf(entry);
    Table full;
    // From the one that inherits from none to the one that is asked for.
    for (auto each = line.rbegin(); each != line.rend(); ++each) {
      LayOver(full, std::get<Table>((*each)->value.data));
    }
    Remove(full, "template");
    num_values_ += CountValues({entry.value.place, full});
    if (num_values_ <= kMaxValues) return full;
    problems_.Add(entry.key_place,
                  fmt::format("more than {} values in all templates together, with "
                              "what they inherit; make them smaller or fewer",
                              kMaxValues));
    return {};
  }

  bool is_full() const { return num_values_ > kMaxValues; }

 private:
  static constexpr size_t kMaxGenerations = 100;

  /// Returns the template, the one that it names, the one that this names, and so on. Where that
  /// cannot be, it is reported, and the line ends.
  std::vector<const Entry*> LineOf(const Entry& entry) {
    std::vector<const Entry*> line = {&entry};
    while (true) {
      const Table& last = std::get<Table>(line.back()->value.data);
      const Value* base = FindTemplate(templates_, last, problems_);
      if (base == nullptr) return line;
      const auto found = std::find_if(templates_.begin(), templates_.end(),
                                      [&](const Entry& each) { return &each.value == base; });
      const Place& place = Find(last, "template")->place;
      const auto before = std::find(line.begin(), line.end(), &*found);
      if (before != line.end()) {
        // Reported once, and only for templates that are part of the circle.
        if (before == line.begin()) problems_.Add(place, CircleText(line));
        return line;
      }
      if (line.size() == kMaxGenerations) {
        problems_.Add(
            place, fmt::format("more than {} templates inherit from one another", kMaxGenerations));
        return line;
      }
      line.push_back(&*found);
    }
  }

  static std::string CircleText(const std::vector<const Entry*>& line) {
    constexpr size_t kMaxShown = 5;
    std::string way;
    for (size_t i = 0; i < line.size() && i < kMaxShown; ++i)
      way += Quoted(line[i]->key) + " from ";
    if (line.size() > kMaxShown) way += "... from ";
    return "a template must not inherit from itself: " + way + Quoted(line.front()->key);
  }

  const Table& templates_;
  Problems& problems_;
  int64_t num_values_ = 0;
};

class Expansion {
 public:
  Expansion(const Table& root, Problems& problems) : problems_(problems) {
    const Value* templates = Find(root, "template");
    if (templates == nullptr) return;
    if (const auto* table = std::get_if<Table>(&templates->data)) templates_ = *table;
  }

  void AddVehicle(const Value& vehicle) {
    const auto* own = std::get_if<Table>(&vehicle.data);
    if (own == nullptr || Find(*own, "template") == nullptr) {
      if (own != nullptr) WarnOfOtherModels(*own, *own);
      Add(vehicle);
      return;
    }
    Table full;
    if (const Value* base = FindTemplate(*own)) full = std::get<Table>(base->data);
    LayOver(full, *own);
    Remove(full, "template");
    WarnOfOtherModels(*own, full);
    Add({vehicle.place, std::move(full)});
  }

  void AddFleet(const Value& source) {
    const auto [fleet, names] = ReadFleet(source, problems_);
    const auto* own = std::get_if<Table>(&source.data);
    const Value* base = own == nullptr ? nullptr : FindTemplate(*own);
    if (base == nullptr || !names) return;
    if (!HasRoomFor(fleet.count, CountValues(*base), source.place)) return;
    for (int64_t i = 0; i < fleet.count; ++i) {
      vehicles_.push_back(Member(source, fleet, *names, std::get<Table>(base->data), i));
    }
  }

  Array TakeVehicles() { return std::move(vehicles_); }

 private:
  /// A template may have tables for vehicles of several models; in a vehicle's `own` table that of
  /// another model than `full` names has no effect.
  void WarnOfOtherModels(const Table& own, const Table& full) {
    const Value* model = Find(full, "model");
    const auto* text = model == nullptr ? nullptr : std::get_if<std::string>(&model->data);
    if (model != nullptr && text == nullptr) return;  // Reported where vehicles are read.
    const std::string chosen = text == nullptr ? std::string(FactsOfModel(AnyModel()).name) : *text;
    for (const AnyModel& each : EachModel()) {
      const std::string_view name = FactsOfModel(each).name;
      const Value* table = name == chosen ? nullptr : Find(own, name);
      if (table == nullptr) continue;
      problems_.Warn(table->place,
                     fmt::format("[vehicle.{0}] has no effect, as the vehicle is a {1}: write "
                                 "model = \"{0}\" in it, or leave the table out",
                                 name, chosen));
    }
  }

  /// Returns the template of a vehicle or fleet.
  const Value* FindTemplate(const Table& user) {
    return shoal::FindTemplate(templates_, user, problems_);
  }

  /// Returns vehicle `i` of a fleet, counted from 0.
  static Value Member(const Value& source, const Fleet& fleet, const NamePattern& pattern,
                      const Table& base, int64_t i) {
    const int64_t columns = fleet.columns == 0 ? fleet.count : fleet.columns;
    const int64_t row = i / columns;
    const int64_t column = i % columns;
    const double x_m = fleet.origin_x_m + static_cast<double>(column) * fleet.spacing_m;
    const double y_m = fleet.origin_y_m + static_cast<double>(row) * fleet.spacing_m;
    const Place& place = source.place;
    const Value* name = Find(std::get<Table>(source.data), "name");
    Table start = {{"x_m", place, {place, x_m}}, {"y_m", place, {place, y_m}}};
    if (fleet.has_heading) start.push_back({"heading_deg", place, {place, fleet.heading_deg}});
    Table own = {{"name", place, {name == nullptr ? place : name->place, pattern.NameOf(i + 1)}},
                 {"start", place, {place, std::move(start)}}};
    Table full = base;
    LayOver(full, own);
    Remove(full, "template");
    return {place, std::move(full)};
  }

  void Add(Value vehicle) {
    if (HasRoomFor(1, CountValues(vehicle), vehicle.place)) vehicles_.push_back(std::move(vehicle));
  }

  /// Counts `count` more vehicles of `values_each` values; reports the first excess.
  bool HasRoomFor(int64_t count, int64_t values_each, const Place& place) {
    if (full_) return false;
    num_vehicles_ += count;
    num_values_ += count * values_each;
    full_ = num_vehicles_ > static_cast<int64_t>(kMaxVehicles) || num_values_ > kMaxValues;
    if (!full_) return true;
    problems_.Add(
        place,
        num_values_ <= kMaxValues
            ? fmt::format("more than {} vehicles, the most that a mission can have", kMaxVehicles)
            : fmt::format("more than {} values in all vehicles together; make the "
                          "templates smaller or the fleets fewer",
                          kMaxValues));
    return false;
  }

  Table templates_;
  Problems& problems_;
  Array vehicles_;
  int64_t num_vehicles_ = 0;
  int64_t num_values_ = 0;
  bool full_ = false;
};

}  // namespace

void ExpandTemplates(Value& root, Problems& problems) {
  Value* templates = Find(std::get<Table>(root.data), "template");
  Table* table = templates == nullptr ? nullptr : std::get_if<Table>(&templates->data);
  if (table == nullptr) return;
  Inheritance inheritance(*table, problems);
  Table full;
  for (const Entry& entry : *table) {
    const auto* own = std::get_if<Table>(&entry.value.data);
    if (own == nullptr || Find(*own, "template") == nullptr) {
      full.push_back(entry);
      continue;
    }
    // Templates that no longer find room are empty: that has been reported.
    Table resolved = inheritance.is_full() ? Table() : inheritance.Resolve(entry);
    full.push_back({entry.key, entry.key_place, {entry.value.place, std::move(resolved)}});
  }
  *table = std::move(full);
}

void ExpandVehicles(Value& root, Problems& problems) {
  Table& table = std::get<Table>(root.data);
  Expansion expansion(table, problems);
  Value* vehicles = Find(table, "vehicle");
  if (vehicles != nullptr && !std::holds_alternative<Array>(vehicles->data)) {
    return;  // [vehicle] in single brackets: reported where vehicles are read.
  }
  if (vehicles != nullptr) {
    for (const Value& vehicle : std::get<Array>(vehicles->data)) expansion.AddVehicle(vehicle);
  }
  const Value* fleets = Find(table, "fleet");
  const Array* fleet_array = fleets == nullptr ? nullptr : std::get_if<Array>(&fleets->data);
  if (fleets != nullptr && fleet_array == nullptr) {
    problems.Add(fleets->place,
                 "there may be several tables fleet: write [[fleet]] in double brackets");
  }
  if (fleet_array != nullptr) {
    for (const Value& fleet : *fleet_array) expansion.AddFleet(fleet);
  }
  const Place place = vehicles != nullptr ? vehicles->place
                      : fleets != nullptr ? fleets->place
                                          : root.place;
  Array all = expansion.TakeVehicles();
  if (vehicles != nullptr || !all.empty())
    Set(table, "vehicle", place, Value{place, std::move(all)});
}

}  // namespace shoal
