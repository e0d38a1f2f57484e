// The node reports of a step, routed block by block (lib/run/broker/report_blocks.h). Where there
// are several blocks, each publishes at a place of its own and has COMMS_FATES and VIEW_COMMS_PULSE
// of its own, so that another broker can route it.
//
//   reports.Route(utime, intake.TakeAll(utime));
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "apps/shore_broker/delivery.h"
#include "apps/shore_broker/media_traffic.h"
#include "apps/shore_broker/report_intake.h"
#include "apps/shore_broker/shared_reports.h"
#include "lib/bus/bus/bus.h"
#include "lib/comms/routing/router.h"
#include "lib/run/broker/broker_setup.h"
#include "lib/run/broker/report_blocks.h"

namespace shoal {

class ReportTraffic {
 public:
  /// What decides about a report and carries it; all of it outlives this.
  struct Carriers {
    Router& router;
    const MediaTraffic& media;
    Delivery& delivery;
  };

  /// `setup`, `share` and `bus` outlive this, too.
  ReportTraffic(const BrokerSetup& setup, const BrokerShare& share, Bus& bus,
                const Carriers& carriers)
      : setup_(setup),
        share_(share),
        bus_(bus),
        carriers_(carriers),
        blocks_(setup),
        shared_(bus, carriers.router) {}

  /// Routes those of the reports that are of this broker's blocks, which it sorts by block. What is
  /// published after this comes after it.
  void Route(int64_t utime, std::vector<TakenReport>& reports);

  SharedReports& shared() { return shared_; }
  const SharedReports& shared() const { return shared_; }

 private:
  void RouteBlock(int64_t utime, std::span<const TakenReport> reports);
  void RouteOne(int64_t utime, const TakenReport& report);
  size_t BlockOf(const TakenReport& report) const {
    return blocks_.BlockOf(report.admission.source);
  }

  const BrokerSetup& setup_;
  const BrokerShare& share_;
  Bus& bus_;
  const Carriers carriers_;
  const ReportBlocks blocks_;
  SharedReports shared_;
  std::vector<Decision> decisions_;  ///< Of one report.
  node_report_t report_;             ///< Decoded into; keeps its strings' memory.
};

}  // namespace shoal
