// What a step of a helm costs for a follower with 20 neighbours; it must be under 5 microseconds on
// one core. "of_promise" is how many times faster than that it is.
//
//   build/bin/helm_bench

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "apps/helm/helm_app.h"
#include "lib/vehicle/control/auv_pilot.h"
#include "lib/vehicle/guidance/target_tracker.h"
#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal {
namespace {

constexpr int kNeighbours = 20;
constexpr double kStep_s = 0.02;
constexpr double kPromise_s = 5e-6;

void Report(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations());
  state.counters["of_promise"] = benchmark::Counter(
      kPromise_s * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// Neighbour `i` of 20 on a grid of 25 m: most are near enough to be kept clear of.
Eigen::Vector3d PlaceOf(int i) { return {25.0 * (i % 5) - 50, 25.0 * (i / 5) - 45, 20}; }

Neighbour At(int id, const Eigen::Vector3d& position_m) {
  return {.id = id, .position_m = position_m, .velocity_mps = {1.5, 0, 0}};
}

/// The laws alone: guidance, autopilots, map from speed to revolutions.
void LawsOfFollower(benchmark::State& state, const VelocityLaw& law) {
  const Remus100 auv = BuildRemus100({});
  std::vector<Neighbour> group;
  for (int i = 0; i < kNeighbours; ++i) group.push_back(At(i + 2, PlaceOf(i)));
  Surroundings around = {
      .own = At(1, {3, 2, 20}), .target = At(0, {100, 0, 20}), .group = group, .seabed_z_m = 80};
  TargetTracker tracker({.law = law, .depth = {.climb_mps = 0.5}}, 0);
  AuvPilot pilot(DefaultRemusPilot());
  AuvMotion motion = {.z_m = 20, .speed_mps = 2};
  for (auto _ : state) {
    around.own.position_m.x() = 3 + motion.psi_rad;
    motion.psi_rad += 1e-5;
    const TrackCommand command = tracker.Update(around);
    benchmark::DoNotOptimize(pilot.KeepHeadingAndPitch(
        motion, command.psi_d_rad, command.theta_d_rad, DepthBound::Level(75), kStep_s));
    benchmark::DoNotOptimize(RpmForSpeed(auv, command.speed_mps));
  }
  Report(state);
}
BENCHMARK_CAPTURE(LawsOfFollower, cascade,
                  VelocityCascade{{SurvivalGroupLayer{}, FormationLayer{}, FeedForwardLayer{}}});
BENCHMARK_CAPTURE(LawsOfFollower, constant_bearing, ConstantBearingLaw{});

/// Hands over messages straight away and drops what is published.
class DirectBus : public Bus {
 public:
  void PublishBytes(std::string_view, std::span<const uint8_t> data) override {
    benchmark::DoNotOptimize(data.data());
  }
  void SubscribeBytes(const std::string& channel, Handler handler) override {
    handlers_[channel] = std::move(handler);
  }
  void SubscribeAll(Handler) override {}

  const Handler& HandlerOf(const std::string& channel) const { return handlers_.at(channel); }

 private:
  std::map<std::string, Handler> handlers_;
};

Bytes NavAt(const Eigen::Vector3d& position_m) {
  nav_t nav{};
  nav.x_m = position_m.x();
  nav.y_m = position_m.y();
  nav.z_m = position_m.z();
  nav.heading_deg = nav.course_over_ground_deg = 90;
  nav.speed_mps = nav.speed_over_ground_mps = nav.surge_mps = 1.5;
  nav.altitude_m = 60;
  Bytes bytes(static_cast<size_t>(nav.getEncodedSize()));
  nav.encode(bytes.data(), 0, nav.getEncodedSize());
  return bytes;
}

/// The whole app: one step of one follower. `receives`: with the NAV of all, decoded and noted.
void TickOfHelm(benchmark::State& state, bool receives) {
  Mission mission;
  PathFollowTask path;
  path.points_m = {{100, 0, 20}, {1e5, 0, 20}};
  TargetTrackTask track;
  track.target = "leader";
  const auto add = [&](const std::string& name, const decltype(Task::what)& what) {
    Vehicle vehicle;
    vehicle.name = name;
    vehicle.model = Remus100Options{};
    vehicle.helm_options.deploy_at_start = true;
    vehicle.helm_options.nav_timeout_s = 1e9;
    vehicle.tasks = {{.name = "task", .what = what}};
    mission.vehicles.push_back(vehicle);
  };
  struct EncodedNav {
    std::string channel;
    Bytes bytes;
    Bus::Handler handler;
  };
  std::vector<EncodedNav> navs;
  const auto put = [&](const std::string& name, const Eigen::Vector3d& position_m) {
    navs.push_back({channels::Nav(name).name, NavAt(position_m), {}});
  };
  add("leader", path);
  put("leader", {100, 0, 20});
  add("me", track);
  put("me", {3, 2, 20});
  for (int i = 0; i < kNeighbours; ++i) {
    const std::string name = "follower_" + std::to_string(i);
    add(name, track);
    put(name, PlaceOf(i));
  }
  DirectBus bus;
  HelmApp helm(mission, mission.vehicles[1], bus);
  for (EncodedNav& nav : navs) nav.handler = bus.HandlerOf(nav.channel);
  const auto receive = [&] {
    for (const EncodedNav& nav : navs) {
      nav.handler({.channel = nav.channel, .publisher = "sim", .data = nav.bytes});
    }
  };
  receive();
  int64_t utime = 0;
  for (auto _ : state) {
    if (receives) receive();
    helm.Tick(utime);
    utime += 20'000;
  }
  Report(state);
}
BENCHMARK_CAPTURE(TickOfHelm, alone, false);
BENCHMARK_CAPTURE(TickOfHelm, with_the_nav_of_all, true);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
