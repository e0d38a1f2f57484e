#include "lib/tools/moos/import_behaviors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/bhv_keys.h"
#include "lib/tools/moos/bhv_leg.h"
#include "lib/tools/moos/bhv_points.h"
#include "lib/tools/moos/bhv_text.h"
#include "lib/tools/moos/contact_templates.h"

namespace shoal {
namespace {

constexpr size_t kMax = 200;

std::string TomlTexts(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) {
    list += (list.empty() ? "" : ", ") + TomlString(text);
  }
  return "[" + list + "]";
}

/// A setting for several lines, or for one.
struct Gathered {
  std::vector<std::string> texts;  ///< Of a list.
  std::string value;               ///< Of anything else, as TOML.
  std::string origins;
  std::string line_texts;
  std::string remark;
  bool is_essential = false;
};

class BlockImporter {
 public:
  BlockImporter(const BhvBlock& block, BhvImport* import)
      : block_(block), import_(*import), kind_(KindOfBhv(block.type)) {}

  void Run() {
    if (kind_.empty()) return Unknown();
    const size_t num_warnings = import_.warnings.size();
    table_.header = "[[vehicle.behavior]]";
    table_.lines.push_back({.key = "kind",
                            .value = TomlString(kind_),
                            .origin = block_.origin,
                            .text = "Behavior = " + block_.type,
                            .reason = "",
                            .is_essential = true});
    for (const MoosLine& line : block_.lines) {
      const std::string key = LowerCase(line.key.substr(0, 64));
      if (key == "templating") is_template_ = LowerCase(WithoutQuotes(line.value)) != "disallowed";
    }
    for (const MoosLine& line : block_.lines) Take(line);
    TakeCenter();
    TakeDefaults();
    for (const std::string& key : order_) {
      Gathered& gathered = gathered_.at(key);
      table_.lines.push_back(
          {.key = key,
           .value = gathered.texts.empty() ? gathered.value : TomlTexts(gathered.texts),
           .origin = gathered.origins,
           .text = gathered.line_texts,
           .reason = gathered.remark,
           .is_essential = gathered.is_essential});
    }
    if (is_refused_) {
      for (DraftLine& line : table_.lines) {
        if (line.key.empty()) continue;
        line.key.clear();
        if (line.reason.empty()) line.reason = "its behavior is left out";
      }
      // One line for the behavior, none for its other keys.
      import_.warnings.resize(num_warnings);
      import_.warnings.push_back(refusal_);
      import_.lost.push_back(
          fmt::format("{}: Behavior = {}: {}", block_.origin, block_.type, refusal_));
    } else {
      ++import_.num_behaviors;
    }
    import_.tables.push_back(std::move(table_));
  }

 private:
  void Unknown() {
    const std::string text = "Behavior = " + block_.type;
    const std::optional<std::string_view> nearest = NearestKind(block_.type);
    const bool draws_only = nearest && nearest->empty();
    std::string reason = "no kind of behavior in shoal";
    if (draws_only) reason = "draws only: nothing is lost";
    if (nearest && !draws_only) reason += fmt::format("; the nearest is {}", *nearest);
    table_.header = "# " + block_.origin + ": a behavior that is left out.";
    table_.lines.push_back(
        {.key = "", .value = "", .origin = block_.origin, .text = text, .reason = reason});
    for (const MoosLine& line : block_.lines) {
      table_.lines.push_back({.key = "",
                              .value = "",
                              .origin = line.origin,
                              .text = line.text,
                              .reason = "its behavior is left out"});
    }
    if (!draws_only) {
      import_.warnings.push_back(fmt::format("{}: {}: {}", block_.origin, text, reason));
      import_.lost.push_back(import_.warnings.back());
    }
    import_.tables.push_back(std::move(table_));
  }

  void Remark(const MoosLine& line, std::string reason, bool is_loss) {
    if (is_loss) {
      import_.warnings.push_back(fmt::format("{}: {}: {}", line.origin, line.text, reason));
    }
    table_.lines.push_back({.key = "",
                            .value = "",
                            .origin = line.origin,
                            .text = line.text,
                            .reason = std::move(reason)});
  }

  /// The value makes no sense: the key is left out, an essential one with its behavior.
  void Refuse(const MoosLine& line, std::string reason, bool is_essential = false) {
    if (is_essential) {
      reason += ": the behavior is left out";
      if (!is_refused_) refusal_ = fmt::format("{}: {}: {}", line.origin, line.text, reason);
      is_refused_ = true;
    }
    Remark(line, std::move(reason), true);
  }

  Gathered& At(const std::string& key) {
    if (!gathered_.contains(key)) order_.push_back(key);
    return gathered_[key];
  }

  /// Sets a key; a value of an earlier line becomes a comment.
  void Set(const std::string& key, std::string value, const MoosLine& line, bool is_essential,
           std::string remark = "") {
    Gathered& gathered = At(key);
    if (!gathered.origins.empty()) {
      table_.lines.push_back({.key = "",
                              .value = "",
                              .origin = gathered.origins,
                              .text = gathered.line_texts,
                              .reason = "replaced by " + line.origin});
    }
    gathered = {.texts = {},
                .value = std::move(value),
                .origins = line.origin,
                .line_texts = line.text,
                .remark = std::move(remark),
                .is_essential = is_essential};
  }

  void Append(const std::string& key, std::vector<std::string> texts, const MoosLine& line,
              bool is_essential) {
    Gathered& gathered = At(key);
    gathered.texts.insert(gathered.texts.end(), texts.begin(), texts.end());
    gathered.origins += (gathered.origins.empty() ? "" : ", ") + line.origin;
    gathered.line_texts += (gathered.line_texts.empty() ? "" : ", ") + line.text;
    gathered.is_essential = is_essential;
  }

  /// A key that MOOS-IvP does not set, but that has another default there.
  void Assume(const std::string& key, std::string value, std::string remark) {
    if (gathered_.contains(key)) return;
    At(key) = {.texts = {},
               .value = std::move(value),
               .origins = "",
               .line_texts = "",
               .remark = std::move(remark)};
  }

  void Take(const MoosLine& line) {
    const std::string key = LowerCase(line.key.substr(0, 64));
    const std::string_view value = WithoutQuotes(line.value);
    if (TakeSpecial(line, key, value)) return;
    if (const BhvKey* row = FindBhvKey(kind_, key)) return TakeRow(*row, line, value);
    if (const BhvLostKey* lost = FindLostBhvKey(kind_, key)) {
      return Remark(line, std::string(lost->reason), lost->is_loss);
    }
    Remark(line, fmt::format("no key of {} in shoal", kind_), true);
  }

  /// True for the keys that a spawned behavior gets from what it is spawned for.
  bool IsOfOneSpawned(const std::string& key) const {
    if (key == "contact" || key == "them") return true;
    return kind_ == "avoid_obstacle" && (key == "polygon" || key == "poly" || key == "id");
  }

  /// Keys whose value means more than itself. Returns false for any other.
  bool TakeSpecial(const MoosLine& line, const std::string& key, std::string_view value) {
    const std::string word = LowerCase(value.substr(0, 64));
    if (key == "templating" && word == "disallowed") {
      Remark(line, "not needed: it is what behaviors are", false);
    } else if (key == "duration" && (word == "no-time-limit" || word == "notimelimit")) {
      has_duration_ = true;
      Remark(line, "not needed: behaviors last without end", false);
    } else if (key == "nostarve" || key == "no_starve") {
      TakeNostarve(line, value);
    } else if (is_template_ && IsOfOneSpawned(key)) {
      Remark(line, "filled in when one is spawned", false);
    } else if (kind_ == "waypoint" && key == "capture_line") {
      TakeCaptureLine(line, word);
    } else if ((kind_ == "waypoint" || kind_ == "leg_run") && key == "repeat") {
      const auto number = NumberIn(value);
      if (word == "forever") {
        Set("repeat", "-1", line, false);
      } else if (number) {
        Set("repeat", TomlNumber(*number), line, false);
      } else {
        Refuse(line, "not a number or forever");
      }
    } else if (kind_ == "loiter" && key.ends_with("center_assign")) {
      TakeCenterLine(line, key, value);
    } else if (kind_ == "leg_run" && TakeLeg(line, key, value)) {
      return true;
    } else if (kind_ == "op_region" && key == "polygon" && !IsOldRegion() &&
               !IsRegionThatRecovers()) {
      Refuse(line, "OpRegionV24 has no such key, but core_poly");
    } else if (kind_ == "leg_run" && key.starts_with("turn_")) {
      return TakeBothTurns(line, key);
    } else if (kind_ == "fixed_turn" && key == "speed") {
      const auto number = NumberIn(value);
      if (!number && word != "auto") {
        Refuse(line, "not a number or auto");
      } else {
        Set("speed", number ? TomlNumber(*number) : "-1", line, false);
      }
    } else if (kind_ == "cut_range" && key == "patience") {
      constexpr double kMost = 85;
      const auto number = NumberIn(value);
      if (!number || *number <= kMost || *number > 100) return false;
      Set("patience", TomlNumber(kMost), line, false, "As MOOS-IvP limits it.");
    } else if (kind_ == "zigzag" && key == "max_zig_zags") {
      const auto number = NumberIn(value);
      if (!number) return Refuse(line, "not a number"), true;
      Set("max_zig_legs", TomlNumber(*number * 2), line, false);
    } else if (kind_ == "test_failure" && key == "failure_type") {
      TakeFailure(line, word);
    } else {
      return false;
    }
    return true;
  }

  void TakeNostarve(const MoosLine& line, std::string_view value) {
    std::vector<std::string> names = PartsOf(value, ",");
    const auto seconds = names.empty() ? std::nullopt : NumberIn(names.back());
    if (!seconds || names.size() < 2) return Refuse(line, "not VARIABLE, ..., SECONDS");
    names.pop_back();
    for (const std::string& name : names) import_.variables.insert(name);
    Append("nostarve", std::move(names), line, false);
    Set("nostarve_s", TomlNumber(*seconds), line, false);
  }

  void TakeCaptureLine(const MoosLine& line, const std::string& word) {
    if (word == "absolute") {
      Set("capture_line", "true", line, false);
      Set("capture_line_only", "true", line, false);
    } else if (word == "true" || word == "false") {
      Set("capture_line", word, line, false);
    } else {
      Refuse(line, "not true, false or absolute");
    }
  }

  void TakeCenterLine(const MoosLine& line, const std::string& key, std::string_view value) {
    if (key == "center_assign" && LowerCase(value.substr(0, 32)) == "present_position") {
      return Set("center_activate", "true", line, false);
    }
    std::vector<double> numbers;
    for (const std::string& part : PartsOf(value, ",")) {
      const size_t equals = part.find('=');
      numbers.push_back(
          NumberIn(std::string_view(part).substr(equals == part.npos ? 0 : equals + 1))
              .value_or(std::nan("")));
    }
    const bool is_one = key != "center_assign";
    const bool is_sound = numbers.size() == (is_one ? 1U : 2U) &&
                          std::all_of(numbers.begin(), numbers.end(),
                                      [](double number) { return std::isfinite(number); });
    if (!is_sound) return Refuse(line, is_one ? "not a number" : "not x,y");
    if (key != "ycenter_assign") center_x_m_ = numbers.front();
    if (key != "xcenter_assign") center_y_m_ = numbers.back();
    Remark(line, "the polygon is moved there: the middle of the box around it", false);
  }

  /// Moves a loiter's polygon to where center_assign puts it.
  void TakeCenter() {
    if (polygon_m_.empty() || (!center_x_m_ && !center_y_m_)) return;
    Eigen::Vector2d low_m = polygon_m_.front();
    Eigen::Vector2d high_m = low_m;
    for (const Eigen::Vector2d& vertex_m : polygon_m_) {
      low_m = low_m.cwiseMin(vertex_m);
      high_m = high_m.cwiseMax(vertex_m);
    }
    const Eigen::Vector2d middle_m = (low_m + high_m) / 2;
    const Eigen::Vector2d offset_m(center_x_m_.value_or(middle_m.x()) - middle_m.x(),
                                   center_y_m_.value_or(middle_m.y()) - middle_m.y());
    for (Eigen::Vector2d& vertex_m : polygon_m_) vertex_m += offset_m;
    At("polygon").value = TomlPoints(polygon_m_);
  }

  bool TakeBothTurns(const MoosLine& line, const std::string& key) {
    const std::string rest = key.substr(std::string_view("turn").size());
    if (FindBhvKey(kind_, "turn1" + rest) == nullptr) return false;
    for (const char* turn : {"turn1", "turn2"}) {
      TakeRow(*FindBhvKey(kind_, turn + rest), line, WithoutQuotes(line.value));
    }
    return true;
  }

  void TakeFailure(const MoosLine& line, const std::string& word) {
    const size_t comma = word.find(',');
    const std::string type(Trimmed(std::string_view(word).substr(0, comma)));
    Set("failure_type", TomlString(type), line, false);
    if (comma == word.npos) return;
    const auto seconds = NumberIn(std::string_view(word).substr(comma + 1));
    if (!seconds) return Refuse(line, "not burn,SECONDS");
    Set("burn_time", TomlNumber(*seconds), line, false);
  }

  bool IsOldRegion() const { return LowerCase(block_.type).ends_with("opregion"); }
  bool IsRegionThatRecovers() const { return LowerCase(block_.type).ends_with("opregionrecover"); }

  void TakeDefaults() {
    const bool has_turns = gathered_.contains("turn1_rad") && gathered_.contains("turn2_rad");
    if (kind_ == "leg_run" && !has_turns) {
      import_.warnings.push_back(
          fmt::format("{}: Behavior = {}: has no turn_rad: MOOS-IvP's does nothing then, here it "
                      "turns with 20 m",
                      block_.origin, block_.type));
    }
    if (kind_ == "max_depth") {
      Assume("tolerance", "100", "As MOOS-IvP has it where it is not given.");
    }
    if (kind_ == "op_region" && IsOldRegion() && !gathered_.contains("trigger_entry_time")) {
      Assume("trigger_on_poly_entry", "false",
             "As MOOS-IvP's OpRegion: a start outside is a breach.");
    }
    if (LowerCase(block_.type).ends_with("aborttopoint")) {
      Assume("capture_radius", "25", "As MOOS-IvP's AbortToPoint has it.");
      Assume("slip_radius", "200", "As MOOS-IvP's AbortToPoint has it.");
    }
    if (kind_ == "periodic_surface") {
      const auto mark = gathered_.find("mark_variable");
      const bool is_given = mark != gathered_.end() && mark->second.value.size() > 2;
      import_.variables.insert(is_given
                                   ? mark->second.value.substr(1, mark->second.value.size() - 2)
                                   : "GPS_UPDATE_RECEIVED");
    }
    TakeDistances();
    const bool is_constant = kind_.starts_with("constant_");
    if (is_constant && !has_duration_ && !gathered_.contains("duration")) {
      import_.warnings.push_back(
          fmt::format("{}: Behavior = {}: has no duration: MOOS-IvP ends it at once, here it lasts "
                      "without end",
                      block_.origin, block_.type));
    }
  }

  /// Where the distances of avoidance cross, MOOS-IvP moves one of them, and shoal refuses.
  void TakeDistances() {
    const bool is_obstacle = kind_ == "avoid_obstacle";
    if (!is_obstacle && kind_ != "avoid_collision" && kind_ != "colregs") return;
    const bool is_plain = kind_ == "avoid_collision";
    const double outer_m = NumberAt("pwt_outer_dist", is_obstacle ? 50 : is_plain ? 200 : 100);
    const double inner_m = NumberAt("pwt_inner_dist", is_obstacle ? 10 : is_plain ? 50 : 90);
    const double completed_m = NumberAt("completed_dist", is_obstacle ? 50 : is_plain ? 500 : 100);
    if (inner_m >= outer_m) {
      Move("pwt_inner_dist", outer_m * 0.9, "Assumed: less than pwt_outer_dist, as it must be.");
    }
    if (completed_m < outer_m) {
      Move("completed_dist", outer_m, "Assumed: not less than pwt_outer_dist, as it must be.");
    }
  }

  double NumberAt(const std::string& key, double otherwise) const {
    const auto at = gathered_.find(key);
    return at == gathered_.end() ? otherwise : NumberIn(at->second.value).value_or(otherwise);
  }

  void Move(const std::string& key, double value, std::string remark) {
    Gathered& gathered = At(key);
    gathered.value = TomlNumber(value);
    gathered.remark = std::move(remark);
  }

  void TakeRow(const BhvKey& row, const MoosLine& line, std::string_view value) {
    const std::string key(row.key);
    switch (row.value) {
      case BhvValue::kNumber:
      case BhvValue::kInteger: {
        const auto number = NumberIn(value);
        if (!number) return Refuse(line, "not a number", row.is_essential);
        return Set(key, TomlNumber(*number), line, row.is_essential);
      }
      case BhvValue::kFlag: {
        const std::string word = LowerCase(value.substr(0, 8));
        if (word != "true" && word != "false") return Refuse(line, "not true or false");
        return Set(key, word, line, row.is_essential);
      }
      case BhvValue::kText:
        if (key == "updates") import_.variables.emplace(value);
        return Set(key, TomlString(value), line, row.is_essential);
      case BhvValue::kWord: {
        std::string word = LowerCase(value.substr(0, 64));
        if (word == "star") word = "starboard";
        return Set(key, TomlString(word), line, row.is_essential);
      }
      case BhvValue::kTexts: {
        const bool is_condition = key == "condition";
        std::string text = is_condition ? ConditionText(line.value) : std::string(value);
        if (text.empty()) return Refuse(line, "is empty", row.is_essential);
        if (is_condition) CollectVariables(text, &import_.variables);
        if (is_condition) CollectVariables(text, &import_.condition_variables);
        return Append(key, {std::move(text)}, line, row.is_essential);
      }
      case BhvValue::kNames:
        return Append(key, PartsOf(value, ",:"), line, row.is_essential);
      case BhvValue::kNumbers:
      case BhvValue::kPairs:
        return TakeNumbers(row, line, value);
      case BhvValue::kPoints:
      case BhvValue::kPoint:
        return TakePoints(row, line, value);
    }
  }

  /// "1, 1.5 : 2", or "5,60 : 10" as pairs.
  void TakeNumbers(const BhvKey& row, const MoosLine& line, std::string_view value) {
    const bool is_pairs = row.value == BhvValue::kPairs;
    std::string list;
    for (const std::string& part : PartsOf(value, is_pairs ? ":" : ",:")) {
      std::vector<double> numbers;
      for (const std::string& word : PartsOf(part, ",")) {
        const auto number = NumberIn(word);
        if (!number) return Refuse(line, "not numbers", row.is_essential);
        numbers.push_back(*number);
      }
      if (is_pairs && numbers.size() == 1) numbers.push_back(0);
      if (numbers.size() != (is_pairs ? 2U : 1U)) {
        return Refuse(line, "not DEPTH,SECONDS : ...", row.is_essential);
      }
      list += list.empty() ? "" : ", ";
      list += is_pairs ? fmt::format("[{}, {}]", TomlNumber(numbers[0]), TomlNumber(numbers[1]))
                       : TomlNumber(numbers[0]);
    }
    if (list.empty()) return Refuse(line, "is empty", row.is_essential);
    Set(std::string(row.key), "[" + list + "]", line, row.is_essential);
  }

  void TakePoints(const BhvKey& row, const MoosLine& line, std::string_view value) {
    const bool is_point =
        row.value == BhvValue::kPoint || (kind_ == "waypoint" && row.moos_key == "point");
    const bool is_empty = kind_ == "waypoint" && LowerCase(value.substr(0, 8)) == "empty";
    Result<BhvPoints> points = is_empty              ? Result<BhvPoints>(BhvPoints{})
                               : is_point            ? ParseBhvPoint(value)
                               : kind_ == "waypoint" ? ParseBhvPoints(value)
                                                     : ParseBhvPolygon(value);
    if (!points.ok()) return Refuse(line, points.error(), row.is_essential);
    if (points->points_m.empty())
      return Remark(line, "no points until an update brings them", false);
    std::string remark;
    if (!points->assumed.empty()) remark = "Assumed: " + points->assumed + ".";
    if (row.value == BhvValue::kPoint) {
      if (kind_ == "leg_run") leg_.SetEnd(row.key == "p1" ? 0 : 1, points->points_m.front());
      return Set(std::string(row.key), TomlPoint(points->points_m.front()), line, row.is_essential,
                 std::move(remark));
    }
    if (kind_ == "loiter") {
      ToLoiter(&points->points_m);
      polygon_m_ = points->points_m;
    }
    Set(std::string(row.key), TomlPoints(points->points_m), line, row.is_essential,
        std::move(remark));
  }

  static std::string TomlPoint(const Eigen::Vector2d& point_m) {
    return fmt::format("[{}, {}]", TomlNumber(point_m.x()), TomlNumber(point_m.y()));
  }

  /// A loiter's polygon is to a tenth of a metre, and clockwise.
  static void ToLoiter(std::vector<Eigen::Vector2d>* polygon_m) {
    constexpr double kSteps = 10;  // Per metre.
    double area_m2 = 0;
    for (size_t i = 0; i < polygon_m->size(); ++i) {
      Eigen::Vector2d& corner_m = (*polygon_m)[i];
      corner_m = (corner_m * kSteps).array().round() / kSteps + 0.0;
    }
    for (size_t i = 0; i < polygon_m->size(); ++i) {
      const Eigen::Vector2d& corner_m = (*polygon_m)[i];
      const Eigen::Vector2d& next_m = (*polygon_m)[(i + 1) % polygon_m->size()];
      area_m2 += corner_m.x() * next_m.y() - corner_m.y() * next_m.x();
    }
    if (area_m2 > 0) std::reverse(polygon_m->begin(), polygon_m->end());
  }

  /// Keys of a leg that move both of its ends. Returns false for any other.
  bool TakeLeg(const MoosLine& line, const std::string& key, std::string_view value) {
    if (!BhvLeg::IsKey(key)) return false;
    const std::string problem = leg_.Take(key, value);
    if (!problem.empty()) return Refuse(line, problem, key == "leg"), true;
    Set("p1", TomlPoint(leg_.end_m(0)), line, true);
    Set("p2", TomlPoint(leg_.end_m(1)), line, true);
    return true;
  }

  const BhvBlock& block_;
  BhvImport& import_;
  std::string_view kind_;
  BhvTable table_;
  std::vector<std::string> order_;
  std::map<std::string, Gathered> gathered_;
  std::vector<Eigen::Vector2d> polygon_m_;
  BhvLeg leg_;
  std::optional<double> center_x_m_;
  std::optional<double> center_y_m_;
  bool is_template_ = false;
  bool has_duration_ = false;
  bool is_refused_ = false;
  std::string refusal_;
};

/// A key of a TOML table, in quotes where it needs them.
std::string TomlKey(std::string_view name) {
  const bool is_bare = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return IsNameCharacter(c) || c == '-';
  });
  return is_bare ? std::string(name) : TomlString(name);
}

void ImportMode(const BhvMode& mode, BhvImport* import) {
  BhvTable table{.header = "[[vehicle.mode]]", .lines = {}};
  const auto set = [&](std::string key, std::string value, std::string origin, std::string text) {
    table.lines.push_back({.key = std::move(key),
                           .value = std::move(value),
                           .origin = std::move(origin),
                           .text = std::move(text),
                           .reason = "",
                           .is_essential = true});
  };
  const std::string declared = mode.variable + " = " + mode.value;
  set("set", TomlString(declared), mode.origin, "set " + declared);
  std::vector<std::string> conditions;
  std::string origins;
  std::string texts;
  for (const MoosLine& line : mode.conditions) {
    conditions.push_back(ConditionText(line.text));
    CollectVariables(conditions.back(), &import->variables);
    CollectVariables(conditions.back(), &import->condition_variables);
    origins += (origins.empty() ? "" : ", ") + line.origin;
    texts += (texts.empty() ? "" : ", ") + line.text;
  }
  if (!conditions.empty()) set("condition", TomlTexts(conditions), origins, texts);
  if (!mode.otherwise.empty()) {
    set("else", TomlString(mode.otherwise), mode.origin, "} " + mode.otherwise);
  }
  import->tables.push_back(std::move(table));
}

/// Orders set these where they are variables: those of conditions that no line initializes are
/// made so.
void AddOrderVariables(const BhvImport& import, BhvTable* table) {
  for (const char* name : {"DEPLOY", "RETURN", "STATION_KEEP"}) {
    const bool is_there = std::any_of(table->lines.begin(), table->lines.end(),
                                      [&](const DraftLine& line) { return line.key == name; });
    if (is_there || !import.condition_variables.contains(name)) continue;
    table->lines.push_back({.key = name,
                            .value = TomlString("false"),
                            .origin = "",
                            .text = "",
                            .reason = "Assumed: conditions name it, an order sets it."});
  }
}

/// No name of a behavior may be the beginning of another's in shoal: "leg" beside "leg2" becomes
/// "leg_1".
void SetNamesApart(std::vector<BhvTable>* tables) {
  std::vector<DraftLine*> names;
  for (BhvTable& table : *tables) {
    for (DraftLine& line : table.lines) {
      if (table.header == "[[vehicle.behavior]]" && line.key == "name") names.push_back(&line);
    }
  }
  // In quotes: without the last one.
  const auto begins = [](const std::string& other, std::string_view name) {
    return other.size() > name.size() && other.starts_with(name.substr(0, name.size() - 1));
  };
  for (DraftLine* line : names) {
    const std::string plain = line->value.substr(0, line->value.size() - 1);
    std::string wanted = line->value;
    const auto is_beginning = [&](const DraftLine* other) {
      return other != line && begins(other->value, wanted);
    };
    const auto is_same = [&](const DraftLine* other) {
      return other != line && other->value == wanted;
    };
    for (size_t i = 1; std::any_of(names.begin(), names.end(), is_beginning) ||
                       (i > 1 && std::any_of(names.begin(), names.end(), is_same));
         ++i) {
      wanted = fmt::format("{}_{}\"", plain, i);
    }
    if (wanted == line->value) continue;
    line->value = wanted;
    line->reason = "Assumed: another behavior's name begins with it.";
  }
}

BhvTable ImportVariables(const BhvFile& file, BhvImport* import) {
  BhvTable table{.header = "[vehicle.variables]", .lines = {}};
  std::map<std::string, size_t> places;
  for (const MoosLine& line : file.initials) {
    import->variables.insert(line.key);
    const auto number = NumberIn(line.value);
    const bool is_text = !number || line.value.starts_with('"');
    DraftLine setting{
        .key = TomlKey(line.key),
        .value = is_text ? TomlString(WithoutQuotes(line.value)) : TomlNumber(*number),
        .origin = line.origin,
        .text = "initialize " + line.text,
        .reason = ""};
    const auto [at, is_new] = places.emplace(setting.key, table.lines.size());
    if (!is_new) {
      DraftLine& earlier = table.lines[at->second];
      earlier.key.clear();
      earlier.reason = "replaced by " + line.origin;
      at->second = table.lines.size();
    }
    table.lines.push_back(std::move(setting));
  }
  return table;
}

/// Returns the first kMax of a list; names what is left out.
template <class Item>
std::vector<Item> Bounded(std::vector<Item> items, std::string_view what, BhvImport* import) {
  if (items.size() <= kMax) return items;
  import->warnings.push_back(fmt::format("{}: {} are left out from here on: {} are the most",
                                         items[kMax].origin, what, kMax));
  items.resize(kMax);
  return items;
}

}  // namespace

BhvImport ImportBhv(const BhvFile& whole, const std::vector<std::string>& contacts) {
  BhvImport import;
  BhvFile file = whole;
  file.initials = Bounded(std::move(file.initials), "variables", &import);
  file.modes = Bounded(std::move(file.modes), "modes", &import);
  file.behaviors = Bounded(std::move(file.behaviors), "behaviors", &import);
  BhvTable variables = ImportVariables(file, &import);
  for (const BhvMode& mode : file.modes) ImportMode(mode, &import);
  for (const BhvBlock& block : file.behaviors) {
    CollectVariablesOfContacts(block, contacts, &import.variables);
    if (!NeedsOneForEach(block)) {
      BlockImporter(block, &import).Run();
      continue;
    }
    for (const BhvBlock& one : OneForEach(block, contacts)) BlockImporter(one, &import).Run();
    if (!contacts.empty()) continue;
    import.warnings.push_back(
        fmt::format("{}: Behavior = {}: is left out: it is about contacts, and the mission has no "
                    "other vehicle",
                    block.origin, block.type));
    import.lost.push_back(import.warnings.back());
  }
  SetNamesApart(&import.tables);
  AddOrderVariables(import, &variables);
  if (!variables.lines.empty()) import.tables.insert(import.tables.begin(), std::move(variables));
  BhvTable odd{.header = "# What else stands in " + file.name + ".", .lines = {}};
  for (const MoosOddLine& line : file.odd_lines) {
    odd.lines.push_back(
        {.key = "", .value = "", .origin = line.origin, .text = line.text, .reason = line.reason});
    if (line.is_loss) {
      import.warnings.push_back(
          fmt::format("{}: {} {}", line.origin, Quoted(line.text), line.reason));
      import.lost.push_back(import.warnings.back());
    }
  }
  if (!odd.lines.empty()) import.tables.push_back(std::move(odd));
  return import;
}

}  // namespace shoal
