// Decides who hears whom. Hears NODE_REPORT_LOCAL, NODE_REPORT, UNC_COMMS_RANGE, UNC_STALE_TIME and
// HELM_COMMAND; says NODE_REPORT_<V> (the very bytes that came in), COMMS_FATES and
// HELM_COMMAND_<V>.
//
// A step: rules change, commands are handed on, all reports of the step are taken in, then each is
// routed, in the order in which they came; who was silent for too long is forgotten.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "apps/shore_broker/fate_writer.h"
#include "lib/bus/bus.h"
#include "lib/bus/channels.h"
#include "lib/mission/mission.h"
#include "lib/routing/router.h"
#include "lib/run/app.h"

namespace shoal {

class ShoreBrokerApp : public App {
 public:
  ShoreBrokerApp(const Mission& mission, Bus& bus);

  void Tick(int64_t utime) override;
  StatusPage Status() const override;

 private:
  /// A message that waits for Tick; its bytes lie in arena_.
  struct Waiting {
    size_t begin = 0;
    size_t size = 0;
  };
  struct WaitingReport {
    Waiting raw;
    bool from_outside = false;  ///< Came on NODE_REPORT.
    Admission admission = {};
    Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  };
  struct WaitingControl {
    double RoutingRules::*rule = nullptr;
    unc_control_t control;
  };

  Waiting Keep(const Message& message);
  std::span<const uint8_t> BytesOf(const Waiting& waiting) const;

  void ApplyControl(int64_t utime, const WaitingControl& waiting);
  void HandOnCommands(int64_t utime);
  bool TakeIn(int64_t utime, WaitingReport* report);
  void RouteOne(int64_t utime, const WaitingReport& report);
  void Forget(int64_t utime);
  const std::string& ReportChannel(int32_t index);

  Bus& bus_;
  Router router_;
  FateWriter fates_;
  StatusLog log_;
  int64_t start_utime_ = 0;
  int64_t now_utime_ = 0;
  bool started_ = false;
  int64_t num_commands_handed_on_ = 0;

  Bytes arena_;
  std::vector<WaitingControl> controls_;
  std::vector<Waiting> commands_;
  std::vector<WaitingReport> reports_;

  node_report_t report_;             ///< Decoded into; keeps its strings' memory.
  std::vector<Decision> decisions_;  ///< Of one report.
  struct ReceiverChannel {
    std::string vehicle;  ///< Whose it is: an index may pass from one stranger to another.
    std::string name;
  };
  std::vector<ReceiverChannel> report_channels_;  ///< By index of contact.
};

}  // namespace shoal
