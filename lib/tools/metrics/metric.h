// A number that a trial of a campaign yields, as data. docs/campaigns/metrics.md documents each
// kind.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "lib/comms/routing/fate.h"

namespace shoal {

enum class MetricKind {
  kDeliveryRatio,      ///< Of a link, a group or all: delivered of all decisions.
  kInformationAge,     ///< Of what `vehicle` knows of `to`.
  kClosestApproach,    ///< Of `vehicle` to `to`, in three dimensions.
  kFormationError,     ///< Of a follower: to the distances that it should keep to its target.
  kDistanceTravelled,  ///< By `vehicle`.
  kArrivalTime,        ///< Of `vehicle` at a point.
  kEnergy,             ///< Of `vehicle`'s propulsion.
  kField,              ///< Any field of any channel.
};

/// How a series of values becomes one.
enum class Reduction { kMin, kMax, kMean, kPercentile, kLast };

/// What an age of information is about.
enum class AgeSource {
  kAuto,     ///< Contacts where the mission has a [swarm], else node reports.
  kSwarm,    ///< Contacts of SWARM_<V>.
  kReports,  ///< Node reports that NODE_REPORT_<V> brought.
};

struct MetricSpec {
  std::string name;
  MetricKind kind = MetricKind::kField;
  /// Of delivery ratios. Absent: messages of the swarm.
  std::optional<Kind> traffic = Kind::kReport;
  std::string vehicle = "all";  ///< A name, "group:NAME" or "all".
  std::string from = "all";     ///< Likewise.
  std::string to = "all";       ///< Likewise.
  AgeSource source = AgeSource::kAuto;
  std::string channel = {};  ///< "NAV_ALPHA".
  std::string field = {};    ///< "z_m", "contacts[0].x_m".
  Reduction reduction = Reduction::kMean;
  double percentile = 95;                                 ///< Of kPercentile: (0, 100].
  double from_s = 0;                                      ///< What was before is left out.
  std::optional<Eigen::Vector2d> point_m = std::nullopt;  ///< Absent: the vehicle's return point.
  double within_m = 20;
  bool stays = false;  ///< Of arrivals: there from then on to the end.

  bool operator==(const MetricSpec&) const = default;
};

/// A metric as results name it.
struct MetricName {
  std::string name;  ///< "closest_m"; of expectations "expect_1".
  std::string unit;  ///< "m", "s", "%", ""; for axes and tables.
  std::string text;  ///< What it is, in one line: "no two vehicles closer than 5 m".

  bool operator==(const MetricName&) const = default;
};

}  // namespace shoal
