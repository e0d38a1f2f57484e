// Metrics of where vehicles are and were: closest_approach, distance_travelled, arrival_time,
// formation_error. The judge has the positions; nothing is decoded here.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "lib/run/verdict/arrival_watch.h"
#include "lib/run/verdict/separation_watch.h"
#include "lib/tools/metrics/metric_vehicles.h"
#include "lib/tools/metrics/metric_watch.h"
#include "lib/tools/metrics/reduced_series.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

namespace {

class ClosestApproachWatch : public MetricWatch {
 public:
  ClosestApproachWatch(const Mission& mission, const MetricSpec& spec, const StepTime& now)
      : from_s_(spec.from_s),
        now_(now),
        vehicles_(PlacesOf(mission, spec.vehicle)),
        others_(PlacesOf(mission, spec.to)) {
    are_all_ =
        vehicles_.size() == mission.vehicles.size() && others_.size() == mission.vehicles.size();
  }

  void EndStep(const Judge& judge) override {
    if (now_.time_s < from_s_) return;
    if (are_all_) {
      separation_.Look(judge.sightings(), now_.utime);
      return;
    }
    for (const size_t vehicle : vehicles_) {
      const Sighting& own = judge.sighting(vehicle);
      for (const size_t other : others_) {
        const Sighting& its = judge.sighting(other);
        if (other == vehicle || !own.seen || !its.seen) continue;
        closest_m2_ = std::min(closest_m2_, (its.position_m - own.position_m).squaredNorm());
      }
    }
  }

  double Value(const Judge&) const override {
    const double closest_m = are_all_ ? separation_.closest().range_m : std::sqrt(closest_m2_);
    return std::isfinite(closest_m) ? closest_m : TrialResult::kNoValue;
  }

 private:
  double from_s_;
  const StepTime& now_;
  std::vector<size_t> vehicles_;
  std::vector<size_t> others_;
  bool are_all_ = false;  ///< Both name every vehicle.
  SeparationWatch separation_;
  double closest_m2_ = std::numeric_limits<double>::infinity();
};

class DistanceTravelledWatch : public MetricWatch {
 public:
  DistanceTravelledWatch(const Mission& mission, const MetricSpec& spec)
      : vehicles_(PlacesOf(mission, spec.vehicle)) {}

  double Value(const Judge& judge) const override {
    double sum_m = 0;
    bool was_seen = false;
    for (const size_t vehicle : vehicles_) {
      sum_m += judge.travelled_m(vehicle);
      was_seen |= judge.sighting(vehicle).seen;
    }
    return was_seen ? sum_m : TrialResult::kNoValue;
  }

 private:
  std::vector<size_t> vehicles_;
};

class ArrivalTimeWatch : public MetricWatch {
 public:
  ArrivalTimeWatch(const Mission& mission, const MetricSpec& spec, const StepTime& now)
      : now_(now), vehicles_(PlacesOf(mission, spec.vehicle)) {
    for (const size_t vehicle : vehicles_) {
      arrivals_.emplace_back(ArrivalGoal{
          .point_m = spec.point_m.value_or(mission.vehicles[vehicle].return_task.point_m),
          .within_m = spec.within_m,
          .by_s = mission.duration_s,
          .stays = spec.stays});
    }
  }

  void EndStep(const Judge& judge) override {
    for (size_t i = 0; i < vehicles_.size(); ++i) {
      const Sighting& own = judge.sighting(vehicles_[i]);
      if (own.seen) arrivals_[i].Look(own.position_m.head<2>(), now_.time_s);
    }
  }

  double Value(const Judge&) const override {
    double last_s = TrialResult::kNoValue;
    for (const ArrivalWatch& arrival : arrivals_) {
      const std::optional<double> time_s = arrival.Find().value;
      if (!time_s) return TrialResult::kNoValue;
      last_s = std::isnan(last_s) ? *time_s : std::max(last_s, *time_s);
    }
    return last_s;
  }

 private:
  const StepTime& now_;
  std::vector<size_t> vehicles_;
  std::vector<ArrivalWatch> arrivals_;
};

class FormationErrorWatch : public MetricWatch {
 public:
  FormationErrorWatch(const Mission& mission, const MetricSpec& spec, const StepTime& now)
      : from_s_(spec.from_s), now_(now), series_(spec.reduction, spec.percentile) {
    for (const size_t vehicle : PlacesOf(mission, spec.vehicle)) {
      for (const Task& task : mission.vehicles[vehicle].tasks) {
        const auto* track = std::get_if<TargetTrackTask>(&task.what);
        if (track == nullptr) continue;
        const std::vector<size_t> target = PlacesOf(mission, track->target);
        const std::optional<FollowZone> zone = FollowZoneOf(*track);
        if (target.size() != 1 || !zone) continue;
        followers_.push_back(
            {.vehicle = vehicle, .task = task.name, .target = target.front(), .zone = *zone});
      }
    }
  }

  void EndStep(const Judge& judge) override {
    if (now_.time_s < from_s_) return;
    for (const Follower& each : followers_) {
      const std::optional<HelmFacts>& helm = judge.helm(each.vehicle);
      if (!helm || helm->state != "DRIVE" || helm->task != each.task) continue;
      const Sighting& own = judge.sighting(each.vehicle);
      const Sighting& target = judge.sighting(each.target);
      if (!own.seen || !target.seen) continue;
      const double range_m = (target.position_m - own.position_m).norm();
      series_.Add(std::max({0.0, each.zone.min_m - range_m, range_m - each.zone.max_m}));
    }
  }

  double Value(const Judge&) const override { return series_.Value(); }

 private:
  /// A vehicle while it does one of its tasks.
  struct Follower {
    size_t vehicle = 0;
    std::string task;
    size_t target = 0;
    FollowZone zone;
  };

  double from_s_;
  const StepTime& now_;
  ReducedSeries series_;
  std::vector<Follower> followers_;
};

}  // namespace

std::unique_ptr<MetricWatch> WatchClosestApproach(const Mission& mission, const MetricSpec& spec,
                                                  const StepTime& now) {
  return std::make_unique<ClosestApproachWatch>(mission, spec, now);
}

std::unique_ptr<MetricWatch> WatchDistanceTravelled(const Mission& mission,
                                                    const MetricSpec& spec) {
  return std::make_unique<DistanceTravelledWatch>(mission, spec);
}

std::unique_ptr<MetricWatch> WatchArrivalTime(const Mission& mission, const MetricSpec& spec,
                                              const StepTime& now) {
  return std::make_unique<ArrivalTimeWatch>(mission, spec, now);
}

std::unique_ptr<MetricWatch> WatchFormationError(const Mission& mission, const MetricSpec& spec,
                                                 const StepTime& now) {
  return std::make_unique<FormationErrorWatch>(mission, spec, now);
}

}  // namespace shoal
