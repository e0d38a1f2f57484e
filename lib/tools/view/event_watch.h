// Finds the events of a mission: what its vehicles did, what became of their messages, their
// encounters, what went wrong (docs/extending/viewer_protocol.md).
//
//   EventWatch watch({{"alpha", 3}, {"bravo", 3}});
//   watch.OnNav(0, utime, x_m, y_m, z_m);
//   watch.OnFate(0, 1, Cause::kDelivered, utime);
//
// The parts are independent: positions, helms and fates may each be left out.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/tools/view/fate_facts.h"
#include "lib/tools/view/plan_watch.h"
#include "lib/vehicle/vehicle/collision_watch.h"
#include "lib/vehicle/vehicle/grounding_watch.h"
#include "shoal/helm_command_t.hpp"
#include "shoal/helm_decision_t.hpp"
#include "shoal/helm_state_t.hpp"
#include "shoal/navigation_t.hpp"

namespace shoal {

struct Mission;
struct MissionVerdict;

enum class EventKind : uint8_t {
  kCollision,
  kAground,
  kAllStop,
  kCleared,
  kFirstContact,
  kLostContact,
  kContactAgain,
  kWaypoint,
  kDeployed,
  kParked,
  kTask,
  kMessage,
  kMessageLost,
  kSurfaced,
  kFix,
  kRole,
  kReplanned,
  kMission,
  kMet,
  kMissed,
};
[[nodiscard]] std::string_view EventKindText(EventKind kind);

struct ViewEvent {
  int64_t utime = 0;
  EventKind kind = EventKind::kCollision;
  std::vector<std::string> vehicles;
  std::string text;
  std::string plan = {};  ///< kReplanned: what PlanWatch returns.
};

/// A vehicle that can collide.
struct WatchedVehicle {
  std::string name;
  double length_m = 0;
  /// 0: it dives. Absent: it cannot run aground.
  std::optional<double> draught_m = {};
  PlanWatch plan = {};
};

/// Returns the vehicles of a mission, in its order.
[[nodiscard]] std::vector<WatchedVehicle> WatchedVehiclesOf(const Mission& mission);

/// Returns the [[event]]s of a mission, in order of time.
[[nodiscard]] std::vector<ViewEvent> PlannedEventsOf(const Mission& mission);

/// Returns an event for each expectation, met or missed, at the end of the mission.
[[nodiscard]] std::vector<ViewEvent> EventsOf(const MissionVerdict& verdict, int64_t start_utime);

class EventWatch {
 public:
  static constexpr size_t kMaxEvents = 20'000;
  static constexpr size_t kMaxArrivals = 3'000;  ///< Of them; a fleet must not crowd out the rest.
  static constexpr size_t kMaxOfKind = 1'000;    ///< Tasks, fates of messages, roles: each.
  static constexpr double kLeastSilence_s = 10;
  static constexpr size_t kMaxNames = 1000;  ///< Vehicles whose contacts are watched.

  /// Vehicles of OnNav and OnHelm are numbers in this list.
  explicit EventWatch(std::vector<WatchedVehicle> vehicles, std::vector<ViewEvent> planned = {});

  /// Takes a position. When one of a later time comes, those of equal times have been compared:
  /// nearer than the mean of their lengths is a collision, once until they were twice as far apart.
  /// `altitude_m` above the floor, negative: not known; of its draught or less it is aground.
  void OnNav(size_t vehicle, int64_t utime, double x_m, double y_m, double z_m,
             double altitude_m = -1);
  /// Takes what HELM_STATE states.
  void OnHelm(size_t vehicle, const helm_state_t& helm);
  /// Takes what HELM_DECISION states: parts toward contacts, and updates that move behaviors.
  void OnDecision(size_t vehicle, const helm_decision_t& decision);
  /// Takes an order to a helm: `move` of a task, where the helm takes it.
  void OnCommand(size_t vehicle, const helm_command_t& command, int64_t utime);
  /// Takes what NAVIGATION states: GPS.
  void OnNavigation(size_t vehicle, const navigation_t& navigation);
  /// Takes the fate of a message of a vehicle; numbers as those of OnFate.
  void OnMessage(int32_t from, int32_t to, const FateView& fate);
  /// Takes a fate of two vehicles (`utime` within kFarthest_us), by any numbers that stand for
  /// their names until the end.
  void OnFate(int32_t from, int32_t to, Cause cause, int64_t utime) {
    if (utime >= next_loss_utime_) FindLosses(utime);
    if (IsReceived(cause)) OnDelivery(from, to, utime);
  }
  /// Takes the time, as OnFate does too: contacts are lost by silence.
  void OnTime(int64_t utime) {
    if (utime >= next_loss_utime_) FindLosses(utime);
    if (next_planned_ < planned_.size() && utime >= planned_[next_planned_].utime) {
      TakePlanned(utime);
    }
  }
  /// Compares the last positions; for the end of a log.
  void Finish() { CompareAll(); }
  /// The rule in force: a contact is lost after the longer of kLeastSilence_s and twice this.
  void SetStaleTime(double stale_time_s);
  /// Sets the name of a vehicle of OnFate, before its first fate.
  void SetName(int32_t number, std::string_view name);
  /// Numbers below this have a name; at first those of the constructor.
  size_t num_names() const { return names_.size(); }

  /// What was found, in the order in which it was noticed: a loss of contact is noticed later than
  /// it was.
  const std::vector<ViewEvent>& events() const { return events_; }
  int64_t num_left_out() const { return num_left_out_; }

 private:
  enum class Contact : uint8_t { kNone, kNow, kLost };
  static constexpr size_t kNumKindsOfEvents = static_cast<size_t>(EventKind::kMissed) + 1;
  static constexpr size_t kMaxParts = 50;
  /// A vehicle's part toward a contact.
  struct Part {
    std::string contact = {};
    std::string role = {};
    int64_t utime = 0;  ///< Of the last decision that named it.
  };
  struct Pair {
    int64_t received_utime = 0;
    Contact contact = Contact::kNone;
  };

  void WatchStop(size_t vehicle, const helm_state_t& helm);
  void WatchArrival(size_t vehicle, const helm_state_t& helm);
  void WatchTask(size_t vehicle, const helm_state_t& helm);
  void AddPlan(size_t vehicle, int64_t utime, const std::string& what, std::string plan);
  void WatchSurface(size_t vehicle, int64_t utime, double z_m);
  void TakePlanned(int64_t utime);
  /// AddEvent, for at most kMaxOfKind of the kind.
  void AddOneOfMany(int64_t utime, EventKind kind, std::vector<std::string> vehicles,
                    std::string text);
  void CompareAll();
  void OnDelivery(int32_t from, int32_t to, int64_t utime);
  void FindLosses(int64_t utime);
  void AddEvent(int64_t utime, EventKind kind, std::vector<std::string> vehicles, std::string text);
  std::string NameOf(int32_t number) const;

  std::vector<WatchedVehicle> vehicles_;
  std::vector<Eigen::Vector3d> positions_m_;
  std::vector<uint32_t> seen_;  ///< Vehicles that have a position at nav_utime_.
  int64_t nav_utime_ = 0;
  CollisionWatch collisions_;
  GroundingWatch groundings_;
  std::vector<helm_state_t> helms_;           ///< As they last were.
  std::vector<bool> is_deep_;                 ///< Those that dive: they were below the surface.
  std::vector<std::optional<bool>> has_fix_;  ///< By NAVIGATION; absent: it has not come.
  std::vector<std::vector<Part>> parts_;      ///< Of each vehicle.
  std::array<size_t, kNumKindsOfEvents> num_of_kind_ = {};
  std::vector<ViewEvent> planned_;
  size_t next_planned_ = 0;
  size_t num_arrivals_ = 0;
  std::vector<std::string> names_;  ///< Of OnFate's numbers.
  std::vector<Pair> pairs_;         ///< Of a < b at b * (b - 1) / 2 + a.
  int64_t silence_us_ = 10'000'000;
  int64_t next_loss_utime_ = 2 * kFarthest_us;  ///< No contact is lost before.
  std::vector<ViewEvent> events_;
  int64_t num_left_out_ = 0;
};

}  // namespace shoal
