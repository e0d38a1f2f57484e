#include "lib/tools/moos/bhv_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
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

/// Returns the number under a key, `otherwise` where it is absent, NaN if it is not one.
double NumberOf(const Values& values, std::string_view key, double otherwise) {
  const auto at = values.find(key);
  if (at == values.end()) return otherwise;
  return NumberIn(at->second).value_or(std::nan(""));
}

Error Wrong(std::string_view text, std::string_view problem) {
  return Error{fmt::format(
      "{}: {}; write x,y:x,y, pts={{x,y:x,y}}, format=radial, ellipse, wedge, pylon, oval, "
      "lawnmower or bowtie, or zigzag: startx,starty,angle,length,period,amplitude",
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

/// Returns the numbers; nothing where a part is none.
std::optional<std::vector<double>> NumbersOf(std::string_view text, char separator) {
  std::vector<double> numbers;
  for (const std::string_view part : TrimmedParts(text, separator)) {
    const auto number = NumberIn(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Returns false for NaN too.
bool IsWithin(double value, double min, double max) { return value >= min && value <= max; }

bool BeginsWithLetter(std::string_view text) {
  return !text.empty() && (text[0] | 0x20) >= 'a' && (text[0] | 0x20) <= 'z';
}

/// Reads "x,y" or "x,y,z"; with names too where `may_be_named`.
std::optional<Eigen::Vector2d> ParsePair(std::string_view text, bool may_be_named, bool* has_z) {
  std::vector<std::string_view> parts = TrimmedParts(text, ',');
  if (parts.size() < 2) return std::nullopt;
  for (size_t i = 0; i < 2 && may_be_named; ++i) {
    if (parts[i].starts_with(i == 0 ? "x=" : "y=")) parts[i].remove_prefix(2);
  }
  const auto x_m = NumberIn(parts[0]);
  const auto y_m = NumberIn(parts[1]);
  if (!x_m || !y_m) return std::nullopt;
  *has_z = *has_z || parts.size() > 2;
  return Eigen::Vector2d(*x_m, *y_m);
}

Result<BhvPoints> ParseList(std::string_view whole, std::string_view text, bool may_be_named) {
  BhvPoints list;
  bool has_z = false;
  for (const std::string_view part : TrimmedParts(text, ':')) {
    if (const auto point_m = ParsePair(part, may_be_named, &has_z)) {
      list.points_m.push_back(*point_m);
    } else if (may_be_named || !BeginsWithLetter(part) || part.find(',') == part.npos ||
               part.find('=') != part.npos) {
      return Wrong(whole, "not x,y:x,y");
    }
    if (list.points_m.size() > kMaxPoints) return Wrong(whole, "more than 10,000 points");
  }
  if (list.points_m.empty()) return Wrong(whole, "no points");
  if (has_z) list.assumed = "a third coordinate of points is not used";
  return list;
}

/// Reads pts={...} among other fields; nothing where it is not there.
std::optional<Result<BhvPoints>> ParsePts(std::string_view whole, bool may_be_named) {
  size_t at = whole.find("pts");
  while (at != whole.npos && at > 0 && whole[at - 1] != ',' && whole[at - 1] != ' ') {
    at = whole.find("pts", at + 1);
  }
  if (at == whole.npos) return std::nullopt;
  std::string_view rest = Trimmed(whole.substr(at + 3));
  if (!rest.starts_with('=')) return std::nullopt;
  rest = Trimmed(rest.substr(1));
  if (!rest.starts_with('{')) return std::nullopt;
  const size_t close = rest.find('}');
  if (close == rest.npos) return Wrong(whole, "pts={ without }");
  return ParseList(whole, rest.substr(1, close - 1), may_be_named);
}

/// A coarse snap may put neighbours on the same point.
void DropEqualNeighbours(std::vector<Eigen::Vector2d>* points_m) {
  points_m->erase(std::unique(points_m->begin(), points_m->end()), points_m->end());
  while (points_m->size() > 1 && points_m->front() == points_m->back()) points_m->pop_back();
}

/// Returns the snap of a form; NaN if it is not one.
double SnapOf(const Values& values) {
  const double snap_m = NumberOf(values, values.contains("snap") ? "snap" : "snap_value", 0);
  return IsWithin(snap_m, 0, 1e6) ? snap_m : std::nan("");
}

Result<BhvPoints> MakeRadial(std::string_view text, const Values& values) {
  const Eigen::Vector2d center_m(
      NumberOf(values, "x", std::nan("")) + NumberOf(values, "shiftx", 0),
      NumberOf(values, "y", std::nan("")) + NumberOf(values, "shifty", 0));
  const double radius_m = NumberOf(values, "radius", 0);
  const double count = NumberOf(values, "pts", 0);
  const double snap_m = SnapOf(values);
  if (!center_m.allFinite()) return Wrong(text, "x and y must be numbers");
  if (!IsWithin(radius_m, 1e-3, 1e6)) return Wrong(text, "radius must be above 0 m");
  if (!IsWithin(count, 3, 1000)) return Wrong(text, "pts must be 3 to 1000");
  if (std::isnan(snap_m)) return Wrong(text, "snap must be a number");
  BhvPoints round;
  const int num_points = static_cast<int>(count);
  for (int i = 0; i < num_points; ++i) {
    const double at_deg = (i + 0.5) * 360 / num_points;
    const Eigen::Vector2d vertex_m = center_m + Turned(Eigen::Vector2d(0, radius_m), at_deg);
    round.points_m.push_back(Snapped(vertex_m, snap_m));
  }
  DropEqualNeighbours(&round.points_m);
  return round;
}

/// The long axis is turned from East, counterclockwise by degs or rads; so are the vertices, from
/// its far end.
Result<BhvPoints> MakeEllipse(std::string_view text, const Values& values) {
  const Eigen::Vector2d center_m(NumberOf(values, "x", std::nan("")),
                                 NumberOf(values, "y", std::nan("")));
  const double major_m = NumberOf(values, "major", 0) / 2;
  const double minor_m = NumberOf(values, "minor", 0) / 2;
  const double count = NumberOf(values, "pts", 0);
  const double snap_m = SnapOf(values);
  double angle_rad = NumberOf(values, "degs", std::nan("")) * kRadPerDeg;
  if (values.contains("rads")) angle_rad = NumberOf(values, "rads", 0);
  if (!center_m.allFinite()) return Wrong(text, "x and y must be numbers");
  if (!IsWithin(major_m, 1e-3, 1e6) || !IsWithin(minor_m, 1e-3, 1e6)) {
    return Wrong(text, "major and minor must be above 0 m");
  }
  if (!IsWithin(count, 4, 1000)) return Wrong(text, "pts must be 4 to 1000");
  if (std::isnan(snap_m) || !IsWithin(angle_rad, -1e6, 1e6)) {
    return Wrong(text, "degs (or rads) and snap must be numbers");
  }
  BhvPoints round;
  const int num_points = static_cast<int>(count);
  for (int i = 0; i < num_points; ++i) {
    const double at_rad = -std::numbers::pi + i * 2 * std::numbers::pi / num_points;
    const Eigen::Vector2d along_m(major_m * Cos(at_rad), minor_m * Sin(at_rad));
    round.points_m.push_back(Snapped(center_m + Turned(along_m, -angle_rad / kRadPerDeg), snap_m));
  }
  DropEqualNeighbours(&round.points_m);
  return round;
}

/// The center, then an arc of `pts` parts clockwise from lang to rang.
Result<BhvPoints> MakeWedge(std::string_view text, const Values& values) {
  const Eigen::Vector2d center_m(NumberOf(values, "x", std::nan("")),
                                 NumberOf(values, "y", std::nan("")));
  const double left_deg = NumberOf(values, "lang", std::nan(""));
  double right_deg = NumberOf(values, "rang", std::nan(""));
  const double range_m = NumberOf(values, "range", 0);
  const double count = std::max(NumberOf(values, "pts", 0), 1.0);
  const double snap_m = SnapOf(values);
  if (!center_m.allFinite() || !IsWithin(left_deg, -1e6, 1e6) || !IsWithin(right_deg, -1e6, 1e6)) {
    return Wrong(text, "x, y, lang and rang must be numbers");
  }
  if (!IsWithin(range_m, 1e-3, 1e6) || !IsWithin(count, 1, 1000) || std::isnan(snap_m)) {
    return Wrong(text, "range must be above 0 m, pts at most 1000, snap a number");
  }
  right_deg = left_deg + std::fmod(std::fmod(right_deg - left_deg, 360) + 360, 360);
  BhvPoints wedge{.points_m = {Snapped(center_m, snap_m)}, .assumed = ""};
  const int num_parts = static_cast<int>(count);
  for (int i = 0; i <= num_parts; ++i) {
    const double at_deg = left_deg + (right_deg - left_deg) * i / num_parts;
    wedge.points_m.push_back(
        Snapped(center_m + Turned(Eigen::Vector2d(0, range_m), at_deg), snap_m));
  }
  DropEqualNeighbours(&wedge.points_m);
  return wedge;
}

/// A rectangle about the line from x1, y1 to x2, y2.
Result<BhvPoints> MakePylon(std::string_view text, const Values& values) {
  const auto number = [&](std::string_view key) { return NumberOf(values, key, std::nan("")); };
  const Eigen::Vector2d from_m(number("x1"), number("y1"));
  const Eigen::Vector2d to_m(number("x2"), number("y2"));
  const double axis_m = NumberOf(values, "axis_pad", 0);
  const double perp_m = NumberOf(values, "perp_pad", 0);
  const double snap_m = SnapOf(values);
  if (!from_m.allFinite() || !to_m.allFinite() || from_m == to_m) {
    return Wrong(text, "x1, y1, x2 and y2 must be two different points");
  }
  if (!IsWithin(axis_m, 0, 1e6) || !IsWithin(perp_m, 1e-3, 1e6) || std::isnan(snap_m)) {
    return Wrong(text, "axis_pad, perp_pad and snap must be lengths, perp_pad above 0 m");
  }
  const Eigen::Vector2d along_m = (to_m - from_m).normalized() * axis_m;
  const Eigen::Vector2d right_m = Turned((to_m - from_m).normalized() * perp_m, 90);
  BhvPoints pylon;
  for (const Eigen::Vector2d& corner_m :
       {Eigen::Vector2d(from_m - along_m - right_m), Eigen::Vector2d(from_m - along_m + right_m),
        Eigen::Vector2d(to_m + along_m + right_m), Eigen::Vector2d(to_m + along_m - right_m)}) {
    pylon.points_m.push_back(Snapped(corner_m, snap_m));
  }
  return pylon;
}

/// Two half circles whose middles are len - 2 rad apart, along the compass direction ang.
Result<BhvPoints> MakeOval(std::string_view text, const Values& values) {
  constexpr int kParts = 12;  // Of each half circle, as MOOS-IvP draws it.
  const Eigen::Vector2d center_m(NumberOf(values, "x", std::nan("")),
                                 NumberOf(values, "y", std::nan("")));
  const double radius_m = NumberOf(values, "rad", 0);
  const double length_m = NumberOf(values, "len", 0);
  const double angle_deg = NumberOf(values, "ang", 0);
  if (!center_m.allFinite() || !IsWithin(angle_deg, -1e6, 1e6)) {
    return Wrong(text, "x, y and ang must be numbers");
  }
  if (!IsWithin(radius_m, 1e-3, 1e6) || !IsWithin(length_m, 2 * radius_m, 1e6)) {
    return Wrong(text, "rad must be above 0 m, len at least twice of it");
  }
  BhvPoints oval;
  for (const double end_deg : {angle_deg, angle_deg + 180}) {
    const Eigen::Vector2d middle_m =
        center_m + Turned(Eigen::Vector2d(0, length_m / 2 - radius_m), end_deg);
    for (int i = 0; i <= kParts; ++i) {
      const double at_deg = end_deg - 90 + 180.0 * i / kParts;
      oval.points_m.push_back(Snapped(middle_m + Turned(Eigen::Vector2d(0, radius_m), at_deg), 0));
    }
  }
  DropEqualNeighbours(&oval.points_m);
  return oval;
}

/// Lanes from one side in steps of a lane's width until they have passed the other side.
Result<BhvPoints> MakeLawnmower(std::string_view text, const Values& values) {
  const Eigen::Vector2d center_m(NumberOf(values, "x", std::nan("")),
                                 NumberOf(values, "y", std::nan("")));
  const double width_m = NumberOf(values, "width", 0);
  const double height_m = NumberOf(values, "height", 0);
  const double lane_m = NumberOf(values, values.contains("lane_width") ? "lane_width" : "swath", 0);
  const double angle_deg = NumberOf(values, "degs", 0);
  Eigen::Vector2d start_m(NumberOf(values, "startx", 0), NumberOf(values, "starty", 0));
  const double snap_m = SnapOf(values);
  const auto rows = values.find("rows");
  std::string direction = rows == values.end() ? "ew" : LowerCase(rows->second);
  std::erase_if(direction, [](char c) { return c == ' '; });
  const bool is_ns = direction == "north-south" || direction == "ns";
  if (!center_m.allFinite() || !start_m.allFinite() || !IsWithin(angle_deg, -1e6, 1e6)) {
    return Wrong(text, "x, y, startx, starty and degs must be numbers");
  }
  if (!IsWithin(width_m, 1e-3, 1e6) || !IsWithin(height_m, 1e-3, 1e6) ||
      !IsWithin(lane_m, 1e-3, 1e6) || std::isnan(snap_m)) {
    return Wrong(text, "width, height and lane_width must be above 0 m");
  }
  if (const auto corner = values.find("start"); corner != values.end()) {
    const std::string word = LowerCase(corner->second);
    const bool is_corner = word == "tl" || word == "tr" || word == "bl" || word == "br";
    if (!is_corner) return Wrong(text, "start must be tl, tr, bl or br");
    const Eigen::Vector2d out_m(word[1] == 'l' ? -width_m : width_m,
                                word[0] == 't' ? height_m : -height_m);
    start_m = center_m + out_m;
  }
  const double across_m = is_ns ? width_m : height_m;
  const double along_m = is_ns ? height_m : width_m;
  const double turn_deg = is_ns ? angle_deg : angle_deg + 90;
  const double num_steps = std::ceil(across_m / lane_m - 1e-5);
  constexpr int kMaxLanes = kMaxPoints / 2;  // Each has two ends.
  if (num_steps > kMaxLanes - 1) return Wrong(text, "more than 5,000 lanes");
  const int num_lanes = static_cast<int>(num_steps) + 1;
  BhvPoints best;
  for (const bool from_first : {true, false}) {
    for (const double end : {1.0, -1.0}) {
      std::vector<Eigen::Vector2d> lanes_m;
      for (int i = 0; i < num_lanes; ++i) {
        const int lane = from_first ? i : num_lanes - 1 - i;
        const double from_center_m = lane * lane_m - across_m / 2;
        const double first_m = (i % 2 == 0 ? end : -end) * along_m / 2;
        for (const double at_m : {first_m, -first_m}) {
          const Eigen::Vector2d vector_m = Turned(Eigen::Vector2d(from_center_m, at_m), turn_deg);
          lanes_m.push_back(Snapped(center_m + vector_m, snap_m));
        }
      }
      const double distance_m = (lanes_m.front() - start_m).norm();
      if (!best.points_m.empty() && distance_m > (best.points_m.front() - start_m).norm() - 1e-9) {
        continue;
      }
      best.points_m = std::move(lanes_m);
    }
  }
  if (rows != values.end() && !is_ns && direction != "east-west" && direction != "ew") {
    best.assumed = "rows is neither north-south nor east-west, and so east-west";
  }
  return best;
}

/// Begins at the knot that is farther from startx, starty.
Result<BhvPoints> MakeBowtie(std::string_view text, const Values& values) {
  const auto number = [&](std::string_view key) { return NumberOf(values, key, std::nan("")); };
  const Eigen::Vector2d center_m(number("x"), number("y"));
  const double half_m = number("height") / 2;
  const double wid1_m = number("wid1");
  const double wid2_m = number("wid2");
  const double wid3_m = number("wid3");
  const Eigen::Vector2d start_m(NumberOf(values, "startx", center_m.x() + 1),
                                NumberOf(values, "starty", center_m.y() + 1));
  if (!center_m.allFinite() || !start_m.allFinite() || !IsWithin(half_m, 0, 1e6) ||
      !IsWithin(wid1_m, -1e6, 1e6) || !IsWithin(wid2_m, -1e6, 1e6) ||
      !IsWithin(wid3_m, -1e6, 1e6)) {
    return Wrong(text, "x, y, height, wid1, wid2 and wid3 must be numbers");
  }
  const Eigen::Vector2d away_m = start_m - center_m;
  const bool is_east = away_m.x() > 0 || (away_m.x() == 0 && away_m.y() >= 0);
  const bool is_north = is_east ? away_m.y() > 0 : away_m.y() >= 0;
  const double side = is_east ? -1 : 1;
  const double end = is_north ? -half_m : half_m;
  BhvPoints tie;
  for (const double at : {side, -side}) {
    for (const Eigen::Vector2d& corner_m :
         {Eigen::Vector2d(wid1_m, end), Eigen::Vector2d(wid2_m, end), Eigen::Vector2d(wid3_m, 0),
          Eigen::Vector2d(wid2_m, -end), Eigen::Vector2d(wid1_m, -end)}) {
      tie.points_m.push_back(
          Snapped(center_m + Eigen::Vector2d(at * corner_m.x(), corner_m.y()), 0));
    }
  }
  return tie;
}

/// "startx,starty,angle,length,period,amplitude[,snap]".
Result<BhvPoints> MakeZigzag(std::string_view whole, std::string_view text) {
  const auto numbers = NumbersOf(text, ',');
  if (!numbers || numbers->size() < 6 || numbers->size() > 7) {
    return Wrong(whole, "not six or seven numbers");
  }
  const Eigen::Vector2d start_m((*numbers)[0], (*numbers)[1]);
  const double angle_deg = (*numbers)[2];
  const double length_m = (*numbers)[3];
  const double period_m = (*numbers)[4];
  const double amplitude_m = (*numbers)[5];
  const double snap_m = numbers->size() == 7 ? (*numbers)[6] : 0;
  if (!start_m.allFinite() || !IsWithin(angle_deg, -1e6, 1e6) || !IsWithin(length_m, 1e-3, 1e6) ||
      !IsWithin(period_m, 1e-3, 1e6) || !IsWithin(amplitude_m, 1e-3, 1e6) ||
      !IsWithin(snap_m, 0, 1e6) || length_m / period_m > kMaxPoints / 2.0 - 2) {
    return Wrong(whole, "length, period and amplitude must be above 0 m, snap at least 0");
  }
  BhvPoints zigzag{.points_m = {Snapped(start_m, snap_m)}, .assumed = ""};
  double side = -1;
  double at_m = period_m / 4;
  while (at_m < length_m) {
    const Eigen::Vector2d vector_m = Turned(Eigen::Vector2d(side * amplitude_m, at_m), angle_deg);
    zigzag.points_m.push_back(Snapped(start_m + vector_m, snap_m));
    side = -side;
    at_m += period_m / 2;
  }
  return zigzag;
}

using Maker = Result<BhvPoints> (*)(std::string_view text, const Values& values);

/// A form of points: format=NAME, or "NAME:" before its fields.
struct Form {
  std::string_view name;
  Maker make;
  bool is_polygon;
  bool may_lead;  ///< "NAME:" is known too.
};

constexpr Form kForms[] = {
    {"radial", MakeRadial, true, true},        {"ellipse", MakeEllipse, true, true},
    {"wedge", MakeWedge, true, true},          {"piewedge", MakeWedge, true, true},
    {"pylon", MakePylon, true, true},          {"oval", MakeOval, true, true},
    {"lawnmower", MakeLawnmower, false, true}, {"bowtie", MakeBowtie, false, false},
};

/// "x,y,radius,pts,snap,label", as older files have a circle.
Result<BhvPoints> ParseOldRadial(std::string_view whole, std::string_view text) {
  Values values;
  const std::vector<std::string_view> parts = TrimmedParts(text, ',');
  constexpr std::string_view kKeys[] = {"x", "y", "radius", "pts", "snap", "label"};
  if (parts.size() < 4 || parts.size() > std::size(kKeys)) {
    return Wrong(whole, "not x, y, radius, pts, snap, label");
  }
  for (size_t i = 0; i < parts.size(); ++i) values[std::string(kKeys[i])] = parts[i];
  return MakeRadial(whole, values);
}

/// Reads a form of the kind; nothing where the text names none.
std::optional<Result<BhvPoints>> ParseForm(std::string_view whole, bool is_polygon) {
  for (const Form& form : kForms) {
    if (form.is_polygon != is_polygon) continue;
    std::string_view text = whole;
    const bool leads = form.may_lead && LowerCase(text.substr(0, form.name.size())) == form.name &&
                       Trimmed(text.substr(form.name.size())).starts_with(':');
    if (leads) {
      text = Trimmed(text.substr(form.name.size()));
      while (text.starts_with(':')) text.remove_prefix(1);
      const bool is_old = form.name == "radial" && text.find('=') == text.npos;
      if (is_old) return ParseOldRadial(whole, text);
    } else if (text.find("format") == text.npos) {
      continue;
    }
    const auto fields = ParseFields(text);
    if (!fields.ok())
      return leads ? std::optional(Result<BhvPoints>(Wrong(whole, fields.error()))) : std::nullopt;
    Values values;
    for (const MoosField& field : *fields) values[LowerCase(field.key)] = field.value;
    const auto format = values.find("format");
    if (!leads && (format == values.end() || LowerCase(format->second) != form.name)) continue;
    return form.make(whole, values);
  }
  return std::nullopt;
}

std::string_view WithoutQuotesOf(std::string_view text) {
  text = Trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = Trimmed(text.substr(1, text.size() - 2));
  }
  return text;
}

}  // namespace

Result<BhvPoints> ParseBhvSeglist(std::string_view text) {
  text = Trimmed(text);
  if (auto points = ParsePts(text, true)) return *points;
  if (auto form = ParseForm(text, false)) return *form;
  constexpr std::string_view kZigzag = "zigzag:";
  if (text.starts_with(kZigzag)) return MakeZigzag(text, text.substr(kZigzag.size()));
  if (text.find("format") != text.npos) return Wrong(text, "a form without counterpart");
  return ParseList(text, text, false);
}

Result<BhvPoints> ParseBhvPolygon(std::string_view text) {
  text = Trimmed(text);
  if (auto points = ParsePts(text, false)) return *points;
  if (auto form = ParseForm(text, true)) return *form;
  if (text.find("format") != text.npos) return Wrong(text, "a form without counterpart");
  return ParseList(text, text, false);
}

Result<BhvPoints> ParseBhvPoints(std::string_view text) {
  text = WithoutQuotesOf(text);
  if (LowerCase(text.substr(0, 8)) == "empty") return BhvPoints{};
  Result<BhvPoints> seglist = ParseBhvSeglist(text);
  if (seglist.ok()) return seglist;
  Result<BhvPoints> polygon = ParseBhvPolygon(text);
  if (!polygon.ok()) return ParseForm(text, true) ? polygon : seglist;
  // The vertex nearest to the origin, where MOOS-IvP has the vehicle when it reads the file.
  std::vector<Eigen::Vector2d>& points_m = polygon->points_m;
  size_t nearest = 0;
  for (size_t i = 1; i < points_m.size(); ++i) {
    if (points_m[i].norm() < points_m[nearest].norm() - 1e-6) nearest = i;
  }
  std::rotate(points_m.begin(), points_m.begin() + static_cast<std::ptrdiff_t>(nearest),
              points_m.end());
  return polygon;
}

Result<BhvPoints> ParseBhvPoint(std::string_view whole) {
  const std::string_view text = WithoutQuotesOf(whole);
  const auto wrong = [&](std::string_view problem) {
    return Error{fmt::format("{}: {}; write x,y or x=1,y=2 or x:y", Quoted(text), problem)};
  };
  BhvPoints point;
  if (text.find('=') != text.npos) {
    const auto fields = ParseFields(text);
    if (!fields.ok() || text.find('{') != text.npos) return wrong("not a point");
    Values values;
    for (const MoosField& field : *fields) values[LowerCase(field.key)] = field.value;
    const Eigen::Vector2d at_m(NumberOf(values, "x", std::nan("")),
                               NumberOf(values, "y", std::nan("")));
    if (!at_m.allFinite()) return wrong("x and y must be numbers");
    point.points_m = {at_m};
    return point;
  }
  const auto numbers = NumbersOf(text, ':');
  if (numbers && numbers->size() == 2) {
    point.points_m = {Eigen::Vector2d((*numbers)[0], (*numbers)[1])};
    return point;
  }
  Result<BhvPoints> list = ParseList(text, text, false);
  if (!list.ok()) return wrong("not a point");
  if (list->points_m.size() > 1) point.assumed = "the last of several points counts";
  point.points_m = {list->points_m.back()};
  return point;
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
