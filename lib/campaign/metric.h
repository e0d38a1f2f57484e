// A number that a trial of a campaign yields, as data. docs/campaign_metrics.md documents each kind.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "lib/routing/fate.h"

namespace shoal {

enum class MetricKind {
  kDeliveryRatio,      ///< Of a link, a group or all: delivered of all decisions.
  kInformationAge,     ///< Of what `vehicle` knows of `to`.
  kClosestApproach,    ///< Of `vehicle` to `to`, in three dimensions.
  kFormationError,     ///< Of a follower: to the place that it should hold.
  kDistanceTravelled,  ///< By `vehicle`.
  kArrivalTime,        ///< Of `vehicle` at a point.
  kEnergy,             ///< Of `vehicle`'s propulsion.
  kField,              ///< Any field of any channel.
};

/// How a series of values becomes one.
enum class Reduction { kMin, kMax, kMean, kPercentile, kLast };

struct MetricSpec {
  std::string name;
  MetricKind kind = MetricKind::kField;
  Kind traffic = Kind::kReport;   ///< Of delivery ratios.
  std::string vehicle = "all";    ///< A name or "all".
  std::string from = "all";       ///< A name, "group:NAME" or "all".
  std::string to = "all";         ///< Likewise.
  std::string channel;            ///< "NAV_ALPHA".
  std::string field;              ///< "depth_m", "contacts[0].x_m".
  Reduction reduction = Reduction::kMean;
  double percentile = 95;         ///< Of kPercentile: 0 to 100.
  double from_s = 0;              ///< Values before are left out.
  std::optional<Eigen::Vector2d> point_m = std::nullopt;  ///< Absent: the vehicle's return point.
  double within_m = 20;
};

}  // namespace shoal
