// What each table of a mission file holds: keys, ranges and what must fit together. Used to read
// (TableReader) and to write (TableWriter), so that the two cannot differ.
//
// To add a block, say [netsim]:
//   1. mission.h: a struct with its defaults, and a member of Mission;
//   2. a file describe_netsim.cc: void Describe(Fields&, NetsimOptions&), one line per key;
//   3. here its declaration, and one line in Describe(Fields&, Mission&):
//        file.Below("netsim", [&](Fields& fields) { Describe(fields, mission.netsim); });
//   4. docs/mission_file.md: its keys (a test tells which are missing there).
// Reading, unknown keys, suggestions, overrides, templates, --explain follow from these.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/acoustics/channel_plan.h"
#include "lib/mission/fields.h"
#include "lib/mission/mission.h"
#include "lib/routing/control.h"

namespace shoal {

/// Nothing of a mission lies farther from its origin, in x or y.
constexpr double kFarthest_m = 1e6;
/// No speed of a mission is higher.
constexpr double kFastest_mps = 50;
/// No mission is longer: 115 days.
constexpr double kLongest_s = 1e7;

/// The whole file but its templates and fleets (expand.h).
void Describe(Fields& file, Mission& mission);

/// [environment]. The seed and the path of `mission` are known.
void DescribeEnvironment(Fields& file, Mission& mission);

/// [comms].
void Describe(Fields& fields, RoutingRules& rules);
/// The value of a rule that can change while a mission runs, under `key`.
void DescribeControlValue(Fields& fields, std::string_view key, const ControlRow& row,
                          double& value);

/// [acoustics] of a network of `nodes`. A modem's file is looked for in `folder` and among those
/// that come with shoal; where there is no folder, a modem must be a table.
void Describe(Fields& fields, Acoustics& acoustics, const std::optional<std::string>& folder,
              const std::vector<AcousticNode>& nodes);
/// [acoustics] of a whole file. The vehicles and the rules of `mission` are known.
void DescribeAcoustics(Fields& file, Mission& mission);
/// Refuses, in [comms], traffic over an acoustic network that the file does not describe and whose
/// defaults do not fit the vehicles of `mission`.
void CheckTrafficOverWater(Fields& comms, const Mission& mission);
/// Refuses, in [comms], reports that the modem's packets cannot hold; warns of vehicles whose own
/// reports overlap in the water, and of those that report in step with each other and so are not
/// heard. All else of `mission` is known.
void CheckReportsOverWater(Fields& file, const Mission& mission);
/// Gives an acoustic address to the vehicles that name none, and refuses what is not unique.
void CheckAcousticAddresses(Fields& file, Mission& mission);

/// One [[vehicle]], or a template, whose name is empty.
void Describe(Fields& fields, Vehicle& vehicle);

/// One [[vehicle.task]] of a vehicle that starts at `start`.
void Describe(Fields& fields, Task& task, const StartPose& start);
/// [vehicle.return]; without a point it is the start position.
void Describe(Fields& fields, ReturnTask& task, const StartPose& start);

/// The same for tasks of underwater vehicles.
void Describe(Fields& fields, PathFollowTask& task, const StartPose& start);
void Describe(Fields& fields, TargetTrackTask& task, const StartPose& start);
/// [vehicle.sensors] and [vehicle.sonar].
void DescribeInstruments(Fields& fields, Vehicle& vehicle);
/// [vehicle.remus100].
void Describe(Fields& fields, Remus100Options& options);
/// Refuses what only underwater vehicles can do where a vehicle is none, and target_track tasks of
/// vehicles that are not there. All vehicles of `mission` are known.
void CheckUnderwaterTasks(Fields& file, Mission& mission);

/// [swarm]. The vehicles and the acoustic network of `mission` are known. Followers that it does
/// not name are those whose tasks follow the leader by the acoustic network.
void DescribeSwarm(Fields& file, Mission& mission);
/// Makes the leader of [swarm] one of the acoustic network too, before that is looked at.
void MarkSwarmLeader(Fields& file, Mission& mission);
/// [vehicle.recovery].
void Describe(Fields& fields, RecoveryPlan& plan);

/// [netsim]. The vehicles and the acoustic network of `mission` are known.
void DescribeNetsim(Fields& file, Mission& mission);

/// One [[event]]. The vehicles, tasks and duration of `mission` are known.
void Describe(Fields& fields, Event& event, const Mission& mission);
/// One [[expect]], likewise.
void Describe(Fields& fields, Expectation& expectation, const Mission& mission);

/// Warns of tasks behind one that never ends, where no event starts them.
void WarnOfIdleTasks(Fields& file, const Mission& mission);

/// Refuses the name under `key` where no vehicle of `mission` has it; else writes it as the
/// vehicle's table does. "all" is left alone where `or_all`.
void ResolveVehicle(Fields& fields, std::string_view key, std::string& name, const Mission& mission,
                    bool or_all);

/// Returns the named vehicle, or all of them.
std::vector<const Vehicle*> VehiclesNamed(const Mission& mission, std::string_view name_or_all);

}  // namespace shoal
