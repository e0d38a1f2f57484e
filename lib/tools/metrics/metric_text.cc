#include "lib/tools/metrics/metric_text.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/model/names.h"
#include "lib/tools/metrics/metric_vehicles.h"

namespace shoal {

namespace {

std::string VehiclesText(std::string_view addressees) {
  if (VehicleKey(addressees) == "all") return "every vehicle";
  if (const auto group = GroupNamed(addressees)) return fmt::format("group {}", *group);
  return std::string(addressees);
}

std::string ReductionText(const MetricSpec& spec) {
  switch (spec.reduction) {
    case Reduction::kMin:
      return "least";
    case Reduction::kMax:
      return "largest";
    case Reduction::kMean:
      return "mean";
    case Reduction::kPercentile:
      return fmt::format("{:g} % percentile of", spec.percentile);
    case Reduction::kLast:
      break;
  }
  return "last";
}

std::string ArrivalText(const MetricSpec& spec) {
  const std::string point = spec.point_m
                                ? fmt::format("({:g}, {:g})", spec.point_m->x(), spec.point_m->y())
                                : std::string("its return point");
  return fmt::format("time when {} is within {:g} m of {}{}", VehiclesText(spec.vehicle),
                     spec.within_m, point, spec.stays ? " for good" : "");
}

std::string TextWithoutTime(const Mission& mission, const MetricSpec& spec) {
  const std::string vehicle = VehiclesText(spec.vehicle);
  switch (spec.kind) {
    case MetricKind::kDeliveryRatio:
      return fmt::format("{} from {} to {}",
                         spec.traffic ? fmt::format("delivered {}s", KindText(*spec.traffic))
                                      : std::string("applied swarm messages"),
                         VehiclesText(spec.from), VehiclesText(spec.to));
    case MetricKind::kInformationAge:
      return fmt::format("{} age of {} of {} at {}", ReductionText(spec),
                         IsOfSwarm(mission, spec.source) ? "swarm contacts" : "node reports",
                         VehiclesText(spec.to), vehicle);
    case MetricKind::kClosestApproach:
      return fmt::format("least range from {} to {}", vehicle, VehiclesText(spec.to));
    case MetricKind::kFormationError:
      return fmt::format("{} formation error of {}", ReductionText(spec), vehicle);
    case MetricKind::kDistanceTravelled:
      return fmt::format("way of {}", vehicle);
    case MetricKind::kArrivalTime:
      return ArrivalText(spec);
    case MetricKind::kEnergy:
      return fmt::format("propeller shaft work of {}", vehicle);
    case MetricKind::kField:
      break;
  }
  return fmt::format("{} {} of {}", ReductionText(spec), spec.field, spec.channel);
}

std::string UnitOfField(std::string_view field) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kUnits = {{
      {"m", "m"},
      {"km", "km"},
      {"m2", "m2"},
      {"s", "s"},
      {"us", "us"},
      {"mps", "m/s"},
      {"mps2", "m/s2"},
      {"deg", "deg"},
      {"degps", "deg/s"},
      {"rad", "rad"},
      {"radps", "rad/s"},
      {"pct", "%"},
      {"rpm", "rpm"},
      {"hz", "Hz"},
      {"db", "dB"},
  }};
  if (field.ends_with(']')) field = field.substr(0, field.rfind('['));
  const size_t begin = field.find_last_of("_.");
  if (begin == std::string_view::npos || field[begin] == '.') return "";
  for (const auto& [suffix, unit] : kUnits) {
    if (suffix == field.substr(begin + 1)) return std::string(unit);
  }
  return "";
}

}  // namespace

std::string UnitOfMetric(const MetricSpec& spec) {
  switch (spec.kind) {
    case MetricKind::kDeliveryRatio:
      return "%";
    case MetricKind::kInformationAge:
    case MetricKind::kArrivalTime:
      return "s";
    case MetricKind::kClosestApproach:
    case MetricKind::kFormationError:
    case MetricKind::kDistanceTravelled:
      return "m";
    case MetricKind::kEnergy:
      return "J";
    case MetricKind::kField:
      break;
  }
  return UnitOfField(spec.field);
}

std::string DescribeMetric(const Mission& mission, const MetricSpec& spec) {
  std::string text = TextWithoutTime(mission, spec);
  if (spec.from_s > 0) text += fmt::format(" from {:g} s on", spec.from_s);
  return text;
}

}  // namespace shoal
