#include "lib/tools/moos/import_block.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/bhv_defaults.h"
#include "lib/tools/moos/bhv_keys.h"
#include "lib/tools/moos/bhv_leg.h"
#include "lib/tools/moos/bhv_loiter.h"
#include "lib/tools/moos/bhv_points.h"
#include "lib/tools/moos/bhv_settings.h"
#include "lib/tools/moos/bhv_text.h"

namespace shoal {
namespace {

/// A behavior that shoal has no kind for becomes comments, and is lost unless it only draws.
void ImportUnknown(const BhvBlock& block, BhvImport* import) {
  BhvTable table;
  const std::string text = "Behavior = " + block.type;
  const std::optional<std::string_view> nearest = NearestKind(block.type);
  const bool draws_only = nearest && nearest->empty();
  std::string reason = "no kind of behavior in shoal";
  if (draws_only) reason = "draws only: nothing is lost";
  if (nearest && !draws_only) reason += fmt::format("; the nearest is {}", *nearest);
  table.header = "# " + block.origin + ": a behavior that is left out.";
  table.lines.push_back(
      {.key = "", .value = "", .origin = block.origin, .text = text, .reason = reason});
  for (const MoosLine& line : block.lines) {
    table.lines.push_back({.key = "",
                           .value = "",
                           .origin = line.origin,
                           .text = line.text,
                           .reason = "its behavior is left out"});
  }
  if (!draws_only) {
    import->warnings.push_back(fmt::format("{}: {}: {}", block.origin, text, reason));
    import->lost.push_back(import->warnings.back());
  }
  import->tables.push_back(std::move(table));
}

std::string TomlPoint(const Eigen::Vector2d& point_m) {
  return fmt::format("[{}, {}]", TomlNumber(point_m.x()), TomlNumber(point_m.y()));
}

bool IsCaptureFlag(std::string_view key) { return key == "capture_flag" || key == "arrival_flag"; }

class BlockImporter {
 public:
  BlockImporter(const BhvBlock& block, BhvImport* import)
      : block_(block), import_(*import), kind_(KindOfBhv(block.type)) {}

  void Run() {
    if (kind_.empty()) return ImportUnknown(block_, &import_);
    const size_t num_warnings = import_.warnings.size();
    settings_.Add({.key = "kind",
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
    if (loiter_.MoveToCenter()) settings_.Move("polygon", TomlPoints(loiter_.polygon_m()), "");
    if (IsSimpleWaypoint()) SetSimplePoint();
    if (kind_ == "periodic_surface") {
      const std::string_view mark = settings_.ValueOf("mark_variable");  // In quotes.
      import_.variables.emplace(mark.size() > 2 ? mark.substr(1, mark.size() - 2)
                                                : "GPS_UPDATE_RECEIVED");
    }
    SetBhvDefaults(block_, kind_, has_duration_, &settings_, &import_.warnings);
    BhvTable table = std::move(settings_).Finished();
    if (is_refused_) {
      for (DraftLine& line : table.lines) {
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
    import_.tables.push_back(std::move(table));
  }

 private:
  void Remark(const MoosLine& line, std::string reason, bool is_loss) {
    if (is_loss) {
      import_.warnings.push_back(fmt::format("{}: {}: {}", line.origin, line.text, reason));
    }
    settings_.Remark(line, std::move(reason));
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

  void Take(const MoosLine& line) {
    const std::string key = LowerCase(line.key.substr(0, 64));
    const std::string_view value = WithoutQuotes(line.value);
    if (TakeSpecial(line, key, value)) return;
    if (const BhvKey* row = FindBhvKey(kind_, key)) return TakeRow(*row, line, value);
    if (const BhvLostKey* lost = FindLostBhvKey(kind_, key)) {
      if (lost->names_variable) {
        import_.unposted.push_back({.variable = std::string(value),
                                    .line = fmt::format("{}: {}", line.origin, line.text)});
      }
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
    } else if ((kind_ == "waypoint" || kind_ == "leg_run") && key == "capture_line") {
      TakeCaptureLine(line, word);
    } else if ((kind_ == "waypoint" || kind_ == "leg_run") && key == "repeat") {
      const auto number = NumberIn(value);
      if (word == "forever") {
        settings_.Set("repeat", "-1", line, false);
      } else if (number) {
        settings_.Set("repeat", TomlNumber(*number), line, false);
      } else {
        Refuse(line, "not a number or forever");
      }
    } else if (IsSimpleWaypoint() && (key == "ptx" || key == "pty")) {
      TakeSimplePoint(line, key, value);
    } else if (IsSimpleWaypoint() && key == "ipf_type") {
      settings_.Set("ipf_type", TomlString(word == "reflector" ? "roc" : word), line, false);
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
        settings_.Set("speed", number ? TomlNumber(*number) : "-1", line, false);
      }
    } else if (kind_ == "cut_range" && key == "patience") {
      constexpr double kMost = 85;
      const auto number = NumberIn(value);
      if (!number || *number <= kMost || *number > 100) return false;
      settings_.Set("patience", TomlNumber(kMost), line, false, "As MOOS-IvP limits it.");
    } else if (kind_ == "zigzag" && key == "max_zig_zags") {
      const auto number = NumberIn(value);
      if (!number) return Refuse(line, "not a number"), true;
      settings_.Set("max_zig_legs", TomlNumber(*number * 2), line, false);
    } else if (kind_ == "go_to_depth" && IsCaptureFlag(key) && value.find('=') == value.npos) {
      // MOOS-IvP posts how many depths were reached, with this before the name.
      settings_.Append("capture_flag", {fmt::format("GTD_{} = $[CTR]", value)}, line, false);
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
    settings_.Append("nostarve", names, line, false);
    settings_.Set("nostarve_s", TomlNumber(*seconds), line, false);
  }

  void TakeCaptureLine(const MoosLine& line, const std::string& word) {
    if (word == "absolute") {
      settings_.Set("capture_line", "true", line, false);
      settings_.Set("capture_line_only", "true", line, false);
    } else if (word == "true" || word == "false") {
      settings_.Set("capture_line", word, line, false);
    } else {
      Refuse(line, "not true, false or absolute");
    }
  }

  void TakeCenterLine(const MoosLine& line, const std::string& key, std::string_view value) {
    if (key == "center_assign" && LowerCase(value.substr(0, 32)) == "present_position") {
      return settings_.Set("center_activate", "true", line, false);
    }
    const std::string problem = loiter_.TakeCenter(key, value);
    if (!problem.empty()) return Refuse(line, problem);
    Remark(line, "the polygon is moved there: the middle of the box around it", false);
  }

  /// The behavior of moos-ivp-extend, which own behaviors of others begin with.
  bool IsSimpleWaypoint() const { return LowerCase(block_.type).ends_with("simplewaypoint"); }

  void TakeSimplePoint(const MoosLine& line, const std::string& key, std::string_view value) {
    const auto number = NumberIn(value);
    if (!number) return Refuse(line, "not a number", true);
    simple_point_m_(key == "ptx" ? 0 : 1) = *number;
    simple_lines_.Add(line.origin, line.text);
  }

  void SetSimplePoint() {
    const MoosLine line{
        .origin = simple_lines_.origins, .text = simple_lines_.texts, .key = "points", .value = ""};
    settings_.Set("points", TomlPoints({simple_point_m_}), line, true);
    settings_.Assume("capture_radius", "10", "As moos-ivp-extend's SimpleWaypoint has it.");
    settings_.Assume("slip_radius", "0", "As moos-ivp-extend's SimpleWaypoint has it.");
    import_.warnings.push_back(
        fmt::format("{}: Behavior = {}: taken as that of moos-ivp-extend: a waypoint of one point",
                    block_.origin, block_.type));
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
    settings_.Set("failure_type", TomlString(type), line, false);
    if (comma == word.npos) return;
    const auto seconds = NumberIn(std::string_view(word).substr(comma + 1));
    if (!seconds) return Refuse(line, "not burn,SECONDS");
    settings_.Set("burn_time", TomlNumber(*seconds), line, false);
  }

  bool IsOldRegion() const { return LowerCase(block_.type).ends_with("opregion"); }
  bool IsRegionThatRecovers() const { return LowerCase(block_.type).ends_with("opregionrecover"); }

  void TakeRow(const BhvKey& row, const MoosLine& line, std::string_view value) {
    const std::string key(row.key);
    switch (row.value) {
      case BhvValue::kNumber:
      case BhvValue::kInteger: {
        const auto number = NumberIn(value);
        if (!number) return Refuse(line, "not a number", row.is_essential);
        return settings_.Set(key, TomlNumber(*number), line, row.is_essential);
      }
      case BhvValue::kFlag: {
        const std::string word = LowerCase(value.substr(0, 8));
        if (word != "true" && word != "false") return Refuse(line, "not true or false");
        return settings_.Set(key, word, line, row.is_essential);
      }
      case BhvValue::kText:
        if (key == "updates") import_.variables.emplace(value);
        return settings_.Set(key, TomlString(value), line, row.is_essential);
      case BhvValue::kPosted: {
        const bool is_silent = LowerCase(value.substr(0, 8)) == "silent";
        if (!is_silent) import_.variables.emplace(value);
        return settings_.Set(key, TomlString(is_silent ? "" : value), line, row.is_essential);
      }
      case BhvValue::kWord: {
        std::string word = LowerCase(value.substr(0, 64));
        if (word == "star") word = "starboard";
        return settings_.Set(key, TomlString(word), line, row.is_essential);
      }
      case BhvValue::kTexts: {
        const bool is_condition = key == "condition";
        std::string text = is_condition ? ConditionText(line.value) : std::string(value);
        if (text.empty()) return Refuse(line, "is empty", row.is_essential);
        if (is_condition) CollectVariables(text, &import_.variables);
        if (is_condition) CollectVariables(text, &import_.condition_variables);
        return settings_.Append(key, {std::move(text)}, line, row.is_essential);
      }
      case BhvValue::kNames:
        return settings_.Append(key, PartsOf(value, ",:"), line, row.is_essential);
      case BhvValue::kNumbers:
      case BhvValue::kPairs:
        return TakeNumbers(row, line, value);
      case BhvValue::kPoints:
      case BhvValue::kPoint:
        return TakePoints(row, line, value);
    }
  }

  void TakeNumbers(const BhvKey& row, const MoosLine& line, std::string_view value) {
    const Result<std::string> list = TomlNumbers(value, row.value == BhvValue::kPairs);
    if (!list.ok()) return Refuse(line, list.error(), row.is_essential);
    settings_.Set(std::string(row.key), *list, line, row.is_essential);
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
      return settings_.Set(std::string(row.key), TomlPoint(points->points_m.front()), line,
                           row.is_essential, std::move(remark));
    }
    if (kind_ == "loiter") {
      loiter_.SetPolygon(points->points_m);
      points->points_m = loiter_.polygon_m();
    }
    settings_.Set(std::string(row.key), TomlPoints(points->points_m), line, row.is_essential,
                  std::move(remark));
  }

  /// Keys of a leg that move both of its ends. Returns false for any other.
  bool TakeLeg(const MoosLine& line, const std::string& key, std::string_view value) {
    if (!BhvLeg::IsKey(key)) return false;
    const std::string problem = leg_.Take(key, value);
    if (!problem.empty()) return Refuse(line, problem, key == "leg"), true;
    settings_.Set("p1", TomlPoint(leg_.end_m(0)), line, true);
    settings_.Set("p2", TomlPoint(leg_.end_m(1)), line, true);
    return true;
  }

  const BhvBlock& block_;
  BhvImport& import_;
  std::string_view kind_;
  BhvSettings settings_{"[[vehicle.behavior]]"};
  BhvLeg leg_;
  BhvLoiter loiter_;
  Eigen::Vector2d simple_point_m_ = Eigen::Vector2d::Zero();
  DraftOrigins simple_lines_;
  bool is_template_ = false;
  bool has_duration_ = false;
  bool is_refused_ = false;
  std::string refusal_;
};

}  // namespace

void ImportBhvBlock(const BhvBlock& block, BhvImport* import) {
  BlockImporter(block, import).Run();
}

}  // namespace shoal
