// [[expect]] as data: one struct for every kind.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lib/comms/routing/fate.h"
#include "lib/helm/encounters/encounter.h"

namespace shoal {

/// `[[expect]]`: what the mission must achieve. `vehicle` may be "all": each of them.
struct ArrivalExpectation {  ///< kind = "arrival"
  std::string vehicle;
  std::optional<Eigen::Vector2d> point_m;  ///< Absent: the vehicle's return point.
  double within_m = 20;
  double by_s = 0;     ///< It is there at some time not later than this ...
  bool stays = false;  ///< ... and from then on to the end.

  bool operator==(const ArrivalExpectation&) const = default;
};
struct SeparationExpectation {  ///< kind = "separation": no two vehicles ever closer.
  double min_m = 0;

  bool operator==(const SeparationExpectation&) const = default;
};
struct CommsExpectation {  ///< kind = "reports", "messages", "acks" or "packets": what became of
                           ///< them.
  Kind kind = Kind::kReport;
  std::string from = "all";
  std::string to = "all";
  std::string cause = "delivered";  ///< A fate's cause.
  std::optional<int64_t> at_least = std::nullopt;
  std::optional<int64_t> at_most = std::nullopt;
  std::optional<double> at_least_pct = std::nullopt;  ///< Of all fates of these links.
  std::optional<double> at_most_pct = std::nullopt;

  bool operator==(const CommsExpectation&) const = default;
};
struct SwarmExpectation {  ///< kind = "swarm": the results of the messages that members received.
  std::string from = "all";
  std::string to = "all";
  std::string outcome = "clean";                      ///< clean, recovered or rejected.
  std::optional<double> at_least_pct = std::nullopt;  ///< Of what was received.
  std::optional<double> at_most_pct = std::nullopt;

  bool operator==(const SwarmExpectation&) const = default;
};
struct HelmExpectation {  ///< kind = "helm": the helm's state at the end.
  std::string vehicle;
  std::string state;  ///< PARK, DRIVE or ALL-STOP; empty: any.
  std::string task;   ///< Name of the running task; empty: any.

  bool operator==(const HelmExpectation&) const = default;
};
struct LapsExpectation {  ///< kind = "laps": a task's points were all passed.
  std::string vehicle;
  std::string task;
  int64_t at_least = 1;
  double by_s = 0;  ///< 0: by the end.

  bool operator==(const LapsExpectation&) const = default;
};
struct TrackExpectation {  ///< kind = "track": the cross-track error stays within a limit.
  std::string vehicle;
  double max_m = 1;
  double from_s = 0;  ///< From then on, while a task runs that has a track.

  bool operator==(const TrackExpectation&) const = default;
};
struct DistanceExpectation {  ///< kind = "distance": to another vehicle, in three dimensions.
  std::string vehicle;
  std::string to;
  std::optional<double> min_m = std::nullopt;
  std::optional<double> max_m = std::nullopt;
  double from_s = 0;

  bool operator==(const DistanceExpectation&) const = default;
};
struct AltitudeExpectation {  ///< kind = "altitude": above the sea floor, at least.
  std::string vehicle;
  double min_m = 0;

  bool operator==(const AltitudeExpectation&) const = default;
};
struct NavigationErrorExpectation {  ///< kind = "navigation_error": of the estimated position.
  std::string vehicle;
  double max_m = 0;   ///< In the horizontal plane.
  double from_s = 0;  ///< From then on.

  bool operator==(const NavigationErrorExpectation&) const = default;
};
struct ClosestApproachExpectation {  ///< kind = "closest_approach": in each encounter, at least.
  std::string vehicle = "all";
  std::string to = "all";
  double at_least_m = 0;
  EncounterOptions encounter = {};

  bool operator==(const ClosestApproachExpectation&) const = default;
};
struct EncounterScoreExpectation {  ///< kind = "encounter_score": of each encounter, at least.
  std::string vehicle = "all";
  std::string to = "all";
  double at_least = 0;  ///< 0 to 100.
  std::string role;     ///< Of the vehicle at entry; empty: any.
  EncounterOptions encounter = {};

  bool operator==(const EncounterScoreExpectation&) const = default;
};
struct CoverageExpectation {  ///< kind = "coverage": an area passes under the vehicles' sensors.
  std::vector<Eigen::Vector2d> polygon_m = {};  ///< Empty: the polygons of their surveys.
  double sensor_width_m = 20;                   ///< Covered: within half of this of a track.
  double at_least_pct = 95;                     ///< Of the area.
  std::vector<std::string> vehicles = {};       ///< Names and "group:NAME"; empty: all.

  bool operator==(const CoverageExpectation&) const = default;
};
struct Expectation {
  std::string where;  ///< "file:line" of its table, for the verdict.
  std::variant<ArrivalExpectation, SeparationExpectation, CommsExpectation, HelmExpectation,
               LapsExpectation, TrackExpectation, DistanceExpectation, AltitudeExpectation,
               SwarmExpectation, ClosestApproachExpectation, EncounterScoreExpectation,
               CoverageExpectation, NavigationErrorExpectation>
      what;

  bool operator==(const Expectation&) const = default;
};

}  // namespace shoal
