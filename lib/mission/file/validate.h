// Checks that span tables of a mission file: names are looked up, what is left open is filled in
// from other tables, and what does not fit together is refused. A table by itself is checked where
// it is described (describe.h).
//
//   TableReader reader(root, "the file", problems);
//   Describe(reader, mission);
//   Validate(mission, TablePlace(root, problems));
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/mission/toml/table_place.h"
#include "lib/sea/acoustics/channel_plan.h"

namespace shoal {

struct MediaSetup;

/// Completes `mission`, all of which has been read from `file`, and finds everything that is wrong
/// between its tables. Puts the events in order of time.
void Validate(Mission& mission, const TablePlace& file);

/// Refuses, at its key in [acoustics], what is wrong with a network of `nodes`. Where the file has
/// no such table, all of it is refused at `instead_of_key` of the table `place`.
void ValidateNetwork(const TablePlace& place, const AcousticOptions& options,
                     const std::vector<AcousticNode>& nodes, std::string_view instead_of_key = "");

// The parts of Validate. The first two write into the mission; the others only look at what is
// complete, and may come in any order.

/// Writes names of vehicles as their tables do, and refuses those that no vehicle has.
void ResolveNames(Mission& mission, const TablePlace& file);
/// Gives each member of a divided survey its share, and refuses surveys that cannot be divided so;
/// a part of ResolveNames.
void ResolveSurveyShares(Mission& mission, const TablePlace& file);
/// Gives each random part of a path its stream of the mission's seed: by vehicle, task and place.
void SeedPaths(Mission& mission);
/// Fills in what a table leaves open and another decides: whether there is an acoustic network,
/// acoustic addresses, the leader of the network, the followers of the swarm.
void CompleteMission(Mission& mission, const TablePlace& file);

/// Gives each vehicle the media that its type has, where [[medium]] blocks or gateways exist and
/// its table names none; a part of CompleteMission.
void FillInMedia(Mission& mission, const TablePlace& file);

/// Returns the table of the mission's i-th swarm, [swarm] or one of [[swarm]].
[[nodiscard]] TablePlace TableOfSwarm(const Mission& mission, const TablePlace& file, size_t i);
/// Writes the names in swarms as the vehicles do; a part of ResolveNames.
void ResolveSwarms(Mission& mission, const TablePlace& file);
/// Fills in followers, group_id of several, and that leaders lead the network; a part of
/// CompleteMission.
void FillInSwarms(Mission& mission, const TablePlace& file);

/// Reads the tracks of vehicles of model = "track": refuses those that cannot be read, fills in
/// where they start, warns where a track ends before the mission; a part of CompleteMission.
void FillInTracks(Mission& mission, const TablePlace& file);

/// Names of vehicles and participants; groups.
void ValidateNames(const Mission& mission, const TablePlace& file);
/// Whether [environment] can be made with the mission's seed and folder.
void ValidateEnvironment(const Mission& mission, const TablePlace& file);
/// The acoustic network, its addresses, and what [comms] sends over it.
void ValidateAcoustics(const Mission& mission, const TablePlace& file);
/// Channels of sound with rays.
void ValidateChannels(const Mission& mission, const TablePlace& file);
/// Reports that the modem's packets cannot hold; warns of vehicles whose own reports overlap, and
/// of those that report in step with each other and so are not received.
void ValidateAcousticReports(const Mission& mission, const TablePlace& file);
/// What [[medium]] blocks, [comms], [swarm], vehicles and gateways name, and whether they fit
/// together; warns of vehicles that receive by direct while they dive.
void ValidateMedia(const Mission& mission, const TablePlace& file);
/// The part of it that a text of media has (load_media.h).
void ValidateMedia(const MediaSetup& setup, const TablePlace& file);
/// Refuses, at `key`, each name of a choice that is not one of `media`.
void ValidateChoice(const TablePlace& place, std::string_view key, const MediaChoice& choice,
                    const std::vector<std::string>& media);
/// [swarm], or each [[swarm]] by itself.
void ValidateSwarm(const Mission& mission, const TablePlace& file);
/// Several swarms beside each other; a part of ValidateSwarm, for swarms that are sound.
void ValidateSwarms(const Mission& mission, const TablePlace& file);
void ValidateNetsim(const Mission& mission, const TablePlace& file);
/// Models and tasks of underwater vehicles.
void ValidateUnderwater(const Mission& mission, const TablePlace& file);
/// Paths of path_follow tasks: refuses those that leave the world, warns of what a vehicle, or the
/// duration of the mission, does not allow.
void ValidatePaths(const Mission& mission, const TablePlace& file);
/// Behaviors, modes and obstacles.
void ValidateBehaviors(const Mission& mission, const TablePlace& file);
/// [vehicle.navigation] and [[beacon]].
void ValidateNavigation(const Mission& mission, const TablePlace& file);
/// Names of [[host]] and of what they run; each vehicle and participant runs on one computer.
void ValidateHosts(const Mission& mission, const TablePlace& file);
void ValidateEvents(const Mission& mission, const TablePlace& file);
/// Warns of gains that swing the fins at the mission's ticks.
void WarnOfAutopilots(const Mission& mission, const TablePlace& file);
/// Warns of keys that have no effect beside the others of their vehicle.
void WarnOfIdleKeys(const Mission& mission, const TablePlace& file);
/// Warns of backgrounds that a viewer will not find.
void WarnOfBackgrounds(const Mission& mission, const TablePlace& file);
/// Warns of tasks behind one that never ends, where no event starts them.
void WarnOfIdleTasks(const Mission& mission, const TablePlace& file);
/// Warns of missions in which nothing happens that could be judged, and of vehicles that start in
/// contact.
void WarnOfConduct(const Mission& mission, const TablePlace& file);
/// Returns true where the end of a vehicle's task matters: another comes after it, or it is
/// expected.
bool MustEnd(const Mission& mission, const Vehicle& vehicle, size_t task);
/// Warns of points that cannot be reached in time, speeds that a vehicle does not have, currents
/// that it cannot stem, and reports over media that it does not have.
void WarnOfReach(const Mission& mission, const TablePlace& file);
/// Warns of messages of [[event]] that are too long for every medium on their way.
void WarnOfMessages(const Mission& mission, const TablePlace& file);
/// Warns of behaviors that keep clear of vehicles far above or below.
void WarnOfDivers(const Mission& mission, const TablePlace& file);
void ValidateExpectations(const Mission& mission, const TablePlace& file);

/// Refuses the name under `key` if no vehicle of `mission` has it; else gives it the case of the
/// vehicle's own table. With `or_all` the name "all" is accepted, and not changed.
void ResolveVehicle(const TablePlace& place, std::string_view key, std::string& name,
                    const Mission& mission, bool or_all);

/// The same for a name, "all" or "group:NAME": refuses a group of which there is no vehicle.
void ResolveAddressees(const TablePlace& place, std::string_view key, std::string& name,
                       const Mission& mission);

/// Returns the named vehicle, all of them, or those of "group:NAME".
std::vector<const Vehicle*> VehiclesNamed(const Mission& mission, std::string_view addressees);

}  // namespace shoal
