// The state of a mission at one moment, as far as its messages show.
//
//   Scene scene(mission);
//   scene.Handle("NAV_ALPHA", bytes);
//   scene.vehicles()[0].nav->x_m;
//
// Copyable. Messages may hold any values: impossible ones are dropped and counted, texts are cut
// (kMaxText), and nothing grows without bound.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/comms/routing/rules.h"
#include "lib/mission/model/mission.h"
#include "lib/tools/view/drawing_book.h"
#include "lib/tools/view/link_book.h"
#include "lib/tools/view/media_links.h"
#include "lib/tools/view/packet_book.h"
#include "lib/tools/view/pulse_book.h"
#include "lib/tools/view/shown_channels.h"
#include "shoal/clock_state_t.hpp"
#include "shoal/helm_command_t.hpp"
#include "shoal/helm_state_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/node_report_t.hpp"
#include "shoal/swarm_t.hpp"

namespace shoal {

/// A node report as the broker knows it.
struct ReceivedReport {
  int64_t utime = 0;           ///< When it was made, by the vehicle.
  int64_t received_utime = 0;  ///< When the scene received it; staleness counts from here.
  double x_m = 0;
  double y_m = 0;
  double depth_m = 0;
  double heading_deg = 0;
  double speed_mps = 0;
  int64_t index = 0;
  std::string mode;
};

struct SceneVehicle {
  std::string name;
  std::string type = {};
  std::string color = {};
  std::string group = {};
  double length_m = 0;
  bool outside = false;  ///< Not of the mission.
  std::optional<nav_t> nav = {};
  std::optional<ReceivedReport> report = {};
  std::optional<helm_state_t> helm = {};
  std::optional<swarm_t> swarm = {};
  ShownMessages shown = {};
};

/// The broker's rules, those of vehicles included.
struct RulesInForce : RoutingRules {
  std::vector<std::pair<std::string, LinkFactors>> factors;  ///< Of vehicles that have not 1 and 1.
  std::vector<std::string> strange;  ///< A line for each rule of another version, StrangeRules().
};

/// Receives what Scene::Handle has decoded, after the scene has taken it. Vehicles are indices in
/// Scene::vehicles().
class SceneObserver {
 public:
  virtual ~SceneObserver() = default;
  virtual void OnNav(size_t /*vehicle*/, const nav_t& /*nav*/) {}
  virtual void OnHelm(size_t /*vehicle*/, const helm_state_t& /*helm*/) {}
  virtual void OnReport(size_t /*vehicle*/, const ReceivedReport& /*report*/) {}
  virtual void OnDecision(size_t /*vehicle*/, const helm_decision_t& /*decision*/) {}
  virtual void OnCommand(size_t /*vehicle*/, const helm_command_t& /*command*/) {}
  virtual void OnNavigation(size_t /*vehicle*/, const navigation_t& /*navigation*/) {}
  virtual void OnFate(const FateView& /*fate*/, const LinkPlace& /*place*/) {}
  /// What COMMS_MEDIA has of a fate that OnFate was called for.
  virtual void OnMedium(const FateView& /*medium*/) {}
};

class Scene {
 public:
  static constexpr size_t kMaxOutside = 200;   ///< Vehicles from outside; more are counted.
  static constexpr size_t kMaxText = 200;      ///< Bytes of any text that is kept.
  static constexpr size_t kMaxContacts = 300;  ///< Of a swarm's knowledge.

  /// Begins with the mission's vehicles, in its order, and its rules.
  explicit Scene(const Mission& mission);

  /// Takes one encoded message. Channels: NAV_V, HELM_STATE_V, HELM_COMMAND_V, SWARM_V and those of
  /// shown_channels.h of the mission's vehicles, NODE_REPORT_LOCAL, NODE_REPORT, COMMS_FATES,
  /// COMMS_MEDIA, COMMS_RULES, VIEW_COMMS_PULSE, those of DrawingBook; all others are ignored.
  void Handle(std::string_view channel, std::span<const uint8_t> data,
              SceneObserver* observer = nullptr);
  /// Takes the time of the clock's last step.
  void HandleClock(const clock_state_t& clock);
  /// Sets the time to show, where the caller knows it better than the messages; the next one that
  /// is later, or much earlier, moves it again.
  void SetNow(int64_t utime) { now_utime_ = PlausibleUtime(utime); }
  /// The rules are unknown until COMMS_RULES states them.
  void ForgetRules() { rules_.reset(); }
  /// Goes on from counters that were copied at this time.
  void SetLinks(LinkBook links, MediaLinks media_links) {
    links_ = std::move(links);
    media_links_ = std::move(media_links);
  }

  /// Channels that Handle takes messages of.
  static std::vector<std::string> Channels(const Mission& mission);

  /// The time of the messages' last step. Goes with them: forward, and back where they jump back by
  /// more than a second.
  int64_t now_utime() const { return now_utime_; }
  int64_t start_utime() const { return start_utime_; }
  int64_t tick_us() const { return tick_us_; }
  /// Returns seconds of mission time since the start.
  double SecondsOf(int64_t utime) const { return Seconds(PlausibleUtime(utime) - start_utime_); }
  double now_s() const { return SecondsOf(now_utime_); }

  /// The mission's, in its order, then those from outside in order of appearance.
  const std::vector<SceneVehicle>& vehicles() const { return vehicles_; }
  /// Returns the vehicle of this name, without regard to case, or nullptr.
  const SceneVehicle* Find(std::string_view name) const;
  /// Returns how links and vehicles write the name that `name` is without regard to case; nullptr:
  /// no message has come of or from a vehicle of that name.
  const std::string* NameOf(std::string_view name) const;
  /// True where the broker would count the vehicle as stale; false while it has never reported.
  bool IsStale(const SceneVehicle& vehicle) const;
  const std::optional<RulesInForce>& rules() const { return rules_; }
  const LinkBook& links() const { return links_; }
  const MediaLinks& media_links() const { return media_links_; }
  const PulseBook& pulses() const { return pulses_; }
  PulseBook& pulses() { return pulses_; }
  const PacketBook& packets() const { return packets_; }
  const DrawingBook& drawings() const { return drawings_; }
  double sound_mps() const { return sound_mps_; }

  /// Messages that were not understood: bytes that do not decode, reports that the broker refuses.
  int64_t num_undecodable() const { return num_undecodable_; }
  int64_t num_left_out() const { return num_left_out_; }  ///< Reports of too many outside vehicles.

 private:
  enum class Topic : uint8_t {
    kNav,
    kHelm,
    kCommand,
    kSwarm,
    kShown,
    kReport,
    kFates,
    kMedia,
    kRules,
    kPulses,
    kDrawings
  };
  struct ChannelPlace {
    Topic topic = Topic::kNav;
    size_t vehicle = 0;
    size_t shown = 0;  ///< kShown: the place of its row.
  };
  struct TextHash {
    using is_transparent = void;
    size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };

  // Return false for bytes that are no such message.
  bool HandleNav(size_t vehicle, std::span<const uint8_t> data, SceneObserver* observer);
  bool HandleCommand(size_t vehicle, std::span<const uint8_t> data, SceneObserver* observer);
  bool HandleHelm(size_t vehicle, std::span<const uint8_t> data, SceneObserver* observer);
  bool HandleShown(size_t vehicle, size_t row, std::span<const uint8_t> data,
                   SceneObserver* observer);
  bool HandleSwarm(size_t vehicle, std::span<const uint8_t> data);
  bool HandleReport(std::span<const uint8_t> data, SceneObserver* observer);
  bool HandleFates(std::span<const uint8_t> data, SceneObserver* observer);
  bool HandleMedia(std::span<const uint8_t> data, SceneObserver* observer);
  bool HandleRules(std::span<const uint8_t> data);
  bool HandlePulses(std::span<const uint8_t> data);
  std::optional<std::pair<double, double>> PositionOf(std::string_view name) const;
  void MoveNow(int64_t utime);

  int64_t start_utime_ = 0;
  int64_t tick_us_ = 100'000;
  int64_t now_utime_ = 0;
  double sound_mps_ = 1500;
  size_t num_of_mission_ = 0;
  std::unordered_map<std::string, ChannelPlace, TextHash, std::equal_to<>> channels_;
  std::vector<SceneVehicle> vehicles_;
  NameTable names_;  ///< Of vehicles_, by place.
  std::optional<RulesInForce> rules_;
  LinkBook links_;
  MediaLinks media_links_;
  PulseBook pulses_;
  PacketBook packets_;
  DrawingBook drawings_;
  int64_t num_undecodable_ = 0;
  int64_t num_left_out_ = 0;
};

}  // namespace shoal
