// How well followers keep formation by what the acoustic network lets through: runs a mission
// several times in one process, each time with another seed, beside the same mission with swarm =
// "direct".
//
//   swarm_formation MISSION NUM_SEEDS [key.path=value]...
//
// Prints one line of numbers, separated by blanks: the formation error in m (mean over the seeds,
// and standard deviation over them), how far followers were outside their zone of rest, in m, the
// smallest separation, in m, and in per cent of all packets what arrived, and of what was received
// what was clean, recovered and rejected. tests/bench/swarm makes tables of it.
//
// The formation error is the root mean square, over the followers and all steps from kFormedUp_s
// on, of the distance between where a follower is and where it would be if it knew the truth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "lib/mission/file/load.h"
#include "sim/director_app.h"
#include "sim/simulation.h"

namespace {

using shoal::Mission;

constexpr double kFormedUp_s = 120;

/// Where each vehicle was in each step.
using Tracks = std::vector<std::vector<Eigen::Vector3d>>;

struct Numbers {
  double error_m = 0;
  double outside_m = 0;
  double separation_m = 1e9;
  double delivered_pct = 0;
  double clean_pct = 0;
  double recovered_pct = 0;
  double rejected_pct = 0;
};

Tracks Run(const Mission& mission, Numbers* numbers) {
  shoal::Simulation simulation(mission, "");
  Tracks tracks(mission.vehicles.size());
  while (simulation.Step()) {
    for (size_t i = 0; i < tracks.size(); ++i) {
      tracks[i].push_back(simulation.director().judge().sighting(i).position_m);
    }
  }
  const auto share = [](const shoal::FateCounts& counts, std::string_view what) {
    constexpr int kAll = shoal::FateCounts::kAll;
    const auto offered = static_cast<double>(counts.CountOffered(kAll, kAll));
    const auto count = static_cast<double>(counts.Count(kAll, kAll, what));
    return offered > 0 ? 100 * count / offered : 0;
  };
  numbers->delivered_pct = share(simulation.director().fates(shoal::Kind::kPacket), "delivered");
  const shoal::FateCounts& counts = simulation.director().judge().swarm_counts();
  numbers->clean_pct = share(counts, "clean");
  numbers->recovered_pct = share(counts, "recovered");
  numbers->rejected_pct = share(counts, "rejected");
  return tracks;
}

Mission WithTheTruth(Mission mission) {
  for (shoal::Vehicle& vehicle : mission.vehicles) {
    for (shoal::Task& task : vehicle.tasks) {
      if (auto* track = std::get_if<shoal::TargetTrackTask>(&task.what)) {
        track->swarm = shoal::SwarmKnowledge::kDirect;
      }
    }
  }
  return mission;
}

/// Returns the zone of rest of a follower; nothing where it has none.
const shoal::FormationLayer* ZoneOf(const shoal::Vehicle& vehicle) {
  for (const shoal::Task& task : vehicle.tasks) {
    const auto* track = std::get_if<shoal::TargetTrackTask>(&task.what);
    const auto* cascade =
        track == nullptr ? nullptr : std::get_if<shoal::VelocityCascade>(&track->track.law);
    if (cascade == nullptr) continue;
    for (const shoal::VelocityLayer& layer : cascade->layers) {
      if (const auto* zone = std::get_if<shoal::FormationLayer>(&layer)) return zone;
    }
  }
  return nullptr;
}

void Compare(const Mission& mission, const Tracks& tracks, const Tracks& truth, Numbers* numbers) {
  double squares = 0;
  double outside_squares = 0;
  int64_t count = 0;
  size_t leader = 0;
  while (mission.vehicles[leader].name != mission.swarms[0].leader) ++leader;
  const auto first = static_cast<size_t>(kFormedUp_s * 1e6 / static_cast<double>(mission.tick_us));
  for (size_t i = 0; i < tracks.size(); ++i) {
    const shoal::FormationLayer* zone = ZoneOf(mission.vehicles[i]);
    for (size_t step = first; step < tracks[i].size(); ++step) {
      for (size_t k = 0; k < i; ++k) {
        numbers->separation_m =
            std::min(numbers->separation_m, (tracks[i][step] - tracks[k][step]).norm());
      }
      if (zone == nullptr) continue;
      const double range_m = (tracks[i][step] - tracks[leader][step]).norm();
      const double outside_m =
          std::max({0.0, range_m - zone->r_outer_m(), zone->r_inner_m - range_m});
      squares += (tracks[i][step] - truth[i][step]).squaredNorm();
      outside_squares += outside_m * outside_m;
      ++count;
    }
  }
  numbers->error_m = std::sqrt(squares / static_cast<double>(std::max<int64_t>(count, 1)));
  numbers->outside_m =
      std::sqrt(outside_squares / static_cast<double>(std::max<int64_t>(count, 1)));
}

}  // namespace

int main(int argc, char** argv) {
  const int num_seeds = argc < 3 ? 0 : std::atoi(argv[2]);
  if (num_seeds < 1) {
    fmt::print(stderr, "usage: swarm_formation MISSION NUM_SEEDS [key.path=value]...\n");
    return 2;
  }
  Numbers mean;
  mean.separation_m = 1e9;
  double error_squares = 0;
  for (int seed = 1; seed <= num_seeds; ++seed) {
    std::vector<std::string> overrides(argv + 3, argv + argc);
    overrides.push_back(fmt::format("mission.seed={}", seed));
    const shoal::LoadedMission loaded = shoal::LoadMission(argv[1], overrides);
    for (const std::string& error : loaded.errors) fmt::print(stderr, "{}\n", error);
    if (!loaded.errors.empty()) return 2;
    Numbers numbers;
    Numbers ignored;
    const Tracks truth = Run(WithTheTruth(loaded.mission), &ignored);
    const Tracks tracks = Run(loaded.mission, &numbers);
    Compare(loaded.mission, tracks, truth, &numbers);
    const double weight = 1.0 / num_seeds;
    mean.error_m += weight * numbers.error_m;
    error_squares += weight * numbers.error_m * numbers.error_m;
    mean.outside_m += weight * numbers.outside_m;
    mean.separation_m = std::min(mean.separation_m, numbers.separation_m);
    mean.delivered_pct += weight * numbers.delivered_pct;
    mean.clean_pct += weight * numbers.clean_pct;
    mean.recovered_pct += weight * numbers.recovered_pct;
    mean.rejected_pct += weight * numbers.rejected_pct;
  }
  const double deviation_m = std::sqrt(std::max(0.0, error_squares - mean.error_m * mean.error_m));
  fmt::print("{:.2f} {:.2f} {:.2f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}\n", mean.error_m, deviation_m,
             mean.outside_m, mean.separation_m, mean.delivered_pct, mean.clean_pct,
             mean.recovered_pct, mean.rejected_pct);
  return 0;
}
