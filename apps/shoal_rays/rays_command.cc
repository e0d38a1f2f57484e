#include "apps/shoal_rays/rays_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <ostream>
#include <tuple>

#include "apps/shoal_rays/ray_figures.h"
#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/result.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/file/load.h"
#include "lib/mission/file/ray_surroundings.h"
#include "lib/mission/file/water_files.h"
#include "lib/sea/acoustics/absorption.h"
#include "lib/sea/acoustics/modem_preset.h"
#include "lib/tools/plot/drawing_folder.h"

namespace shoal {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr size_t kMaxRows = 60;
/// Of a .env, whose fan may be narrower than what is looked for.
constexpr double kLeastReflection = 1e-4;

std::optional<Eigen::Vector3d> PlaceIn(const std::string& text) {
  const std::vector<std::string_view> parts = TrimmedParts(text, ',');
  if (parts.size() != 3) return std::nullopt;
  Eigen::Vector3d place_m;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> number = NumberIn(parts[static_cast<size_t>(i)]);
    if (!number || std::abs(*number) > 1e6) return std::nullopt;
    place_m[i] = *number;
  }
  return place_m;
}

/// The state of the command while it runs.
class RaysCommand {
 public:
  RaysCommand(const RaysOptions& options, std::ostream& out, std::ostream& err)
      : options_(options), out_(out), err_(err) {}

  int Run() {
    const bool is_env = LowerCase(options_.file).ends_with(".env");
    if (const int code = is_env ? ReadEnv() : ReadMission(); code != kExitOk) return code;
    if (const int code = Find(); code != kExitOk) return code;
    Print();
    if (!options_.plot) return kExitOk;
    const std::string gnuplot = FindGnuplot(options_.search_path, err_);
    if (gnuplot.empty()) return kExitEnvironment;
    return DrawInto({.out_dir = options_.out_dir.empty() ? "rays" : options_.out_dir,
                     .png = options_.png,
                     .keep = options_.keep},
                    gnuplot, DrawRays(link_, options_.png), out_, err_);
  }

 private:
  int Fail(const std::string& why) {
    err_ << "shoal: " << why << '\n';
    return kExitUsage;
  }

  /// Reads --from and --to; places that are not given are `from_m` and `to_m`.
  int TakePlaces() {
    for (const auto& [option, text, place_m] :
         {std::tuple("--from", &options_.from, &from_m_), {"--to", &options_.to, &to_m_}}) {
      if (text->empty()) {
        if (place_m->allFinite()) continue;
        return Fail(fmt::format("{} is needed: x,y,z in metres, East, North, down, as in {} 0,0,30",
                                option, option));
      }
      const std::optional<Eigen::Vector3d> place = PlaceIn(*text);
      if (!place) {
        return Fail(
            fmt::format("{} {}: three numbers with commas are needed, x,y,z in metres, "
                        "East, North, down, as in {} 0,0,30",
                        option, *text, option));
      }
      *place_m = *place;
    }
    if ((to_m_ - from_m_).head<2>().norm() == 0) {
      return Fail("--from and --to are at one place of the map; rays need a range between them");
    }
    link_.range_m = Hypot(to_m_.x() - from_m_.x(), to_m_.y() - from_m_.y());
    link_.source_m = from_m_.z();
    link_.receiver_m = to_m_.z();
    return kExitOk;
  }

  int ReadEnv() {
    const Result<BellhopCase> bay = ReadBellhopFile(options_.file);
    if (!bay.ok()) return Fail(bay.error());
    for (const std::string& warning : bay->warnings) err_ << "shoal: warning: " << warning << '\n';
    from_m_ = {0, 0, bay->source_depths_m.front()};
    to_m_ = {bay->receiver_ranges_m.back(), 0, bay->receiver_depths_m.front()};
    if (const int code = TakePlaces(); code != kExitOk) return code;
    link_.title = bay->title;
    link_.scene = bay->scene;
    if (bay->has_thorp_absorption) {
      link_.absorption_dbpkm = ThorpAbsorption(bay->scene.hz / 1000);
    }
    const double widest_rad = std::max(-bay->first_launch_rad, bay->last_launch_rad);
    link_.limits.max_launch_rad = std::clamp(widest_rad, 0.01, 89.5 * kDegree);
    link_.limits.min_reflection = kLeastReflection;
    return kExitOk;
  }

  int ReadMission() {
    const LoadedMission loaded = LoadMission(options_.file, options_.overrides);
    for (const std::string& error : loaded.errors) err_ << error << '\n';
    if (!loaded.errors.empty()) return kExitUsage;
    const Mission& mission = loaded.mission;
    const std::optional<RayChannelOptions>& rays = mission.acoustics.options.rays;
    if (!rays) {
      return Fail(
          fmt::format("{}: sound goes straight in this mission; write [acoustics.channel], "
                      "model = \"rays\"",
                      options_.file));
    }
    if (!rays->arrivals_file.empty()) {
      return Fail(
          fmt::format("{}: arrivals come from {}, and no rays are traced; remove "
                      "arrivals_file to trace them",
                      options_.file, rays->arrivals_file));
    }
    const std::shared_ptr<RayChannel> channel = MakeRayChannel(mission);
    if (channel == nullptr) {
      return Fail(fmt::format("{}: the sea floor of the mission cannot be read", options_.file));
    }
    if (const int code = TakePlaces(); code != kExitOk) return code;
    link_.title = mission.name;
    link_.scene = channel->SceneBetween(from_m_, to_m_);
    const AcousticOptions& acoustics = mission.acoustics.options;
    link_.absorption_dbpkm = LinkModel(*acoustics.modem, acoustics.sea).absorption_dbpkm();
    link_.limits.max_launch_rad = rays->max_launch_deg * kDegree;
    link_.limits.min_reflection = kLeastReflection;
    reception_ = channel->Receive({.position_m = from_m_}, {.position_m = to_m_});
    return kExitOk;
  }

  int Find() {
    for (const auto& [option, range_m, depth_m] :
         {std::tuple("--from", 0.0, link_.source_m), {"--to", link_.range_m, link_.receiver_m}}) {
      const double top_m = DepthAt(link_.scene.surface, range_m);
      const double bottom_m = DepthAt(link_.scene.bottom, range_m);
      if (depth_m >= top_m && depth_m <= bottom_m) continue;
      return Fail(fmt::format("{} is at {:g} m, and the water there is from {:g} to {:g} m", option,
                              depth_m, top_m, bottom_m));
    }
    link_.arrivals = FindEigenrays(link_.scene, {0, link_.source_m},
                                   {link_.range_m, link_.receiver_m}, link_.limits);
    return kExitOk;
  }

  void Print() {
    out_ << fmt::format("{}: range {:.1f} m, from {:g} m to {:g} m deep, {:g} kHz, {:.3g} dB/km\n",
                        link_.title, link_.range_m, link_.source_m, link_.receiver_m,
                        link_.scene.hz / 1000, link_.absorption_dbpkm);
    if (link_.arrivals.empty()) {
      out_ << fmt::format("no arrival within {:.1f} deg of the horizontal\n",
                          link_.limits.max_launch_rad / kDegree);
    } else {
      PrintTable();
    }
    if (!reception_) return;
    if (reception_->shadow != ShadowReason::kNone) {
      out_ << fmt::format("shadow zone: {}\n", ShadowText(reception_->shadow));
    }
    if (reception_->num_arrivals == 0) return;
    const auto level = [](double power) {
      return power > 0 ? fmt::format("{:.1f} dB", 10 * Log10(power)) : std::string("none");
    };
    out_ << fmt::format(
        "a modem gets {} significant arrivals over {:.2f} ms: signal {}, "
        "self-interference {}\n",
        reception_->num_arrivals, 1000 * reception_->delay_spread_s, level(reception_->signal),
        level(reception_->interference));
  }

  void PrintTable() {
    out_ << "   delay [s]   late [ms]  level [dB]  phase  launch  arrive  surface  bottom  caustics"
            "  length [m]\n";
    const double first_s = link_.arrivals.front().delay_s;
    const size_t num_rows = std::min(link_.arrivals.size(), kMaxRows);
    for (size_t i = 0; i < num_rows; ++i) {
      const RayArrival& arrival = link_.arrivals[i];
      out_ << fmt::format(
          "{:12.6f}{:12.3f}{:12.1f}{:7.0f}{:8.2f}{:8.2f}{:9}{:8}{:10}{:12.1f}\n", arrival.delay_s,
          1000 * (arrival.delay_s - first_s), 10 * Log10(PowerOf(arrival, link_.absorption_dbpkm)),
          arrival.phase_rad / kDegree, arrival.launch_rad / kDegree, arrival.arrive_rad / kDegree,
          arrival.num_surface, arrival.num_bottom, arrival.num_caustics, arrival.length_m);
    }
    if (num_rows < link_.arrivals.size()) {
      out_ << fmt::format("and {} more\n", link_.arrivals.size() - num_rows);
    }
    out_
        << "levels relative to 1 m; angles in degrees, positive down, in the direction of travel\n";
  }

  const RaysOptions& options_;
  std::ostream& out_;
  std::ostream& err_;
  Eigen::Vector3d from_m_ = Eigen::Vector3d::Constant(std::nan(""));
  Eigen::Vector3d to_m_ = Eigen::Vector3d::Constant(std::nan(""));
  RayLink link_;
  std::optional<RayReception> reception_;
};

}  // namespace

int RunRays(const RaysOptions& options, std::ostream& out, std::ostream& err) {
  return RaysCommand(options, out, err).Run();
}

}  // namespace shoal
