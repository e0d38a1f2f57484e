#include "lib/run/verdict/expectation_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/fate.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

std::string VehicleText(std::string_view vehicle) {
  return VehicleKey(vehicle) == "all" ? "every vehicle" : std::string(vehicle);
}

std::string From(double from_s) { return from_s > 0 ? fmt::format(" from {:g} s on", from_s) : ""; }

struct Describer {
  const Mission& mission;

  std::string operator()(const ArrivalExpectation& arrival) const {
    return fmt::format(
        "{} within {:g} m of {} by {:g} s{}", VehicleText(arrival.vehicle), arrival.within_m,
        arrival.point_m ? fmt::format("({:g}, {:g})", arrival.point_m->x(), arrival.point_m->y())
                        : std::string("its return point"),
        LimitSeconds(mission, arrival.by_s), arrival.stays ? ", and stays there" : "");
  }
  std::string operator()(const SeparationExpectation& separation) const {
    return fmt::format("no two vehicles closer than {:g} m", separation.min_m);
  }
  std::string operator()(const CommsExpectation& comms) const {
    std::vector<std::string> limits;
    if (comms.at_least) limits.push_back(fmt::format("at least {}", *comms.at_least));
    if (comms.at_most) limits.push_back(fmt::format("at most {}", *comms.at_most));
    if (comms.at_least_pct) limits.push_back(fmt::format("at least {:g} %", *comms.at_least_pct));
    if (comms.at_most_pct) limits.push_back(fmt::format("at most {:g} %", *comms.at_most_pct));
    const bool ends_with_share = comms.at_least_pct || comms.at_most_pct;
    return fmt::format("{}{} {}s {} from {} to {}", fmt::join(limits, " and "),
                       ends_with_share ? " of" : "", KindText(comms.kind), comms.cause, comms.from,
                       comms.to);
  }
  std::string operator()(const SwarmExpectation& swarm) const {
    std::vector<std::string> limits;
    if (swarm.at_least_pct) limits.push_back(fmt::format("at least {:g} %", *swarm.at_least_pct));
    if (swarm.at_most_pct) limits.push_back(fmt::format("at most {:g} %", *swarm.at_most_pct));
    return fmt::format("{} of swarm messages from {} {} at {}", fmt::join(limits, " and "),
                       swarm.from, swarm.outcome, swarm.to);
  }
  std::string operator()(const HelmExpectation& helm) const {
    return fmt::format("{} ends in {}{}", VehicleText(helm.vehicle),
                       helm.state.empty() ? "any state" : helm.state,
                       helm.task.empty() ? "" : " with task " + helm.task);
  }
  std::string operator()(const LapsExpectation& laps) const {
    return fmt::format("{} does at least {} lap{} of {} by {:g} s", VehicleText(laps.vehicle),
                       laps.at_least, laps.at_least == 1 ? "" : "s", laps.task,
                       LimitSeconds(mission, laps.by_s));
  }
  std::string operator()(const TrackExpectation& track) const {
    return fmt::format("{} at most {:g} m off its track{}", VehicleText(track.vehicle), track.max_m,
                       From(track.from_s));
  }
  std::string operator()(const DistanceExpectation& distance) const {
    std::vector<std::string> limits;
    if (distance.min_m) limits.push_back(fmt::format("at least {:g} m", *distance.min_m));
    if (distance.max_m) limits.push_back(fmt::format("at most {:g} m", *distance.max_m));
    return fmt::format("{} {} from {}{}", VehicleText(distance.vehicle), fmt::join(limits, " and "),
                       VehicleText(distance.to), From(distance.from_s));
  }
  std::string operator()(const ClosestApproachExpectation& approach) const {
    return fmt::format("encounters of {} with {} not closer than {:g} m",
                       VehicleText(approach.vehicle), VehicleText(approach.to),
                       approach.at_least_m);
  }
  std::string operator()(const EncounterScoreExpectation& score) const {
    return fmt::format("encounters of {} with {} score at least {:g}{}", VehicleText(score.vehicle),
                       VehicleText(score.to), score.at_least,
                       score.role.empty() ? "" : ", all as " + score.role);
  }
  std::string operator()(const AltitudeExpectation& altitude) const {
    return fmt::format("{} at least {:g} m above the sea floor", VehicleText(altitude.vehicle),
                       altitude.min_m);
  }
  std::string operator()(const NavigationErrorExpectation& error) const {
    return fmt::format("{} at most {:g} m from where it believes to be{}",
                       VehicleText(error.vehicle), error.max_m, From(error.from_s));
  }
  std::string operator()(const CoverageExpectation& coverage) const {
    const bool by_all = coverage.vehicles.empty();
    return fmt::format("at least {:g} % of the {} covered {:g} m wide{}{}", coverage.at_least_pct,
                       coverage.polygon_m.empty() ? "surveyed area" : "polygon",
                       coverage.sensor_width_m, by_all ? "" : " by ",
                       fmt::join(coverage.vehicles, ", "));
  }
};

struct UnitFinder {
  template <class Metres>
  std::string_view operator()(const Metres& /*what*/) const {
    return "m";
  }
  std::string_view operator()(const ArrivalExpectation& /*arrival*/) const { return "s"; }
  std::string_view operator()(const CommsExpectation& comms) const {
    return comms.at_least_pct || comms.at_most_pct ? "%" : "";
  }
  std::string_view operator()(const SwarmExpectation& /*swarm*/) const { return "%"; }
  std::string_view operator()(const CoverageExpectation& /*coverage*/) const { return "%"; }
  std::string_view operator()(const LapsExpectation& /*laps*/) const { return "laps"; }
  std::string_view operator()(const HelmExpectation& /*helm*/) const { return ""; }
  std::string_view operator()(const EncounterScoreExpectation& /*score*/) const { return ""; }
};

struct MarginFinder {
  const Mission& mission;
  double value;

  using Margin = std::optional<double>;

  template <class T, class U>
  Margin Between(const std::optional<T>& least, const std::optional<U>& most) const {
    Margin margin;
    if (least) margin = value - static_cast<double>(*least);
    if (most) {
      const double below = static_cast<double>(*most) - value;
      margin = margin ? std::min(*margin, below) : below;
    }
    return margin;
  }
  Margin operator()(const ArrivalExpectation& arrival) const {
    return LimitSeconds(mission, arrival.by_s) - value;
  }
  Margin operator()(const SeparationExpectation& separation) const {
    return value - separation.min_m;
  }
  Margin operator()(const CommsExpectation& comms) const {
    if (comms.at_least_pct || comms.at_most_pct) {
      // The number is the share; a limit of the count beside it has none of its own.
      return Between(comms.at_least_pct, comms.at_most_pct);
    }
    return Between(comms.at_least, comms.at_most);
  }
  Margin operator()(const SwarmExpectation& swarm) const {
    return Between(swarm.at_least_pct, swarm.at_most_pct);
  }
  Margin operator()(const HelmExpectation& /*helm*/) const { return std::nullopt; }
  Margin operator()(const LapsExpectation& laps) const {
    return value - static_cast<double>(laps.at_least);
  }
  Margin operator()(const TrackExpectation& track) const { return track.max_m - value; }
  Margin operator()(const DistanceExpectation& distance) const {
    return Between(distance.min_m, distance.max_m);
  }
  Margin operator()(const AltitudeExpectation& altitude) const { return value - altitude.min_m; }
  Margin operator()(const NavigationErrorExpectation& error) const { return error.max_m - value; }
  Margin operator()(const ClosestApproachExpectation& approach) const {
    return value - approach.at_least_m;
  }
  Margin operator()(const EncounterScoreExpectation& score) const { return value - score.at_least; }
  Margin operator()(const CoverageExpectation& coverage) const {
    return value - coverage.at_least_pct;
  }
};

}  // namespace

std::optional<double> MarginOf(const Mission& mission, const Expectation& expectation,
                               std::optional<double> value) {
  if (!value) return std::nullopt;
  return std::visit(MarginFinder{mission, *value}, expectation.what);
}

std::string Describe(const Mission& mission, const Expectation& expectation) {
  return std::visit(Describer{mission}, expectation.what);
}

std::string_view UnitOf(const Expectation& expectation) {
  return std::visit(UnitFinder(), expectation.what);
}

double LimitSeconds(const Mission& mission, double by_s) {
  return by_s > 0 ? by_s : mission.duration_s;
}

}  // namespace shoal
