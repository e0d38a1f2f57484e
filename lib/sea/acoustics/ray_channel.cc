#include "lib/sea/acoustics/ray_channel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/check/check.h"
#include "lib/base/check/enum_table.h"
#include "lib/base/text/numbers.h"
#include "lib/sea/rays/floor_section.h"

namespace shoal {

namespace {

/// A transducer hangs at least this far below the surface and above the bottom.
constexpr double kNearestToBoundary_m = 0.5;
/// Nearer than this in range, or steeper than the ratio, two modems are taken to be as far apart:
/// a ray straight down has no range to be found by.
constexpr double kNearestRange_m = 0.05;
constexpr double kSteepestRatio = 0.0105;
constexpr double kSteepestLaunch_rad = 1.562;  // 89.5 deg.
constexpr double kLaunchMargin_rad = 0.035;
/// Links shorter than this are found for their own places.
constexpr double kShortestKept_cells = 100;
/// Arrivals weaker than the strongest by 40 dB change no level by more than 0.01 dB.
constexpr double kWeakestPower = 1e-4;
constexpr double kWeakestReflection = 1e-3;
constexpr int kMaxBounces = 100;
/// 500 bytes each.
constexpr size_t kMaxLinks = 100'000;
/// The floor is looked at in this many places along a link at most, and no nearer than the step.
constexpr int kMaxFloorPoints = 48;
constexpr double kFloorStep_m = 25;

int32_t CellOf(double place_m, double cell_m) {
  constexpr double kMost = 2e9;
  return static_cast<int32_t>(std::clamp(std::floor(place_m / cell_m), -kMost, kMost));
}

double MiddleOf(int32_t cell, double cell_m) { return (cell + 0.5) * cell_m; }

double WithinWater(double depth_m, double bottom_m) {
  const double margin_m = std::min(kNearestToBoundary_m, bottom_m / 2);
  return std::clamp(depth_m, margin_m, bottom_m - margin_m);
}

double RangeBetween(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m) {
  return Hypot(to_m.x() - from_m.x(), to_m.y() - from_m.y());
}

SoundProfile ProfileOrDie(const RayChannelOptions& options) {
  SHOAL_CHECK(ProblemOf(options).empty(), "ProblemOf(options) is empty");
  return *SoundProfile::Make(options.profile);
}

}  // namespace

std::string_view ShadowText(ShadowReason reason) {
  static constexpr EnumTable<ShadowReason, std::string_view> kTexts = {
      "",
      "sound is slower below and bends down",
      "sound is slower above and bends up",
      "faster water between the depths turns sound back",
      "the sea floor is between the two",
      "no path within the launch angles"};
  return kTexts[reason];
}

double LossOf(const std::vector<PacketErrorPoint>& table, double snr_db) {
  const auto next = std::ranges::upper_bound(table, snr_db, {}, &PacketErrorPoint::snr_db);
  if (next == table.begin()) return table.front().loss;
  if (next == table.end()) return table.back().loss;
  const PacketErrorPoint& a = *std::prev(next);
  return a.loss + (next->loss - a.loss) * ((snr_db - a.snr_db) / (next->snr_db - a.snr_db));
}

std::string ProblemOf(const RayChannelOptions& options) {
  const Result<SoundProfile> profile = SoundProfile::Make(options.profile);
  if (!profile.ok()) return profile.error();
  for (size_t i = 0; i < options.packet_errors.size(); ++i) {
    const PacketErrorPoint& point = options.packet_errors[i];
    const std::string place = "row " + std::to_string(i + 1) + " of the packet error table: ";
    if (!std::isfinite(point.snr_db)) return place + "snr_db must be a number";
    if (!IsBetween(point.loss, 0, 1)) return place + "loss must be between 0 and 1";
    if (i > 0 && !(point.snr_db > options.packet_errors[i - 1].snr_db)) {
      return place + "snr_db must grow from row to row";
    }
  }
  const bool is_sound = options.bottom_depth_m > 0 && options.cell_m > 0 &&
                        options.max_launch_deg > 0 && options.max_launch_deg < 90 &&
                        options.window_s >= 0 && options.significant_db > 0 &&
                        options.max_doppler_mps > 0 && options.wind_mps >= 0;
  return is_sound ? ""
                  : "bottom_depth_m, cell_m, max_launch_deg (below 90), significant_db and "
                    "max_doppler_mps must be more than 0, window_s and wind_mps not negative";
}

RayChannel::RayChannel(const RayChannelOptions& options, RaySurroundings surroundings,
                       const RayBand& band)
    : options_(options),
      profile_(ProfileOrDie(options)),
      surroundings_(std::move(surroundings)),
      band_(band),
      significant_share_(Pow(10, -options.significant_db / 10)) {
  SHOAL_CHECK(!options_.follows_floor || surroundings_.floor,
              "the floor that is followed is known");
  SHOAL_CHECK(options_.arrivals_file.empty() || surroundings_.arrivals != nullptr,
              "the arrivals that are named are there");
}

size_t RayChannel::CellHash::operator()(const Cell& cell) const {
  uint64_t hash = 0;
  for (const int32_t each : cell) {
    hash = (hash ^ static_cast<uint32_t>(each)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 29;
  }
  return hash;
}

RayScene RayChannel::SceneBetween(const Eigen::Vector3d& from_m,
                                  const Eigen::Vector3d& to_m) const {
  RayScene scene;
  scene.water = {{0, profile_}};
  scene.hz = band_.hz;
  scene.surface_reflector = WindySurface{options_.wind_mps};
  scene.bottom_reflector = options_.bottom;
  scene.bottom = {{0, options_.bottom_depth_m}};
  const double range_m = RangeBetween(from_m, to_m);
  if (options_.follows_floor && range_m > 0) {
    const int num_points =
        std::clamp(static_cast<int>(range_m / kFloorStep_m) + 1, 2, kMaxFloorPoints);
    scene.bottom = FloorSection(*surroundings_.floor, from_m.head<2>(), to_m.head<2>(), num_points);
    for (BoundaryPoint& point : scene.bottom) point.depth_m = std::max(point.depth_m, 0.1);
  }
  return scene;
}

std::vector<RayArrival> RayChannel::FindArrivals(const RayScene& scene, double range_m,
                                                 double source_m, double receiver_m) const {
  if (surroundings_.arrivals != nullptr) {
    const auto nearest = surroundings_.arrivals->Nearest(source_m, range_m, receiver_m);
    return {nearest.begin(), nearest.end()};
  }
  RayLimits limits;
  const double straight_rad = Atan2(std::abs(receiver_m - source_m), range_m);
  limits.max_launch_rad = std::min(
      std::max(options_.max_launch_deg * std::numbers::pi / 180, straight_rad + kLaunchMargin_rad),
      kSteepestLaunch_rad);
  limits.min_reflection = kWeakestReflection;
  limits.max_bounces = kMaxBounces;
  return FindEigenrays(scene, {0, source_m}, {range_m, receiver_m}, limits);
}

ShadowReason RayChannel::ReasonOf(const RayScene& scene, double range_m, double source_m,
                                  double receiver_m) const {
  for (const BoundaryPoint& point : scene.bottom) {
    const double straight_m = source_m + (receiver_m - source_m) * point.range_m / range_m;
    if (point.range_m > 0 && point.range_m < range_m && point.depth_m <= straight_m) {
      return ShadowReason::kBottomBetween;
    }
  }
  const double top_m = std::min(source_m, receiver_m);
  const double base_m = std::max(source_m, receiver_m);
  const double at_ends_mps = std::max(profile_.SpeedAt(top_m), profile_.SpeedAt(base_m));
  for (const SpeedPoint& point : profile_.points()) {
    if (point.depth_m > top_m && point.depth_m < base_m && point.speed_mps > at_ends_mps) {
      return ShadowReason::kFastLayer;
    }
  }
  constexpr double kAround_m = 1;
  const double change_mps =
      profile_.SpeedAt(base_m + kAround_m) - profile_.SpeedAt(std::max(top_m - kAround_m, 0.0));
  if (change_mps < 0) return ShadowReason::kBendsDown;
  return change_mps > 0 ? ShadowReason::kBendsUp : ShadowReason::kNotInFan;
}

RayChannel::Link RayChannel::FindLink(const Eigen::Vector3d& from_m,
                                      const Eigen::Vector3d& to_m) const {
  const RayScene scene = SceneBetween(from_m, to_m);
  Link link;
  const double own_range_m = RangeBetween(from_m, to_m);
  link.source_m = WithinWater(from_m.z(), DepthAt(scene.bottom, 0));
  link.receiver_m = WithinWater(to_m.z(), DepthAt(scene.bottom, own_range_m));
  link.range_m = std::max(
      {own_range_m, kNearestRange_m, kSteepestRatio * std::abs(link.receiver_m - link.source_m)});
  const std::vector<RayArrival> arrivals =
      FindArrivals(scene, link.range_m, link.source_m, link.receiver_m);
  const bool has_absorption =
      surroundings_.arrivals != nullptr && surroundings_.arrivals->has_absorption();
  const double absorption_dbpkm = has_absorption ? 0 : band_.absorption_dbpkm;
  const double c_source = profile_.SpeedAt(link.source_m);
  const double c_receiver = profile_.SpeedAt(link.receiver_m);
  double strongest = 0;
  bool has_direct = false;
  for (const RayArrival& arrival : arrivals) {
    const Path path = {.delay_s = arrival.delay_s,
                       .power = PowerOf(arrival, absorption_dbpkm),
                       .by_range = Cos(arrival.launch_rad) / c_source,
                       .by_source = -Sin(arrival.launch_rad) / c_source,
                       .by_receiver = Sin(arrival.arrive_rad) / c_receiver,
                       .num_surface = static_cast<int16_t>(std::min(arrival.num_surface, 1000)),
                       .num_bottom = static_cast<int16_t>(std::min(arrival.num_bottom, 1000))};
    strongest = std::max(strongest, path.power);
    link.paths.push_back(path);
  }
  std::erase_if(link.paths,
                [&](const Path& path) { return path.power < strongest * kWeakestPower; });
  for (const Path& path : link.paths) has_direct |= path.num_surface + path.num_bottom == 0;
  if (!has_direct) {
    link.shadow = ReasonOf(scene, link.range_m, link.source_m, link.receiver_m);
  }
  return link;
}

const RayChannel::Link& RayChannel::LinkOf(const Eigen::Vector3d& from_m,
                                           const Eigen::Vector3d& to_m, double range_m) {
  const double cell_m = options_.cell_m;
  if (range_m < kShortestKept_cells * cell_m) return uncached_ = FindLink(from_m, to_m);
  const auto cell_of = [cell_m](double place_m) { return CellOf(place_m, cell_m); };
  const auto middle_of = [cell_m](int32_t cell) { return MiddleOf(cell, cell_m); };
  Cell cell = {cell_of(range_m), cell_of(from_m.z()), cell_of(to_m.z()), 0, 0, 0};
  if (options_.follows_floor) {
    cell = {cell_of(from_m.x()), cell_of(from_m.y()), cell_of(from_m.z()),
            cell_of(to_m.x()),   cell_of(to_m.y()),   cell_of(to_m.z())};
  }
  const auto found = links_.find(cell);
  if (found != links_.end()) return found->second;
  // What is found depends on the cell alone: to forget all of it changes nothing but time.
  if (links_.size() >= kMaxLinks) links_.clear();
  Eigen::Vector3d from = {0, 0, middle_of(cell[1])};
  Eigen::Vector3d to = {middle_of(cell[0]), 0, middle_of(cell[2])};
  if (options_.follows_floor) {
    from = {middle_of(cell[0]), middle_of(cell[1]), middle_of(cell[2])};
    to = {middle_of(cell[3]), middle_of(cell[4]), middle_of(cell[5])};
  }
  return links_.emplace(cell, FindLink(from, to)).first->second;
}

RayReception RayChannel::Receive(const RayEnd& from, const RayEnd& to) {
  const double range_m = RangeBetween(from.position_m, to.position_m);
  const Link& link = LinkOf(from.position_m, to.position_m, range_m);
  RayReception reception;
  reception.shadow = link.shadow;
  if (link.paths.empty()) return reception;
  const auto strongest = std::ranges::max_element(link.paths, {}, &Path::power);
  reception.num_surface = strongest->num_surface;
  reception.num_bottom = strongest->num_bottom;
  // Places relative to those that the link was found for.
  const bool is_kept = &link != &uncached_ && surroundings_.arrivals == nullptr;
  const double further_m = is_kept ? range_m - link.range_m : 0;
  const double deeper_source_m = is_kept ? from.position_m.z() - link.source_m : 0;
  const double deeper_receiver_m = is_kept ? to.position_m.z() - link.receiver_m : 0;
  const auto delay_of = [&](const Path& path) {
    return path.delay_s + path.by_range * further_m + path.by_source * deeper_source_m +
           path.by_receiver * deeper_receiver_m;
  };
  const Eigen::Vector3d apart_m = to.position_m - from.position_m;
  const Eigen::Vector3d apart_mps = to.velocity_mps - from.velocity_mps;
  const double range_rate_mps =
      range_m > 0 ? (apart_m.x() * apart_mps.x() + apart_m.y() * apart_mps.y()) / range_m : 0;
  const double speed_mps = profile_.SpeedAt(to.position_m.z());
  const auto doppler_of = [&](const Path& path) {
    return -speed_mps * (path.by_range * range_rate_mps + path.by_source * from.velocity_mps.z() +
                         path.by_receiver * to.velocity_mps.z());
  };
  reception.doppler_mps = doppler_of(*strongest);
  const double significant = strongest->power * significant_share_;
  double last_s = 0;
  for (const Path& path : link.paths) {
    if (path.power < significant) continue;
    const double delay_s = delay_of(path);
    if (reception.num_arrivals == 0 || delay_s < reception.travel_s) reception.travel_s = delay_s;
    last_s = std::max(last_s, delay_s);
    ++reception.num_arrivals;
  }
  reception.delay_spread_s = last_s - reception.travel_s;
  for (const Path& path : link.paths) {
    const double late_s = delay_of(path) - reception.travel_s;
    const bool adds =
        late_s <= options_.window_s && std::abs(doppler_of(path)) <= options_.max_doppler_mps;
    (adds ? reception.signal : reception.interference) += path.power;
  }
  return reception;
}

std::optional<double> RayChannel::TravelTime(const Eigen::Vector3d& from_m,
                                             const Eigen::Vector3d& to_m) {
  const RayReception reception = Receive({.position_m = from_m}, {.position_m = to_m});
  if (reception.num_arrivals == 0) return std::nullopt;
  return reception.travel_s;
}

}  // namespace shoal
