// What a decision of a helm costs: a waypoint and 0 to 5 contacts, met at random, over 360 courses
// and 41 speeds. It must be under 100 microseconds with 5 contacts on one core.
// "of_promise" is how many times faster than that it is.
//
//   build/bin/decision_bench
//
// WholeDecision makes the functions that keep clear of the contacts, normalised, and finds the best
// point; ByTheRules does so with the functions of the collision regulations, each contact in the
// role of its first moment. Dense evaluates the functions of WholeDecision at every point, sums,
// and takes the greatest: the reference.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/random/stream.h"
#include "lib/helm/colregs/preferences.h"
#include "lib/helm/decision/cpa_function.h"
#include "lib/helm/decision/decide.h"
#include "lib/helm/decision/shapes.h"

namespace shoal {
namespace {

constexpr double kPromise_s = 100e-6;
constexpr int kNumEncounters = 200;

/// As in the reference's field missions, scaled to vessels of a few metres per second.
constexpr double kOuter_m = 80;
constexpr double kInner_m = 20;
constexpr CpaUtility kUtility = {.lo_m = 8, .hi_m = 25};
constexpr ColregsLimits kLimits = {.outer_m = kOuter_m, .min_cpa_m = 8, .max_cpa_m = 25};
constexpr ColregsPreferences kPreferences = {.min_cpa_m = 8, .max_cpa_m = 25};

struct DrawnContact {
  Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();
};

struct Encounter {
  double bearing_deg = 0;
  std::vector<DrawnContact> contacts = {};
};

/// Contacts from 10 m on; every other one is on its way to own ship.
std::vector<Encounter> DrawEncounters(int64_t num_contacts, double farthest_m = 78) {
  std::vector<Encounter> encounters;
  for (int i = 0; i < kNumEncounters; ++i) {
    Stream stream(1, "encounter", i);
    Encounter encounter{.bearing_deg = 360 * stream.Uniform()};
    for (int64_t k = 0; k < num_contacts; ++k) {
      const double bearing_rad = 2 * kPi * stream.Uniform();
      const double course_rad = k % 2 == 0 ? bearing_rad + kPi + 0.5 * (stream.Uniform() - 0.5)
                                           : 2 * kPi * stream.Uniform();
      encounter.contacts.push_back(
          {.offset_m = (10 + (farthest_m - 10) * stream.Uniform()) * UnitVector(bearing_rad),
           .velocity_mps = (0.5 + 2.5 * stream.Uniform()) * UnitVector(course_rad)});
    }
    encounters.push_back(encounter);
  }
  return encounters;
}

double WeightOf(const DrawnContact& contact) {
  const double range_m = contact.offset_m.norm();
  return 200 * std::clamp((kOuter_m - range_m) / (kOuter_m - kInner_m), 0.0, 1.0);
}

std::shared_ptr<CpaFunction> CpaOf(const DrawnContact& contact, const Domain& domain) {
  return std::make_shared<CpaFunction>(CpaGrid(contact.offset_m, contact.velocity_mps, 120, domain),
                                       kUtility);
}

void AddWaypoint(const Encounter& encounter, const Domain& domain,
                 std::vector<WeightedObjective>* aims) {
  aims->push_back({.weight = 100,
                   .objective = Couple(PeakOverCourse(encounter.bearing_deg, 0, 180),
                                       PeakOverAxis(domain.speed_mps, 2, 1, 1.6, 20), 50, 50)});
}

void MakeAims(const Encounter& encounter, const Domain& domain,
              std::vector<WeightedObjective>* aims) {
  aims->clear();
  AddWaypoint(encounter, domain, aims);
  for (const DrawnContact& contact : encounter.contacts) {
    aims->push_back({.weight = WeightOf(contact),
                     .objective = NormaliseTo100({.coupled = CpaOf(contact, domain)}, domain)});
  }
}

void Report(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations());
  state.counters["of_promise"] = benchmark::Counter(
      kPromise_s * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void DecideOn(benchmark::State& state, const std::vector<Encounter>& encounters) {
  const Domain domain;
  std::vector<WeightedObjective> aims;
  size_t next = 0;
  for (auto _ : state) {
    MakeAims(encounters[next++ % encounters.size()], domain, &aims);
    benchmark::DoNotOptimize(Decide(domain, aims));
  }
  Report(state);
}

void WholeDecision(benchmark::State& state) { DecideOn(state, DrawEncounters(state.range(0))); }
BENCHMARK(WholeDecision)->DenseRange(0, 5);

/// All contacts within 30 m.
void CloseQuarters(benchmark::State& state) { DecideOn(state, DrawEncounters(state.range(0), 30)); }
BENCHMARK(CloseQuarters)->Arg(5);

void ByTheRules(benchmark::State& state) {
  struct Met {
    VesselMotion contact = {};
    ColregsState state = {};
    double weight = 0;
  };
  struct Scene {
    const Encounter* encounter = nullptr;
    VesselMotion own = {};
    std::vector<Met> met = {};
  };
  const std::vector<Encounter> encounters = DrawEncounters(state.range(0));
  std::vector<Scene> scenes;
  for (const Encounter& encounter : encounters) {
    Scene scene = {.encounter = &encounter,
                   .own = {.heading_deg = encounter.bearing_deg, .speed_mps = 2}};
    for (const DrawnContact& drawn : encounter.contacts) {
      const VesselMotion contact = {.position_m = drawn.offset_m,
                                    .heading_deg = RadToDeg(HeadingOf(drawn.velocity_mps)),
                                    .speed_mps = drawn.velocity_mps.norm()};
      const ColregsState role = NextColregsState({}, scene.own, contact, kLimits, 0);
      if (role.mode == ColregsMode::kNone) continue;
      scene.met.push_back({.contact = contact, .state = role, .weight = WeightOf(drawn)});
    }
    scenes.push_back(scene);
  }
  const Domain domain;
  std::vector<WeightedObjective> aims;
  size_t next = 0;
  for (auto _ : state) {
    const Scene& scene = scenes[next++ % scenes.size()];
    aims.clear();
    AddWaypoint(*scene.encounter, domain, &aims);
    for (const Met& met : scene.met) {
      aims.push_back(
          {.weight = met.weight,
           .objective = ColregsObjective(met.state, scene.own, met.contact, kPreferences, domain)});
    }
    benchmark::DoNotOptimize(Decide(domain, aims));
  }
  Report(state);
}
BENCHMARK(ByTheRules)->DenseRange(1, 5, 2);

void MakeFunctions(benchmark::State& state) {
  const std::vector<Encounter> encounters = DrawEncounters(state.range(0));
  const Domain domain;
  std::vector<WeightedObjective> aims;
  size_t next = 0;
  for (auto _ : state) {
    MakeAims(encounters[next++ % encounters.size()], domain, &aims);
    benchmark::DoNotOptimize(aims.data());
  }
  Report(state);
}
BENCHMARK(MakeFunctions)->Arg(0)->Arg(5);

void ExplainDecision(benchmark::State& state) {
  const std::vector<Encounter> encounters = DrawEncounters(state.range(0));
  const Domain domain;
  std::vector<WeightedObjective> aims;
  MakeAims(encounters[0], domain, &aims);
  const GridDecision decision = Decide(domain, aims);
  for (auto _ : state) benchmark::DoNotOptimize(Explain(domain, aims, decision));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(ExplainDecision)->Arg(5);

/// Every function at every point, without virtual calls.
void Dense(benchmark::State& state) {
  const std::vector<Encounter> encounters = DrawEncounters(state.range(0));
  const Domain domain;
  const auto num_speeds = static_cast<size_t>(domain.speed_mps.count);
  std::vector<double> sums(Domain::kNumCourses * num_speeds);
  std::vector<double> values(sums.size());
  std::vector<WeightedObjective> waypoint;
  size_t next = 0;
  for (auto _ : state) {
    const Encounter& encounter = encounters[next++ % encounters.size()];
    waypoint.clear();
    AddWaypoint(encounter, domain, &waypoint);
    const Objective& toward = waypoint.front().objective;
    for (size_t i = 0; i < sums.size(); ++i) {
      sums[i] = 100 * toward.scale * (toward.course[i / num_speeds] + toward.speed[i % num_speeds]);
    }
    for (const DrawnContact& contact : encounter.contacts) {
      const CpaGrid cpa(contact.offset_m, contact.velocity_mps, 120, domain);
      size_t point = 0;
      for (int course = 0; course < Domain::kNumCourses; ++course) {
        for (int speed = 0; speed < domain.speed_mps.count; ++speed) {
          values[point++] = UtilityOfCpa(cpa.At(course, speed), kUtility);
        }
      }
      const auto [min, max] = std::minmax_element(values.begin(), values.end());
      const double low = *min;
      const double factor = *max > low ? WeightOf(contact) * 100 / (*max - low) : 0;
      for (size_t i = 0; i < sums.size(); ++i) sums[i] += factor * (values[i] - low);
    }
    benchmark::DoNotOptimize(std::max_element(sums.begin(), sums.end()));
  }
  Report(state);
}
BENCHMARK(Dense)->Arg(0)->Arg(1)->Arg(5);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
