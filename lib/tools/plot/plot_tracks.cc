#include "lib/tools/plot/plot_tracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/text/letters.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/vehicle_colors.h"

namespace shoal {

namespace {

/// The part of the world that a figure shows.
struct Bounds {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300;

  void Include(const Stroke& stroke) {
    for (const CurvePoint& point : stroke) {
      left = std::min(left, point.x);
      right = std::max(right, point.x);
      low = std::min(low, point.y);
      high = std::max(high, point.y);
    }
  }
  /// Adds a margin, and makes a strip wide enough to be looked at.
  void Widen() {
    const double margin = std::max({0.05 * (right - left), 0.05 * (high - low), 1.0});
    const double fewest = 0.32 * (std::max(right - left, high - low) + 2 * margin);
    const double margin_x = std::max(margin, 0.5 * (fewest - (right - left)));
    const double margin_y = std::max(margin, 0.5 * (fewest - (high - low)));
    left -= margin_x;
    right += margin_x;
    low -= margin_y;
    high += margin_y;
  }
  double width() const { return right - left; }
  double height() const { return high - low; }
};

/// Returns 1, 2 or 5 times a power of ten, at least `least`: a step between marks of an axis.
/// @pre least > 0
double RoundStep(double least) {
  const double power = Pow(10.0, std::floor(Log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

/// Returns the step between the marks of a horizontal axis of that many pixels, so that their
/// numbers do not touch.
double TickStep(const Bounds& bounds, int width_px) {
  constexpr int kDigit_px = 9;
  constexpr int kGap_px = 14;
  const size_t num_digits = std::max(fmt::format("{:.0f}", bounds.left).size(),
                                     fmt::format("{:.0f}", bounds.right).size());
  const double label_px = static_cast<double>(num_digits) * kDigit_px + kGap_px;
  return RoundStep(std::max(bounds.width() * label_px / width_px, bounds.width() / 8));
}

constexpr int kMaxWithTimes = 4;  // With more vehicles, times would hide the tracks.
constexpr const char* kGrey = "#707070";
constexpr const char* kCollisionStyle = "points lc rgb '#d00000' pt 2 ps 1.8 lw 2.5";
constexpr const char* kAgroundStyle = "points lc rgb '#d00000' pt 8 ps 1.8 lw 2.5";

std::string PlanColor(const std::string& color) { return "#70" + color.substr(1); }

/// Of drawings whose colour is not known.
constexpr const char* kDrawingColor = "#b09000";

/// Returns a text that can be in quotes in a block of data.
std::string TextInBlock(std::string_view text) {
  constexpr size_t kLongest = 40;
  std::string plain;
  for (const char letter : text.substr(0, kLongest)) {
    const bool is_plain = letter >= ' ' && letter <= '~' && letter != '"' && letter != '\\';
    plain += is_plain ? letter : '?';
  }
  return plain;
}

Stroke CircleAround(CurvePoint middle, double radius_m) {
  constexpr int kCorners = 48;
  Stroke circle;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * kPi * i / kCorners;
    circle.push_back({middle.x + radius_m * Sin(angle), middle.y + radius_m * Cos(angle)});
  }
  return circle;
}

/// Returns the colour mixed with three parts of white.
std::string PaleColor(const std::string& color) {
  const auto pale = [&](size_t at) {
    return 191 + std::stoi(color.substr(at, 2), nullptr, 16) / 4;
  };
  return fmt::format("#{:02x}{:02x}{:02x}", pale(1), pale(3), pale(5));
}

/// More would not be seen.
constexpr size_t kMaxDiscs = 20'000;
constexpr double kDiscsPerReach = 4;

/// Returns points of a line about `step_m` apart, fewer where there would be too many.
Stroke DenseAlong(const Stroke& stroke, double step_m) {
  double length_m = 0;
  for (size_t i = 1; i < stroke.size(); ++i) {
    length_m += Hypot(stroke[i].x - stroke[i - 1].x, stroke[i].y - stroke[i - 1].y);
  }
  step_m = std::max(step_m, length_m / static_cast<double>(kMaxDiscs));
  Stroke dense;
  if (!stroke.empty()) dense.push_back(stroke.front());
  for (size_t i = 1; i < stroke.size(); ++i) {
    const CurvePoint from = dense.back();
    const CurvePoint to = stroke[i];
    const double distance_m = Hypot(to.x - from.x, to.y - from.y);
    const double steps = step_m > 0 ? distance_m / step_m : 0;  // At most one more than kMaxDiscs.
    const int num_steps = steps >= 1 ? static_cast<int>(steps) : 0;
    for (int k = 1; k <= num_steps; ++k) {
      const double share = k * step_m / distance_m;
      dense.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
    }
  }
  return dense;
}

class TracksFigure {
 public:
  TracksFigure(const PlotData& data, const PlotSetting& setting,
               const std::vector<std::string>& colors)
      : data_(data), setting_(setting), colors_(colors) {}

  Figure Draw(bool png) {
    for (const VehicleCurves& vehicle : data_.vehicles) {
      for (const Stroke& stroke : vehicle.track.Strokes()) bounds_.Include(stroke);
    }
    if (bounds_.left > bounds_.right) {
      return {.name = "tracks", .why_left_out = "no NAV of these vehicles in the log"};
    }
    legend_ = VehicleLegend(data_, colors_);
    for (size_t i = 0; i < data_.vehicles.size(); ++i) AddSwaths(i);
    AddAreas();
    AddObstacles();
    for (size_t i = 0; i < data_.vehicles.size(); ++i) AddPlan(i);
    for (const MapDrawing& drawing : data_.drawings) AddDrawing(drawing);
    AddDrawingLabels();
    for (size_t i = 0; i < data_.vehicles.size(); ++i) AddTrack(i);
    for (size_t i = 0; i < data_.vehicles.size(); ++i) AddBelieved(i);
    for (size_t i = 0; i < data_.vehicles.size(); ++i) AddMarks(i);
    AddContacts("aground", data_.groundings, kAgroundStyle);
    AddContacts("collision", data_.collisions, kCollisionStyle);
    AddLegend();
    bounds_.Widen();
    const std::string floor = AddFloor();
    return {.name = "tracks", .data = blocks_.text(), .script = Script(floor, png)};
  }

 private:
  /// Appends a plot of a block, drawn `with` a style.
  void Plot(const std::string& comment, const std::vector<Stroke>& strokes,
            const std::string& with) {
    items_.push_back(
        fmt::format("'tracks.dat' index {} with {} notitle", blocks_.Add(comment, strokes), with));
  }

  /// What its sensor covered, as discs so near to one another that they make a band.
  void AddSwaths(size_t index) {
    const VehicleCurves& vehicle = data_.vehicles[index];
    for (const PlannedCoverage& coverage : setting_.coverage) {
      if (UpperCase(coverage.vehicle) != UpperCase(vehicle.name) || vehicle.track.empty()) continue;
      const double reach_m = coverage.width_m / 2;
      std::string lines;
      for (const Stroke& stroke : vehicle.track.Strokes()) {
        for (const CurvePoint& point : DenseAlong(stroke, reach_m / kDiscsPerReach)) {
          lines += fmt::format("{:.7g} {:.7g} {:.7g}\n", point.x, point.y, reach_m);
        }
      }
      const int block = blocks_.AddLines(vehicle.name + ", covered", lines);
      items_.push_back(fmt::format(
          "'tracks.dat' index {} using 1:2:3 with circles lc rgb '{}' fs solid noborder "
          "notitle",
          block, PaleColor(colors_[index])));
      has_swaths_ = true;
    }
  }

  void AddAreas() {
    if (setting_.areas.empty()) return;
    for (const Stroke& area : setting_.areas) bounds_.Include(area);
    Plot("areas", setting_.areas, fmt::format("lines lc rgb '{}' dt 3 lw 1.4", kGrey));
  }

  void AddObstacles() {
    if (setting_.obstacles.empty()) return;
    for (const Stroke& obstacle : setting_.obstacles) bounds_.Include(obstacle);
    Plot("obstacles", setting_.obstacles, fmt::format("lines lc rgb '{}' lw 2.2", kGrey));
  }

  /// What a program drew.
  void AddDrawing(const MapDrawing& drawing) {
    const std::optional<uint32_t> known = ColorOf(drawing.color);
    const std::string color = known ? fmt::format("#{:06x}", *known) : kDrawingColor;
    Stroke stroke;
    for (const auto& [x_m, y_m] : drawing.points_m) stroke.push_back({x_m, y_m});
    CurvePoint place = stroke.front();
    std::string style = fmt::format("lines lc rgb '{}' lw 1.4", color);
    switch (drawing.kind) {
      case DrawingKind::kPoint:
        style = fmt::format("points lc rgb '{}' pt 7 ps 0.9", color);
        break;
      case DrawingKind::kPolygon:
        stroke.push_back(stroke.front());
        break;
      case DrawingKind::kCircle:
        stroke = CircleAround(place, drawing.radius_m);
        place.y += drawing.radius_m;
        break;
      case DrawingKind::kSeglist:
        break;
      case DrawingKind::kText:
        style.clear();
        break;
    }
    bounds_.Include(stroke);
    if (!style.empty()) Plot("drawn: " + drawing.label, {stroke}, style);
    const std::string& label = drawing.kind == DrawingKind::kText ? drawing.text : drawing.label;
    const std::string text = TextInBlock(label);
    if (!text.empty())
      drawn_labels_ += fmt::format("{:.9g} {:.9g} \"{}\"\n", place.x, place.y, text);
  }

  void AddDrawingLabels() {
    if (drawn_labels_.empty()) return;
    items_.push_back(
        fmt::format("'tracks.dat' index {} using 1:2:3 with labels noenhanced font ',10' left "
                    "offset 0.6,0.6 notitle",
                    blocks_.AddLines("drawn, labels", drawn_labels_)));
  }

  /// Where it was sent: by the mission, else by what its helm published.
  void AddPlan(size_t index) {
    const VehicleCurves& vehicle = data_.vehicles[index];
    const std::string color = PlanColor(colors_[index]);
    const auto planned = std::find_if(setting_.vehicles.begin(), setting_.vehicles.end(),
                                      [&](const PlannedVehicle& each) {
                                        return UpperCase(each.name) == UpperCase(vehicle.name);
                                      });
    std::vector<Stroke> legs;
    std::vector<Stroke> points;
    if (planned != setting_.vehicles.end()) {
      for (const PlannedPath& path : planned->paths) {
        bounds_.Include(path.legs);
        if (path.legs.size() > 1) legs.push_back(path.legs);
        if (path.has_points) points.push_back(path.legs);
      }
    } else if (!vehicle.steered_for.empty()) {
      bounds_.Include(vehicle.steered_for);
      points.push_back(vehicle.steered_for);
    }
    if (!legs.empty()) {
      Plot(vehicle.name + ", plan", legs, fmt::format("lines lc rgb '{}' dt 2 lw 1", color));
    }
    if (points.empty()) return;
    has_waypoints_ = true;
    Plot(vehicle.name + ", waypoints", points,
         fmt::format("points lc rgb '{}' pt 7 ps 0.6", color));
  }

  /// Where it believed to be.
  void AddBelieved(size_t index) {
    const VehicleCurves& vehicle = data_.vehicles[index];
    if (vehicle.believed_track.empty()) return;
    for (const Stroke& stroke : vehicle.believed_track.Strokes()) bounds_.Include(stroke);
    Plot(vehicle.name + ", where it believed to be", vehicle.believed_track.Strokes(),
         fmt::format("lines lc rgb '{}' dt (2,3) lw 1.2", colors_[index]));
    has_believed_ = true;
  }

  void AddTrack(size_t index) {
    const VehicleCurves& vehicle = data_.vehicles[index];
    if (vehicle.track.empty()) return;
    Plot(vehicle.name + ", track", vehicle.track.Strokes(),
         fmt::format("lines lc rgb '{}' lw 1.6", colors_[index]));
  }

  void AddMarks(size_t index) {
    const VehicleCurves& vehicle = data_.vehicles[index];
    const std::string color = colors_[index];
    if (vehicle.start) {
      Plot(vehicle.name + ", start", {{*vehicle.start}},
           fmt::format("points lc rgb '{}' pt 6 ps 1.1 lw 1.6", color));
    }
    if (vehicle.end) {
      Plot(vehicle.name + ", end", {{*vehicle.end}},
           fmt::format("points lc rgb '{}' pt 5 ps 0.9", color));
    }
    std::string lines;
    CurvePoint last = vehicle.start.value_or(CurvePoint{});
    for (const TimeMark& mark : vehicle.marks) {
      // While it lies still, one mark is enough; at home the end has its own.
      if (IsNear(mark.at, last, 0.015) || IsNear(mark.at, *vehicle.end, 0.015)) continue;
      last = mark.at;
      const bool is_readable = std::none_of(texts_.begin(), texts_.end(), [&](CurvePoint text) {
        return IsNear(mark.at, text, 0.04);
      });
      if (is_readable) texts_.push_back(mark.at);
      lines += fmt::format("{:.9g} {:.9g} {}\n", mark.at.x, mark.at.y,
                           is_readable ? std::to_string(mark.time_s) : "\"\"");
    }
    if (lines.empty()) return;
    has_marks_ = true;
    const int block = blocks_.AddLines(vehicle.name + ", times", lines);
    items_.push_back(fmt::format(
        "'tracks.dat' index {} with points lc rgb '{}' pt 9 ps 0.9 notitle", block, color));
    if (data_.vehicles.size() > kMaxWithTimes) return;
    items_.push_back(
        fmt::format("'tracks.dat' index {} using 1:2:3 with labels font ',11' tc rgb "
                    "'{}' left offset 0.7,0.5 notitle",
                    block, color));
  }

  /// What the verdict counts as failures.
  void AddContacts(const std::string& name, const std::vector<CurvePoint>& points,
                   const std::string& style) {
    if (points.empty()) return;
    bounds_.Include(points);
    Plot(name, {points}, style);
  }

  /// True where less than this share of the figure lies between the two.
  bool IsNear(CurvePoint a, CurvePoint b, double share) const {
    return Hypot(a.x - b.x, a.y - b.y) < share * std::max(bounds_.width(), bounds_.height());
  }

  void AddLegend() {
    legend_.push_back({"start", fmt::format("points lc rgb '{}' pt 6 ps 1.1 lw 1.6", kGrey)});
    legend_.push_back({"end", fmt::format("points lc rgb '{}' pt 5 ps 0.9", kGrey)});
    if (has_marks_) {
      legend_.push_back({fmt::format("every {} s", data_.mark_interval_s),
                         fmt::format("points lc rgb '{}' pt 9 ps 0.9", kGrey)});
    }
    if (!data_.groundings.empty()) legend_.push_back({"aground", kAgroundStyle});
    if (!data_.collisions.empty()) legend_.push_back({"collision", kCollisionStyle});
    if (!setting_.obstacles.empty()) {
      legend_.push_back({"obstacle", fmt::format("lines lc rgb '{}' lw 2.2", kGrey)});
    }
    if (!setting_.areas.empty()) {
      legend_.push_back({"area", fmt::format("lines lc rgb '{}' dt 3 lw 1.4", kGrey)});
    }
    if (has_swaths_) legend_.push_back({"covered", "lines lc rgb '#d0d0d0' lw 8"});
    if (has_believed_) {
      legend_.push_back({"believed", fmt::format("lines lc rgb '{}' dt (2,3) lw 1.2", kGrey)});
    }
    if (has_waypoints_) {
      legend_.push_back({"waypoint", fmt::format("points lc rgb '{}' pt 7 ps 0.6", kGrey)});
    }
  }

  /// Appends the depths of the sea floor; returns the lines that draw its contour, if it has one.
  std::string AddFloor() {
    if (!setting_.floor_depth_m) return {};
    constexpr int kSteps = 80;
    std::string lines;
    double low = 1e300;
    double high = -1e300;
    for (int row = 0; row <= kSteps; ++row) {
      for (int column = 0; column <= kSteps; ++column) {
        const double x = bounds_.left + bounds_.width() * column / kSteps;
        const double y = bounds_.low + bounds_.height() * row / kSteps;
        const double depth_m = setting_.floor_depth_m(x, y);
        if (!std::isfinite(depth_m)) {
          lines += fmt::format("{:.9g} {:.9g} ?\n", x, y);
          continue;
        }
        low = std::min(low, depth_m);
        high = std::max(high, depth_m);
        lines += fmt::format("{:.9g} {:.9g} {:.6g}\n", x, y, depth_m);
      }
      lines += '\n';
    }
    constexpr double kFlat_m = 0.01;
    if (!(high - low > kFlat_m)) return {};
    // Two blank lines end a block: the last row's own is one too many.
    lines.pop_back();
    const int block = blocks_.AddLines("depth of the sea floor", lines);
    items_.insert(items_.begin(),
                  {"$floor using 1:2 with lines lc rgb '#c8b89a' lw 0.8 notitle",
                   "$floor using 1:2:3 every 60::30 with labels font ',10' tc rgb '#a08860' "
                   "notitle"});
    legend_.push_back({"sea floor, depth [m]", "lines lc rgb '#c8b89a' lw 0.8"});
    return fmt::format(
        "set datafile missing '?'\nset contour base\nunset surface\nset cntrparam levels auto 8\n"
        "set table $floor\nsplot 'tracks.dat' index {} using 1:2:3\nunset table\nunset contour\n"
        "set surface\n",
        block);
  }

  std::string Script(const std::string& floor, bool png) const {
    constexpr int kPlot_px = 760;
    constexpr int kMapLeft_px = 100;
    const double aspect = bounds_.height() / bounds_.width();
    const int height_px = static_cast<int>(std::clamp(aspect * kPlot_px, 240.0, 760.0));
    const int width_px = static_cast<int>(std::clamp(height_px / aspect, 240.0, 1.0 * kPlot_px));
    Canvas canvas{.png = png, .height_px = height_px + kTop_px + kBottom_px};
    const int legend_px = LegendWidth_px(legend_, height_px);
    canvas.width_px = kMapLeft_px + width_px + legend_px;
    const auto share = [](int part, int whole) { return static_cast<double>(part) / whole; };
    std::string script = ScriptHead("tracks", canvas);
    script += floor;
    script += fmt::format(
        "set title {}\nset xlabel 'x, East [m]'\nset ylabel 'y, North [m]' offset 1,0\n"
        "set size ratio -1\n"
        "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
        "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
        "set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\nset xtics {:.9g}\n",
        GnuplotString(TitleOf("Tracks", setting_)), share(kMapLeft_px, canvas.width_px),
        share(kMapLeft_px + width_px, canvas.width_px), 1 - share(kTop_px, canvas.height_px),
        share(kBottom_px, canvas.height_px), bounds_.left, bounds_.right, bounds_.low, bounds_.high,
        TickStep(bounds_, width_px));
    script += LegendPlace(canvas, legend_px, height_px);
    return script + fmt::format("plot {}{}\n", fmt::join(items_, ", \\\n  "), LegendItems(legend_));
  }

  const PlotData& data_;
  const PlotSetting& setting_;
  const std::vector<std::string>& colors_;
  Bounds bounds_;
  PlotBlocks blocks_;
  std::vector<std::string> items_;
  std::vector<LegendEntry> legend_;
  std::string drawn_labels_;
  std::vector<CurvePoint> texts_;  ///< Where times are written.
  bool has_waypoints_ = false;
  bool has_believed_ = false;
  bool has_marks_ = false;
  bool has_swaths_ = false;
};

}  // namespace

std::string TitleOf(const std::string& what, const PlotSetting& setting) {
  if (!setting.seed) return fmt::format("{}: {}", what, setting.title);
  return fmt::format("{}: {}, seed {}", what, setting.title, *setting.seed);
}

std::vector<LegendEntry> VehicleLegend(const PlotData& data,
                                       const std::vector<std::string>& colors) {
  constexpr size_t kMax = 60;
  if (data.vehicles.size() > kMax) return {};
  std::vector<LegendEntry> legend;
  for (size_t i = 0; i < data.vehicles.size(); ++i) {
    legend.push_back({data.vehicles[i].name, fmt::format("lines lc rgb '{}' lw 1.6", colors[i])});
  }
  return legend;
}

Figure DrawTracks(const PlotData& data, const PlotSetting& setting,
                  const std::vector<std::string>& colors, bool png) {
  return TracksFigure(data, setting, colors).Draw(png);
}

}  // namespace shoal
