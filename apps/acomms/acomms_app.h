// Sends and receives the acoustic messages of one vehicle in a swarm. Subscribes to NAV_<V>,
// HELM_STATE_<V> and ACOUSTIC_RX_<V>, and to ACTUATORS_<V> of a leader whose propeller needs time
// to change its revolutions; publishes ACOUSTIC_TX in its slot (lib/comms/swarm/schedule.h), and
// SWARM_<V>, what it knows of the others, in every step in which a message arrived and at least
// once per second. ACOMMS_<V> has what befell its messages, in every step in which that changed.
//
// Without NAV, or with one that is older than kNavTimeout_us, its slots pass unused. A slot that
// comes before its first NAV, or before the broker has the first node reports, is kept for up to a
// second, at most half of the slot: so the leader's slot at 0 is used.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/acomms/acomms_record.h"
#include "apps/acomms/propeller_watch.h"
#include "apps/acomms/swarm_writer.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/comms/swarm/schedule.h"
#include "lib/comms/swarm/swarm_receiver.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"

namespace shoal {

class AcommsApp : public App {
 public:
  static constexpr int64_t kNavTimeout_us = 2'000'000;
  static constexpr int64_t kSwarmInterval_us = 1'000'000;

  /// @pre mission.SwarmOf(vehicle)
  AcommsApp(const Mission& mission, const Vehicle& vehicle, Bus& bus);

  void Tick(int64_t utime) override;
  StatusPage Status() const override;

 private:
  void OnNav(const nav_t& nav);
  void ReceivePacket(const acoustic_rx_t& packet, int64_t utime);
  /// Sends what is due, or was kept; lets it pass where no NAV comes.
  void UseSlot(int64_t utime);
  void LetPass();
  void Send(const DueMessage& due, int64_t utime);
  void PublishSwarm(int64_t utime);
  std::string SwarmText() const;

  const std::string name_;
  const std::string leader_;
  const std::string swarm_name_;                     ///< Empty: the mission's only one.
  const std::set<std::string, std::less<>> others_;  ///< Vehicles of other swarms.
  const SlotPlan plan_;
  const int64_t start_utime_;
  Bus& bus_;
  const Channel<acoustic_tx_t> tx_channel_ = channels::AcousticTx();
  const Channel<swarm_t> swarm_channel_;
  const Channel<acomms_t> record_channel_;
  SwarmReceiver receiver_;
  SwarmSchedule schedule_;
  SwarmWriter writer_;
  AcommsRecord record_;
  PropellerWatch propeller_;
  const int64_t first_reports_us_;  ///< From then on the broker knows the members.
  StatusLog log_;

  nav_t nav_{};
  bool nav_is_new_ = false;  ///< It came since the last step.
  helm_state_t helm_{};
  std::vector<acoustic_rx_t>
      arrived_;                   ///< Since the last step; handled in the next, which has a time.
  std::optional<int64_t> utime_;  ///< Of the last step.
  std::optional<int64_t> nav_utime_;  ///< Step in which the last NAV came.
  std::optional<int64_t> swarm_utime_;
  std::optional<DueMessage> kept_;  ///< Its slot has come, and the first NAV has not.
  uint16_t sequence_ = 0;           ///< Of the next frame.
  int64_t num_sent_ = 0;
  int64_t num_without_nav_ = 0;
  int64_t num_of_others_ = 0;  ///< Messages of other swarms, dropped by their group_id.
};

}  // namespace shoal
