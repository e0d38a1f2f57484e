#include "lib/tools/plot/plot_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/mission/model/vehicle_colors.h"
#include "lib/tools/plot/plot_tracks.h"

namespace shoal {

namespace {

constexpr std::string_view kSolid = "lw 1.4";
constexpr std::string_view kDashed = "dt (6,5) lw 1.2";
constexpr std::string_view kDotted = "dt (2,4) lw 1.2";
constexpr size_t kMaxDistances = 12;

using CurveOf = std::function<const ThinnedCurve&(const VehicleCurves&)>;

/// Cuts the lines where a bearing goes through North.
std::vector<Stroke> CutAtNorth(const std::vector<Stroke>& strokes) {
  std::vector<Stroke> cut;
  for (const Stroke& stroke : strokes) {
    for (size_t i = 0; i < stroke.size(); ++i) {
      if (i == 0 || std::abs(stroke[i].y - stroke[i - 1].y) > 180) cut.emplace_back();
      cut.back().push_back(stroke[i]);
    }
  }
  return cut;
}

/// The plots over time of one figure, one above the other.
class StackedFigure {
 public:
  StackedFigure(std::string name, const PlotData& data, const std::vector<std::string>& colors)
      : name_(std::move(name)), data_(data), colors_(colors) {}

  void BeginPanel(const std::string& y_label, std::vector<std::string> settings = {}) {
    panels_.push_back({.y_label = y_label, .items = {}, .settings = std::move(settings)});
  }

  /// Draws a curve of every vehicle that has it. Returns whether any has.
  bool AddCurves(const CurveOf& curve, const std::string& what, std::string_view style,
                 bool is_bearing = false) {
    bool any = false;
    for (size_t i = 0; i < data_.vehicles.size(); ++i) {
      const VehicleCurves& vehicle = data_.vehicles[i];
      if (curve(vehicle).empty()) continue;
      any = true;
      const std::vector<Stroke> strokes = curve(vehicle).Strokes();
      Item(blocks_.Add(vehicle.name + ", " + what, is_bearing ? CutAtNorth(strokes) : strokes),
           fmt::format("lines lc rgb '{}' {}", colors_[i], style));
    }
    return any;
  }

  void AddLevel(double level, const std::string& style) {
    Item(blocks_.Add("level", {{{data_.first_s, level}, {data_.last_s, level}}}), style);
  }

  void Explain(const std::string& title, const std::string& style) {
    notes_.push_back({title, style});
  }

  Figure Finish(const std::string& what, const PlotSetting& setting, bool png,
                const std::string& why_left_out) {
    std::erase_if(panels_, [](const Panel& panel) { return panel.items.empty(); });
    if (panels_.empty()) return {.name = name_, .why_left_out = why_left_out};
    std::vector<LegendEntry> legend = VehicleLegend(data_, colors_);
    legend.insert(legend.end(), notes_.begin(), notes_.end());
    return {.name = name_,
            .data = blocks_.text(),
            .script = StackedScript(name_, TitleOf(what, setting), TimeLabel(), data_.first_s,
                                    data_.last_s, panels_, legend, png)};
  }

 private:
  void Item(int block, const std::string& style) {
    panels_.back().items.push_back(
        fmt::format("'{}.dat' index {} with {} notitle", name_, block, style));
  }

  std::string TimeLabel() const {
    if (!data_.zero_is_first) return "time [s]";
    return fmt::format("time since {:.6f} s [s]", Seconds(data_.zero_utime));
  }

  std::string name_;
  const PlotData& data_;
  const std::vector<std::string>& colors_;
  PlotBlocks blocks_;
  std::vector<Panel> panels_;
  std::vector<LegendEntry> notes_;
};

bool AnyHas(const PlotData& data, bool VehicleCurves::*what) {
  return std::any_of(data.vehicles.begin(), data.vehicles.end(),
                     [&](const VehicleCurves& vehicle) { return vehicle.*what; });
}

const std::string kGreySolid = "lines lc rgb '#707070' lw 1.4";
const std::string kGreyDashed = "lines lc rgb '#707070' dt (6,5) lw 1.2";
const std::string kGreyDotted = "lines lc rgb '#707070' dt (2,4) lw 1.2";

Figure DrawDepth(StackedFigure figure, const PlotData& data, const PlotSetting& setting, bool png) {
  figure.BeginPanel("depth [m]", {"set yrange [*:*] reverse"});
  const bool has_floor =
      std::any_of(data.vehicles.begin(), data.vehicles.end(),
                  [](const VehicleCurves& vehicle) { return !vehicle.floor_m.empty(); });
  if (has_floor || AnyHas(data, &VehicleCurves::dives)) {
    figure.AddCurves(&VehicleCurves::depth_m, "depth", kSolid);
    if (figure.AddCurves(&VehicleCurves::floor_m, "sea floor", kDashed)) {
      figure.Explain("sea floor below", kGreyDashed);
    }
    const bool has_depth =
        figure.AddCurves(&VehicleCurves::desired_depth_m, "desired depth", kDotted);
    if (has_depth) figure.Explain("desired", kGreyDotted);
    figure.BeginPanel("pitch, bow up + [°]",
                      {"set yrange [*:*] noreverse", "set xzeroaxis lc rgb '#909090' lt 1"});
    if (figure.AddCurves(&VehicleCurves::desired_pitch_deg, "desired pitch", kDotted)) {
      figure.AddCurves(&VehicleCurves::pitch_deg, "pitch", kSolid);
    }
  }
  return figure.Finish("Depth", setting, png, "all vehicles stay at the surface");
}

Figure DrawTrackError(StackedFigure figure, const PlotSetting& setting, bool png) {
  const std::string zero = "set xzeroaxis lc rgb '#909090' lt 1";
  figure.BeginPanel("cross-track error [m]", {zero});
  figure.AddCurves(&VehicleCurves::cross_track_m, "cross-track error", kSolid);
  figure.BeginPanel("crab angle [°]", {zero});
  figure.AddCurves(&VehicleCurves::crab_deg, "crab angle", kSolid);
  if (figure.AddCurves(&VehicleCurves::expected_crab_deg, "crab angle by ALOS", kDashed)) {
    figure.Explain("is", kGreySolid);
    figure.Explain("by ALOS", kGreyDashed);
  }
  return figure.Finish("Cross-track error and crab angle", setting, png,
                       "no vehicle followed a leg, and none moved");
}

Figure DrawDistances(StackedFigure figure, const PlotSetting& setting, bool png) {
  figure.BeginPanel("distance [m]", {"set yrange [0:*]"});
  bool has_curves = figure.AddCurves(&VehicleCurves::nearest_m, "distance to the nearest", kSolid);
  if (figure.AddCurves(&VehicleCurves::target_m, "distance to its target", kDashed)) {
    has_curves = true;
    figure.Explain("to the nearest", kGreySolid);
    figure.Explain("to its target", kGreyDashed);
  }
  const size_t num_marks = std::min(setting.distances.size(), kMaxDistances);
  for (size_t i = 0; has_curves && i < num_marks; ++i) {
    const DistanceMark& mark = setting.distances[i];
    const std::string style = fmt::format("lines lc rgb '#000000' dt {} lw 0.8", 3 + i % 3);
    figure.AddLevel(mark.distance_m, style);
    figure.Explain(fmt::format("{} = {:g} m", mark.name, mark.distance_m), style);
  }
  return figure.Finish("Distance to the nearest vehicle", setting, png,
                       "there is one vehicle alone");
}

Figure DrawActuators(StackedFigure figure, const PlotData& data, const PlotSetting& setting,
                     bool png) {
  const std::string zero = "set xzeroaxis lc rgb '#909090' lt 1";
  const bool has_rpm = AnyHas(data, &VehicleCurves::has_rpm);
  if (AnyHas(data, &VehicleCurves::has_thrust) || !has_rpm) {
    figure.BeginPanel("thrust [%]", {zero});
    figure.AddCurves(&VehicleCurves::thrust_pct, "thrust", kSolid);
  }
  if (has_rpm) {
    figure.BeginPanel("propeller [rpm]", {zero});
    figure.AddCurves(&VehicleCurves::propeller_rpm, "propeller", kSolid);
  }
  figure.BeginPanel("rudder, starboard + [°]", {zero});
  figure.AddCurves(&VehicleCurves::rudder_deg, "rudder", kSolid);
  if (AnyHas(data, &VehicleCurves::has_stern)) {
    figure.BeginPanel("stern plane, bow up + [°]", {zero});
    figure.AddCurves(&VehicleCurves::stern_plane_deg, "stern plane", kSolid);
  }
  return figure.Finish("Actuators", setting, png, "no ACTUATORS of these vehicles in the log");
}

Figure DrawSpeed(StackedFigure figure, const PlotSetting& setting, bool png) {
  figure.BeginPanel("speed through water [m/s]");
  bool has_desired = figure.AddCurves(&VehicleCurves::desired_speed_mps, "desired speed", kDashed);
  figure.AddCurves(&VehicleCurves::speed_mps, "speed", kSolid);
  figure.BeginPanel("heading [°]", {"set yrange [0:360]", "set ytics 90"});
  has_desired |=
      figure.AddCurves(&VehicleCurves::desired_heading_deg, "desired heading", kDashed, true);
  figure.AddCurves(&VehicleCurves::heading_deg, "heading", kSolid, true);
  if (has_desired) {
    figure.Explain("actual", kGreySolid);
    figure.Explain("desired", kGreyDashed);
  }
  return figure.Finish("Speed and heading", setting, png, "no NAV of these vehicles in the log");
}

Figure DrawAge(StackedFigure figure, const PlotSetting& setting, bool png) {
  figure.BeginPanel("age of target information [s]", {"set yrange [0:*]"});
  figure.AddCurves(&VehicleCurves::target_age_s, "age of target information", kSolid);
  figure.BeginPanel("age of oldest information [s]", {"set yrange [0:*]"});
  figure.AddCurves(&VehicleCurves::other_age_s, "age of oldest information", kSolid);
  return figure.Finish("Age of information", setting, png, "no SWARM of these vehicles in the log");
}

Figure DrawNavigation(StackedFigure figure, const PlotSetting& setting, bool png) {
  figure.BeginPanel("error of its position [m]", {"set yrange [0:*]"});
  if (figure.AddCurves(&VehicleCurves::navigation_bound_m, "95 % bound", kDashed)) {
    figure.Explain("error", kGreySolid);
    figure.Explain("95 % bound", kGreyDashed);
  }
  figure.AddCurves(&VehicleCurves::navigation_error_m, "error", kSolid);
  return figure.Finish("Navigation error", setting, png,
                       "no NAVIGATION of these vehicles in the log");
}

Figure DrawLayers(StackedFigure figure, const PlotSetting& setting, bool png) {
  bool any = false;
  for (size_t i = 0; i < kPlottedLayers.size(); ++i) {
    const std::string name(kPlottedLayers.at(i));
    figure.BeginPanel(name, {"set yrange [-0.05:1.05]", "set ytics 0.5"});
    const auto of = [i](const VehicleCurves& vehicle) -> const LayerCurves& {
      return vehicle.layers.at(i);
    };
    any |= figure.AddCurves(
        [&](const VehicleCurves& vehicle) -> const ThinnedCurve& { return of(vehicle).weight; },
        name + ", weight", kSolid);
    figure.AddCurves(
        [&](const VehicleCurves& vehicle) -> const ThinnedCurve& { return of(vehicle).asks; },
        name + ", asks for", kDashed);
  }
  if (any) {
    figure.Explain("weight", kGreySolid);
    figure.Explain("asks for, of u_max", kGreyDashed);
  }
  return figure.Finish("Layers of guidance", setting, png, "no GUIDANCE with layers in the log");
}

/// The mission's colours, else those of the vehicles' reports.
std::vector<std::string> ColorsOf(const PlotData& data, const PlotSetting& setting) {
  std::vector<std::string> requested;
  for (const VehicleCurves& vehicle : data.vehicles) {
    requested.push_back(vehicle.color);
    for (const PlannedVehicle& planned : setting.vehicles) {
      if (UpperCase(planned.name) == UpperCase(vehicle.name)) requested.back() = planned.color;
    }
  }
  return AssignColors(requested);
}

}  // namespace

std::vector<Figure> DrawFigures(const PlotData& data, const PlotSetting& setting, bool png) {
  const std::vector<std::string> colors = ColorsOf(data, setting);
  const auto stacked = [&](const char* name) { return StackedFigure(name, data, colors); };
  return {DrawTracks(data, setting, colors, png),
          DrawDepth(stacked("depth"), data, setting, png),
          DrawTrackError(stacked("track_error"), setting, png),
          DrawDistances(stacked("distances"), setting, png),
          DrawActuators(stacked("actuators"), data, setting, png),
          DrawSpeed(stacked("speed"), setting, png),
          DrawAge(stacked("age"), setting, png),
          DrawLayers(stacked("layers"), setting, png),
          DrawNavigation(stacked("navigation"), setting, png)};
}

}  // namespace shoal
