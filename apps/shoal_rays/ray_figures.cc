#include "apps/shoal_rays/ray_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/sea/rays/traced_ray.h"

namespace shoal {

namespace {

constexpr int kFanRays = 41;
constexpr size_t kMaxEigenrays = 8;
constexpr int kLossRanges = 240;
constexpr double kFanBeyond = 1.05;
/// Weaker arrivals are left out of the impulse response.
constexpr double kWeakest_db = 60;

double Decibels(double power) { return 10 * Log10(power); }

std::string Line(const std::string& data, int block, const std::string& style) {
  return fmt::format("'{}.dat' index {} with {} notitle", data, block, style);
}

/// A figure of one plot whose horizontal axis is not time.
Figure OnePlot(const std::string& name, const std::string& title, const std::string& x_label,
               double first, double last, Panel panel, const PlotBlocks& blocks,
               const std::vector<LegendEntry>& legend, bool png) {
  return {
      .name = name,
      .data = blocks.text(),
      .script = StackedScript(name, title, x_label, first, last, {std::move(panel)}, legend, png)};
}

Figure DrawImpulse(const RayLink& link, bool png) {
  if (link.arrivals.empty()) return {.name = "impulse", .why_left_out = "no ray arrives"};
  double strongest = 0;
  for (const RayArrival& arrival : link.arrivals) {
    strongest = std::max(strongest, PowerOf(arrival, link.absorption_dbpkm));
  }
  const double floor_db = Decibels(strongest) - kWeakest_db;
  const double first_s = link.arrivals.front().delay_s;
  PlotBlocks blocks;
  Panel panel = {.y_label = "level relative to 1 m [dB]", .items = {}, .settings = {}};
  std::vector<LegendEntry> legend;
  double last_ms = 1;
  for (const bool has_bounced : {false, true}) {
    std::vector<Stroke> strokes;
    for (const RayArrival& arrival : link.arrivals) {
      const double level_db = Decibels(PowerOf(arrival, link.absorption_dbpkm));
      if ((arrival.num_surface + arrival.num_bottom > 0) != has_bounced) continue;
      if (level_db < floor_db) continue;
      const double late_ms = (arrival.delay_s - first_s) * 1000;
      last_ms = std::max(last_ms, late_ms);
      strokes.push_back({{late_ms, floor_db}, {late_ms, level_db}});
    }
    if (strokes.empty()) continue;
    const std::string style =
        has_bounced ? "lines lc rgb '#0072b2' lw 2" : "lines lc rgb '#d55e00' lw 3";
    legend.push_back({has_bounced ? "with bounces" : "without a bounce", style});
    panel.items.push_back(
        Line("impulse", blocks.Add(has_bounced ? "bounced" : "direct", strokes), style));
  }
  return OnePlot("impulse", link.title,
                 fmt::format("time after the first arrival, {:.6f} s [ms]", first_s),
                 -0.02 * last_ms, 1.05 * last_ms, std::move(panel), blocks, legend, png);
}

Stroke PathOf(const RayTracer& tracer, const RayLink& link, double range_m, double launch_rad) {
  std::vector<Eigen::Vector2d> path;
  static_cast<void>(tracer.Trace({0, link.source_m}, range_m, launch_rad, link.limits, &path));
  Stroke stroke;
  for (const Eigen::Vector2d& at : path) stroke.push_back({at.x(), at.y()});
  return stroke;
}

Stroke ShapeOf(const std::vector<BoundaryPoint>& boundary, double range_m) {
  Stroke stroke = {{0, DepthAt(boundary, 0)}};
  for (const BoundaryPoint& point : boundary) {
    if (point.range_m > 0 && point.range_m < range_m) {
      stroke.push_back({point.range_m, point.depth_m});
    }
  }
  stroke.push_back({range_m, DepthAt(boundary, range_m)});
  return stroke;
}

Figure DrawFan(const RayLink& link, bool png) {
  const RayTracer tracer(link.scene);
  const double range_m = kFanBeyond * link.range_m;
  double widest_rad = 0.05;
  for (const RayArrival& arrival : link.arrivals) {
    widest_rad = std::max(widest_rad, std::abs(arrival.launch_rad));
  }
  widest_rad = std::min({widest_rad, 0.35, link.limits.max_launch_rad});
  PlotBlocks blocks;
  const auto depth_less = [](const BoundaryPoint& a, const BoundaryPoint& b) {
    return a.depth_m < b.depth_m;
  };
  const double top_m = std::ranges::min_element(link.scene.surface, depth_less)->depth_m;
  const double base_m = std::ranges::max_element(link.scene.bottom, depth_less)->depth_m;
  const double margin_m = 0.02 * (base_m - top_m);
  Panel panel = {
      .y_label = "depth [m]",
      .items = {},
      .settings = {fmt::format("set yrange [{:.9g}:{:.9g}]", base_m + margin_m, top_m - margin_m)}};
  std::vector<Stroke> fan;
  for (int i = 0; i < kFanRays; ++i) {
    fan.push_back(PathOf(tracer, link, range_m, widest_rad * (2.0 * i / (kFanRays - 1) - 1)));
  }
  panel.items.push_back(Line("fan", blocks.Add("fan", fan), "lines lc rgb '#b0b0b0' lw 0.8"));
  panel.items.push_back(Line("fan",
                             blocks.Add("boundaries", {ShapeOf(link.scene.surface, range_m),
                                                       ShapeOf(link.scene.bottom, range_m)}),
                             "lines lc rgb '#404040' lw 2"));
  std::vector<RayArrival> strongest = link.arrivals;
  std::ranges::sort(strongest, [](const RayArrival& a, const RayArrival& b) {
    return a.amplitude > b.amplitude;
  });
  strongest.resize(std::min(strongest.size(), kMaxEigenrays));
  if (!strongest.empty()) {
    std::vector<Stroke> eigenrays;
    for (const RayArrival& arrival : strongest) {
      eigenrays.push_back(PathOf(tracer, link, link.range_m, arrival.launch_rad));
    }
    panel.items.push_back(
        Line("fan", blocks.Add("eigenrays", eigenrays), "lines lc rgb '#0072b2' lw 1.6"));
  }
  panel.items.push_back(
      Line("fan", blocks.Add("ends", {{{0, link.source_m}}, {{link.range_m, link.receiver_m}}}),
           "points pt 7 ps 1 lc rgb '#d55e00'"));
  return OnePlot("fan", link.title, "range [m]", 0, range_m, std::move(panel), blocks,
                 {{"rays of the fan", "lines lc rgb '#b0b0b0' lw 0.8"},
                  {"the strongest arrivals", "lines lc rgb '#0072b2' lw 1.6"}},
                 png);
}

Figure DrawLoss(const RayLink& link, bool png) {
  const double range_m = kFanBeyond * link.range_m;
  Stroke by_rays;
  Stroke straight;
  std::vector<Stroke> parts;
  for (int i = 1; i <= kLossRanges; ++i) {
    const double at_m = range_m * i / kLossRanges;
    double power = 0;
    for (const RayArrival& arrival :
         FindEigenrays(link.scene, {0, link.source_m}, {at_m, link.receiver_m}, link.limits)) {
      power += PowerOf(arrival, link.absorption_dbpkm);
    }
    const double way_m = Hypot(at_m, link.receiver_m - link.source_m);
    straight.push_back({at_m, 20 * Log10(way_m) + link.absorption_dbpkm * way_m / 1000});
    // In a shadow there is no level: the line breaks.
    if (power > 0) {
      by_rays.push_back({at_m, -Decibels(power)});
    } else if (!by_rays.empty()) {
      parts.push_back(std::exchange(by_rays, {}));
    }
  }
  if (!by_rays.empty()) parts.push_back(by_rays);
  PlotBlocks blocks;
  Panel panel = {
      .y_label = "transmission loss [dB]", .items = {}, .settings = {"set yrange [*:*] reverse"}};
  if (!parts.empty()) {
    panel.items.push_back(Line("loss", blocks.Add("rays", parts), "lines lc rgb '#0072b2' lw 1.6"));
  }
  panel.items.push_back(
      Line("loss", blocks.Add("straight", {straight}), "lines lc rgb '#707070' dt (6,5) lw 1.2"));
  return OnePlot("loss", link.title,
                 fmt::format("range at the receiver's depth, {:g} m [m]", link.receiver_m), 0,
                 range_m, std::move(panel), blocks,
                 {{"rays, powers added", "lines lc rgb '#0072b2' lw 1.6"},
                  {"straight, 20 log r", "lines lc rgb '#707070' dt (6,5) lw 1.2"}},
                 png);
}

}  // namespace

std::vector<Figure> DrawRays(const RayLink& link, bool png) {
  return {DrawImpulse(link, png), DrawFan(link, png), DrawLoss(link, png)};
}

}  // namespace shoal
