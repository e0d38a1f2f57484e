// What each table of a mission file holds: keys, ranges and what must fit together within it. Used
// to read (TableReader) and to write (TableWriter), so that the two cannot differ.
//
// To add a block, for example [netsim]:
//   1. mission.h: a struct with its defaults, and a member of Mission;
//   2. a file describe_netsim.cc: void Describe(Fields&, NetsimOptions&), one line per key;
//   3. here its declaration, and one line in Describe(Fields&, Mission&):
//        file.Below("netsim", [&](Fields& fields) { Describe(fields, mission.netsim); });
//   4. where it names vehicles or depends on other tables: a check in validate.h;
//   5. docs/missions/mission_file.md: its keys (a test shows which are missing there).
// Reading, unknown keys, suggestions, overrides, templates, --explain follow from these.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/control.h"
#include "lib/mission/model/mission.h"
#include "lib/mission/toml/fields.h"

namespace shoal {

/// Nothing of a mission lies farther from its origin, in x or y.
constexpr double kFarthest_m = 1e6;
/// No speed of a mission is higher.
constexpr double kFastest_mps = 50;
/// No mission is longer: 115 days.
constexpr double kLongest_s = 1e7;

/// The whole file but its templates and fleets (expand.h), every table by itself; what spans tables
/// is checked afterwards (validate.h). `mission.file` is set: modems are looked for beside it.
void Describe(Fields& file, Mission& mission);

/// [environment].
void Describe(Fields& fields, Environment& environment);

/// One [[medium]]; a modem's file is looked for in `folder` as that of [acoustics].
void Describe(Fields& fields, MediumOptions& medium, const std::optional<std::string>& folder);
/// A medium, or a list of media in order of preference.
void DescribeMedia(Fields& fields, std::string_view key, MediaChoice& choice);
/// What a vehicle has of them: media, antenna_height_m and [vehicle.gateway].
void Describe(Fields& fields, VehicleMedia& media);

/// [comms].
void Describe(Fields& fields, RoutingRules& rules);
/// The value of a rule that can change while a mission runs, under `key`.
void DescribeControlValue(Fields& fields, std::string_view key, const ControlRow& row,
                          ControlValue& value);

/// [acoustics]. A modem's file is looked for in `folder` and among those that come with shoal;
/// where there is no folder, a modem must be a table.
/// `default_modem`: the modem where the table names none and no model of loss or bit errors; empty:
/// none.
void Describe(Fields& fields, Acoustics& acoustics, const std::optional<std::string>& folder,
              std::string_view default_modem = "");

/// [acoustics.channel], or that of a medium. `wind_mps`: of the sea, unless the table has its own.
void Describe(Fields& fields, std::optional<RayChannelOptions>& rays, double wind_mps,
              const std::optional<std::string>& folder);

/// [environment.floor].
void Describe(Fields& fields, FloorOptions& floor);

/// One [[vehicle]], or a template, whose name is empty. A model's own table is declared beside its
/// parameters (remus100_model.h).
void Describe(Fields& fields, Vehicle& vehicle);
/// [vehicle.autopilot], by the model of the vehicle.
void DescribeAutopilot(Fields& fields, Vehicle& vehicle);
/// [vehicle.sensors] and [vehicle.sonar].
void DescribeInstruments(Fields& fields, Vehicle& vehicle);
/// [vehicle.navigation], after [vehicle.sensors].
void DescribeNavigation(Fields& fields, Vehicle& vehicle);
/// One [[beacon]].
void Describe(Fields& fields, BeaconOptions& beacon);
/// [vehicle.recovery].
void Describe(Fields& fields, RecoveryPlan& plan);

/// One [[vehicle.task]] of a vehicle that starts at `start`.
void Describe(Fields& fields, Task& task, const StartPose& start);
/// [vehicle.return]; without a point it is the start position.
void Describe(Fields& fields, ReturnTask& task, const StartPose& start);
/// The same for tasks of underwater vehicles.
void Describe(Fields& fields, PathFollowTask& task, const StartPose& start);
void Describe(Fields& fields, TargetTrackTask& task, const StartPose& start);
void Describe(Fields& fields, SurfaceTask& task, const StartPose& start);
void Describe(Fields& fields, SurfaceForFixTask& task, const StartPose& start);
/// The same for surveys. One that is refused has no corners.
void Describe(Fields& fields, SurveyTask& task, const StartPose& start);

/// One [[vehicle.behavior]].
void Describe(Fields& fields, BehaviorOptions& options);
/// The keys of it that all kinds have and an update may change, and those of its kind.
void DescribeCommon(Fields& fields, BehaviorOptions& options);
void DescribeKindOf(Fields& fields, BehaviorOptions& options);
/// One [[vehicle.mode]].
void Describe(Fields& fields, ModeOptions& mode);
/// [vehicle.variables].
void DescribeVariables(Fields& fields, std::map<std::string, VariableValue>& variables);
/// [vehicle.domain].
void Describe(Fields& fields, Domain& domain);
/// One [[obstacle]].
void Describe(Fields& fields, Obstacle& obstacle);

/// [swarm], or each [[swarm]].
void DescribeSwarms(Fields& file, std::vector<SwarmOptions>& swarms);

/// [netsim].
void Describe(Fields& fields, NetsimOptions& options);

/// One [[event]] of a mission that ends at `end_s`.
void Describe(Fields& fields, Event& event, double end_s);
void Describe(Fields& fields, NamedOrder& order);
/// One [[expect]], likewise.
void Describe(Fields& fields, Expectation& expectation, double end_s);

}  // namespace shoal
