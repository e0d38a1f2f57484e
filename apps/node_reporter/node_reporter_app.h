// Reports the state of one vehicle. Subscribes to NAV_<V> and HELM_STATE_<V>, publishes
// NODE_REPORT_LOCAL. Acknowledges the messages that the vehicle receives, and repeats its own
// (mediator.h).
//
// No report goes out before the first NAV, nor while NAV is older than 2 s. After the grace period
// missing NAV is a run warning, taken back when NAV is there again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/node_reporter/mediator.h"
#include "apps/node_reporter/report_schedule.h"
#include "lib/base/random/stream.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"

namespace shoal {

class NodeReporterApp : public App {
 public:
  /// `vehicle` must be one of the mission's.
  NodeReporterApp(const Mission& mission, const Vehicle& vehicle, Bus& bus);

  void Tick(int64_t utime) override;
  StatusPage Status() const override;

 private:
  void TakeNav(const nav_t& nav);
  /// Reports how well the position is known, beside the position.
  void TakeUncertainty(const navigation_t& navigation);
  void Report(int64_t utime);
  bool HasFreshNav(int64_t utime);
  int64_t NavUtime(int64_t utime) const;
  void FillReport(int64_t utime);
  std::string Mode(int64_t utime) const;
  bool IsForetold() const;
  void StartBlackout(int64_t utime);

  // What every step needs comes first, as in vehicle_sim.
  Bus& bus_;
  const int64_t start_utime_;
  int64_t now_utime_ = 0;
  std::optional<int64_t> nav_utime_;   ///< Step in which the last NAV came.
  std::optional<int64_t> helm_utime_;  ///< Step in which the last HELM_STATE came.
  bool nav_is_new_ = false;            ///< Came since the last step.
  bool helm_is_new_ = false;
  bool warned_of_nav_ = false;
  const double nav_grace_period_s_;
  ReportSchedule schedule_;
  Mediator mediator_;
  nav_t nav_ = {};
  helm_state_t helm_ = {};
  node_report_t report_ = {};               ///< The last one sent, or the next one in the making.
  std::optional<node_report_t> last_sent_;  ///< Kept only where dead reckoning needs it.

  const std::string name_;
  const ReporterOptions options_;
  const StreamKey blackout_stream_;
  const Channel<node_report_t> channel_ = channels::NodeReportLocal();
  StatusLog log_;
  int64_t silent_until_utime_ = 0;  ///< End of the blackout.
  int64_t num_sent_ = 0;
  int64_t num_without_nav_ = 0;
  int64_t num_blacked_out_ = 0;
  int64_t num_predicted_ = 0;
  int64_t num_bad_nav_ = 0;
};

}  // namespace shoal
