#include "lib/tools/moos/bhv_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {
namespace {

constexpr size_t kMaxPoints = 10'000;
constexpr double kRadPerDeg = std::numbers::pi / 180;

using Values = std::map<std::string, std::string, std::less<>>;

/// Returns the number under a key, `otherwise` where it is absent, NaN where it is none.
double NumberOf(const Values& values, std::string_view key, double otherwise) {
  const auto at = values.find(key);
  if (at == values.end()) return otherwise;
  return NumberIn(at->second).value_or(std::nan(""));
}

Error Wrong(std::string_view text, std::string_view problem) {
  return Error{
      fmt::format("{}: {}; write x,y:x,y, pts={{x,y:x,y}}, format=radial, format=ellipse or "
                  "format=lawnmower",
                  Quoted(text), problem)};
}

/// Drops what a sine leaves behind the sixth place.
double Rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

Eigen::Vector2d Snapped(const Eigen::Vector2d& point_m, double snap_m) {
  if (snap_m <= 0) return {Rounded(point_m.x()), Rounded(point_m.y())};
  return {Rounded(std::round(point_m.x() / snap_m) * snap_m),
          Rounded(std::round(point_m.y() / snap_m) * snap_m)};
}

/// Returns a vector turned clockwise.
Eigen::Vector2d Turned(const Eigen::Vector2d& vector, double angle_deg) {
  const auto [sine, cosine] = SinCos(angle_deg * kRadPerDeg);
  return {vector.x() * cosine + vector.y() * sine, vector.y() * cosine - vector.x() * sine};
}

std::string_view WithoutBraces(std::string_view text) {
  text = Trimmed(text);
  if (text.size() >= 2 && text.front() == '{' && text.back() == '}') {
    text = Trimmed(text.substr(1, text.size() - 2));
  }
  return text;
}

Result<BhvPoints> ParseList(std::string_view whole) {
  BhvPoints list;
  std::string_view text = WithoutBraces(whole);
  while (true) {
    const size_t end = std::min(text.find(':'), text.size());
    const std::string_view part = Trimmed(text.substr(0, end));
    const size_t comma = part.find(',');
    const std::string_view first = Trimmed(part.substr(0, comma));
    const auto x_m = NumberIn(first);
    const size_t second = std::min(part.find(',', comma + 1), part.size());
    const auto y_m =
        comma == part.npos ? std::nullopt : NumberIn(part.substr(comma + 1, second - comma - 1));
    const bool is_annotation = !x_m && comma != part.npos && !first.empty() &&
                               ((first[0] | 0x20) >= 'a' && (first[0] | 0x20) <= 'z');
    if (x_m && y_m) {
      if (second < part.size()) list.assumed = "a third coordinate of points is not used";
      list.points_m.emplace_back(*x_m, *y_m);
    } else if (!is_annotation) {
      return Wrong(whole, "not x,y:x,y");
    }
    if (list.points_m.size() > kMaxPoints) return Wrong(whole, "more than 10,000 points");
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  if (list.points_m.empty()) return Wrong(whole, "no points");
  return list;
}

/// Returns false for NaN too.
bool IsWithin(double value, double min, double max) { return value >= min && value <= max; }

Result<BhvPoints> MakeRound(std::string_view text, const Values& values, bool is_ellipse) {
  const Eigen::Vector2d center_m(NumberOf(values, "x", std::nan("")),
                                 NumberOf(values, "y", std::nan("")));
  const double major_m =
      is_ellipse ? NumberOf(values, "major", 0) / 2 : NumberOf(values, "radius", 0);
  const double minor_m = is_ellipse ? NumberOf(values, "minor", 0) / 2 : major_m;
  const double count = NumberOf(values, "pts", 0);
  const double snap_m = NumberOf(values, values.contains("snap") ? "snap" : "snap_value", 0);
  double angle_deg = NumberOf(values, "degs", 0);
  if (values.contains("rads")) angle_deg = NumberOf(values, "rads", 0) / kRadPerDeg;
  if (!center_m.allFinite()) return Wrong(text, "x and y must be numbers");
  if (!IsWithin(major_m, 1e-3, 1e6) || !IsWithin(minor_m, 1e-3, 1e6)) {
    return Wrong(text,
                 is_ellipse ? "major and minor must be above 0 m" : "radius must be above 0 m");
  }
  if (!IsWithin(count, 3, 1000)) return Wrong(text, "pts must be 3 to 1000");
  if (!IsWithin(snap_m, 0, 1e6) || !IsWithin(angle_deg, -1e6, 1e6)) {
    return Wrong(text, "snap and degs must be numbers");
  }
  BhvPoints round;
  const int num_points = static_cast<int>(count);
  for (int i = 0; i < num_points; ++i) {
    const double at_rad = (i + 0.5) * 2 * std::numbers::pi / num_points;
    const Eigen::Vector2d from_center_m(minor_m * Sin(at_rad), major_m * Cos(at_rad));
    const Eigen::Vector2d vertex_m = center_m + Turned(from_center_m, angle_deg);
    round.points_m.push_back(Snapped(vertex_m, snap_m));
  }
  // A coarse snap may put neighbours on the same point.
  const auto last = std::unique(round.points_m.begin(), round.points_m.end());
  round.points_m.erase(last, round.points_m.end());
  while (round.points_m.size() > 1 && round.points_m.front() == round.points_m.back()) {
    round.points_m.pop_back();
  }
  if (is_ellipse) round.assumed = "degs is the compass direction of the long axis";
  return round;
}

Result<BhvPoints> MakeLawnmower(std::string_view text, const Values& values) {
  const Eigen::Vector2d center_m(NumberOf(values, "x", std::nan("")),
                                 NumberOf(values, "y", std::nan("")));
  const Eigen::Vector2d start_m(NumberOf(values, "startx", 0), NumberOf(values, "starty", 0));
  const double width_m = NumberOf(values, "width", 0);
  const double height_m = NumberOf(values, "height", 0);
  const double lane_m = NumberOf(values, values.contains("lane_width") ? "lane_width" : "swath", 0);
  const double angle_deg = NumberOf(values, "degs", 0);
  const auto rows = values.find("rows");
  std::string direction = rows == values.end() ? "north-south" : LowerCase(rows->second);
  std::erase_if(direction, [](char c) { return c == ' '; });
  const bool is_ns = direction == "north-south" || direction == "ns";
  if (!is_ns && direction != "east-west" && direction != "ew") {
    return Wrong(text, "rows must be north-south or east-west");
  }
  if (!center_m.allFinite() || !start_m.allFinite() || !std::isfinite(angle_deg)) {
    return Wrong(text, "x, y, startx, starty and degs must be numbers");
  }
  if (!IsWithin(width_m, 1e-3, 1e6) || !IsWithin(height_m, 1e-3, 1e6) ||
      !IsWithin(lane_m, 1e-3, 1e6)) {
    return Wrong(text, "width, height and lane_width must be above 0 m");
  }
  const double across_m = is_ns ? width_m : height_m;
  const double along_m = is_ns ? height_m : width_m;
  const double num_steps = std::floor(across_m / lane_m + 1e-9);
  constexpr int kMaxLanes = kMaxPoints / 2;  // Each has two ends.
  if (num_steps > kMaxLanes - 1) return Wrong(text, "more than 5,000 lanes");
  const int num_lanes = static_cast<int>(num_steps) + 1;
  std::vector<Eigen::Vector2d> best;
  for (const double side : {-1.0, 1.0}) {
    for (const double end : {1.0, -1.0}) {
      std::vector<Eigen::Vector2d> lanes;
      for (int i = 0; i < num_lanes; ++i) {
        const double from_center_m = side * (i * lane_m - num_steps * lane_m / 2);
        const double first_m = (i % 2 == 0 ? end : -end) * along_m / 2;
        for (const double at_m : {first_m, -first_m}) {
          const Eigen::Vector2d vector_m =
              is_ns ? Eigen::Vector2d(from_center_m, at_m) : Eigen::Vector2d(at_m, from_center_m);
          lanes.push_back(Snapped(center_m + Turned(vector_m, angle_deg), 0));
        }
      }
      if (best.empty() || (lanes.front() - start_m).norm() < (best.front() - start_m).norm()) {
        best = std::move(lanes);
      }
    }
  }
  return BhvPoints{.points_m = std::move(best),
                   .assumed =
                       "lanes evenly about x, y, turned clockwise by degs, from the corner "
                       "nearest to startx, starty"};
}

Result<BhvPoints> ParseForm(std::string_view whole, std::string_view form, std::string_view text) {
  Values values;
  if (!form.empty()) values["format"] = form;
  const auto fields = ParseFields(text);
  if (!fields.ok()) return Wrong(whole, fields.error());
  for (const MoosField& field : *fields) values[LowerCase(field.key)] = field.value;
  const std::string format = LowerCase(values.contains("format") ? values["format"] : "");
  if (format == "radial") return MakeRound(whole, values, false);
  if (format == "ellipse") return MakeRound(whole, values, true);
  if (format == "lawnmower") return MakeLawnmower(whole, values);
  if (!format.empty()) return Wrong(whole, "a form without counterpart");
  const auto pts = values.find("pts");
  return pts == values.end() ? Wrong(whole, "no pts=") : ParseList(pts->second);
}

/// "radial:x,y,radius,pts,snap", as older files have it.
Result<BhvPoints> ParseOldRadial(std::string_view whole, std::string_view text) {
  Values values;
  for (const char* key : {"x", "y", "radius", "pts", "snap"}) {
    if (text.empty()) break;
    const size_t end = std::min(text.find(','), text.size());
    values[key] = Trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!text.empty()) return Wrong(whole, "more than x, y, radius, pts and snap");
  return MakeRound(whole, values, false);
}

}  // namespace

Result<BhvPoints> ParseBhvPoints(std::string_view text) {
  text = Trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = Trimmed(text.substr(1, text.size() - 2));
  }
  for (const std::string_view form : {"radial", "ellipse", "lawnmower"}) {
    if (LowerCase(text.substr(0, form.size())) != form) continue;
    std::string_view rest = Trimmed(text.substr(form.size()));
    if (!rest.starts_with(':')) continue;
    while (rest.starts_with(':')) rest.remove_prefix(1);
    const bool is_old = form == "radial" && rest.find('=') == rest.npos;
    return is_old ? ParseOldRadial(text, rest) : ParseForm(text, form, rest);
  }
  return text.find('=') == text.npos ? ParseList(text) : ParseForm(text, "", text);
}

std::string TomlPoints(const std::vector<Eigen::Vector2d>& points_m) {
  std::string points;
  for (const Eigen::Vector2d& point_m : points_m) {
    points += fmt::format("{}[{}, {}]", points.empty() ? "" : ", ", TomlNumber(point_m.x()),
                          TomlNumber(point_m.y()));
  }
  return "[" + points + "]";
}

}  // namespace shoal
