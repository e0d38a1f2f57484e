// The launcher's own participant, named "shoal": publishes what the mission file has planned, and
// observes the outcome.
// Publishes HELM_COMMAND_<V>,
// SIM_COMMAND_<V>, UNC_*, NODE_MESSAGE_LOCAL and MEDIATED_MESSAGE_<V> at the
// times of the mission's events; subscribes to NAV_<V>, HELM_STATE_<V> and COMMS_FATES. Keeps the
// controls that any program publishes on UNC_*, and answers UNC_CONTROLS_REQ with them on
// UNC_CONTROLS.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/director.h"
#include "lib/run/verdict/judge.h"
#include "sim/kept_controls.h"

namespace shoal {

class DirectorApp : public Director {
 public:
  /// Where it takes fates from: COMMS_FATES, or AddFates() at the end of a mission whose parts
  /// count their own.
  enum class Fates { kFromBus, kAddedAtTheEnd };

  /// `mission` must outlive this.
  DirectorApp(const Mission& mission, Bus& bus, Fates fates = Fates::kFromBus);

  /// Adds what a part has counted. Returns false where it is damaged.
  [[nodiscard]] bool AddFates(std::span<const uint8_t> tally) { return judge_.tally().Add(tally); }

  void Tick(int64_t utime) override;
  void End() override;
  StatusPage Status() const override;

  int64_t num_delivered() const override;
  int64_t num_blocked() const override;
  /// By link and cause.
  const FateCounts& fates(Kind kind) const { return judge_.tally().fates(kind); }
  const Judge& judge() const { return judge_; }

  std::string Summary(bool complete) const override;
  std::string VerdictText(double end_s, bool complete) const override;
  bool Passed() const override;
  bool EndsMission() const override { return ends_mission_; }

 private:
  void TakeFates(const Message& message);
  void TakeSwarm(size_t vehicle, const swarm_t& swarm);
  void EndLastStep();
  // Return false where the event was dropped, with a warning.
  bool PublishEvent(int64_t utime, const CommandEvent& event);
  bool PublishEvent(int64_t utime, const SimCommandEvent& event);
  bool PublishEvent(int64_t utime, const RuleEvent& event);
  bool PublishEvent(int64_t utime, const MessageEvent& event);
  void AnswerControlsRequest(int64_t utime);
  void LookForTheEnd(int64_t utime);

  const Mission& mission_;
  Bus& bus_;
  StatusLog log_;
  Judge judge_;
  KeptControls controls_;
  bool controls_wanted_ = false;  ///< They were requested since the last step.
  comms_fates_t fates_message_;   ///< Decoded into; keeps its strings' memory.
  size_t next_event_ = 0;
  std::vector<bool> is_done_;  ///< Of each vehicle: it is at the end of its tasks.
  bool ends_mission_ = false;
  /// Messages that are handled now were published in this step; absent before the first.
  std::optional<int64_t> last_utime_;
};

}  // namespace shoal
