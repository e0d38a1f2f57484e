// A running mission as the viewer's page shows it.
//
//   LiveView view(mission, boot);
//   view.Handle(message.channel, message.data);      // from the bus's thread
//   std::string frame = view.StreamFrameJson();      // 15 times per second
//
// All functions may be called from any thread.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/mission/file/background_files.h"
#include "lib/mission/model/mission.h"
#include "lib/run/orders/command_record.h"
#include "lib/run/verdict/mission_verdict.h"
#include "lib/tools/view/event_watch.h"
#include "lib/tools/view/fate_history.h"
#include "lib/tools/view/frame_json.h"
#include "lib/tools/view/link_history.h"
#include "lib/tools/view/scene.h"
#include "lib/tools/view/trail.h"
#include "lib/tools/view/vehicle_history.h"
#include "lib/tools/view/view_clock.h"
#include "lib/tools/view/view_source.h"

namespace shoal {

class LiveView : public ViewSource, private SceneObserver {
 public:
  /// A frame of the stream holds at most this many pulses; more are counted.
  static constexpr size_t kMaxStreamPulses = 200;

  /// No mission yet: state "waiting". `boot` names this start of the viewer.
  explicit LiveView(std::string boot);
  /// `notes`: what a user should know, for the page. State "gathering" until the clock or a message
  /// states another.
  LiveView(const Mission& mission, std::string boot, std::vector<std::string> notes = {});

  /// Takes one encoded message; channels as Scene::Handle, and CLOCK_STATE.
  void Handle(std::string_view channel, std::span<const uint8_t> data);
  /// Takes the commands and their states, the newest last.
  void SetCommands(std::vector<CommandRecord> commands);
  /// States that the clock will publish nothing more: "waiting", "ended" or "lost".
  void SetClockGone(std::string_view state);
  /// Takes the verdict on the mission, which has ended.
  void SetVerdict(MissionVerdict verdict);

  /// Returns the next frame for all clients of the stream: pulses and packets since the last call.
  std::string StreamFrameJson();
  /// Grows with each message, command and change of the clock: equal numbers, equal frames.
  int64_t num_changes() const;

  std::string SetupJson(bool commands) override;
  std::string FrameJson(double t_s) override;
  std::string TrailsJson() override;
  std::string LinksJson(double t_s) override;
  Result<std::string> MediumLinksJson(std::string_view medium, double t_s) override;
  std::string FatesJson(const FateQuery& query, double t_s) override;
  std::string EventsJson() override;
  std::string VerdictJson() override;
  BackgroundFolder Backgrounds() override { return backgrounds_; }
  Result<std::string> LinkJson(std::string_view from, std::string_view to, double t_s) override;
  Result<std::string> VehicleJson(std::string_view name, double t_s, double window_s) override;

 private:
  void OnNav(size_t vehicle, const nav_t& nav) override;
  void OnHelm(size_t vehicle, const helm_state_t& helm) override;
  void OnCommand(size_t vehicle, const helm_command_t& command) override;
  void OnDecision(size_t vehicle, const helm_decision_t& decision) override;
  void OnNavigation(size_t vehicle, const navigation_t& navigation) override;
  void OnReport(size_t vehicle, const ReceivedReport& report) override;
  void OnFate(const FateView& fate, const LinkPlace& place) override;
  void OnMedium(const FateView& medium) override { fates_.AddMedium(medium); }
  void FollowRules();
  FrameParts PartsOfNow() const;

  // Do not change once constructed.
  std::string setup_json_;           ///< For clients that may only read.
  std::string setup_json_commands_;  ///< For clients that may send commands.
  BackgroundFolder backgrounds_;
  std::string clock_channel_ = channels::ClockState().name;

  mutable std::mutex mutex_;  ///< Of all below.
  Scene scene_;
  ViewClock clock_;
  bool has_clock_ = false;  ///< CLOCK_STATE was received.
  std::vector<CommandRecord> commands_;
  FateHistory fates_;
  std::vector<LinkHistory> link_histories_;  ///< By the link's place in the scene's LinkBook.
  std::vector<VehicleHistory> vehicle_histories_;
  std::vector<Trail> trails_;
  EventWatch events_;
  std::optional<MissionVerdict> verdict_;
  double stale_time_s_ = -2;  ///< The value that events_ uses.
  int64_t pulses_sent_ = 0;   ///< Order of the last that went with a stream's frame.
  int64_t packets_sent_ = 0;
  int64_t num_changes_ = 0;
};

}  // namespace shoal
