// The node reports of a step: all are taken in, so that every vehicle is where it is now, then each
// is routed, block by block (lib/run/broker/report_blocks.h). Where there are several blocks, each
// publishes at a place of its own and has COMMS_FATES and VIEW_COMMS_PULSE of its own, so that
// another broker can route it.
//
// Publishes NODE_REPORT_UNC; what comes of the rest, Delivery publishes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "apps/shore_broker/broker_inbox.h"
#include "apps/shore_broker/delivery.h"
#include "apps/shore_broker/media_traffic.h"
#include "lib/bus/bus/bus.h"
#include "lib/comms/routing/router.h"
#include "lib/run/broker/broker_setup.h"
#include "lib/run/broker/report_blocks.h"
#include "lib/run/run/status_page.h"

namespace shoal {

class ReportTraffic {
 public:
  /// What a broker consists of; all of it outlives this.
  struct Parts {
    const BrokerSetup& setup;
    const BrokerShare& share;
    Bus& bus;
    BrokerInbox& inbox;
    Router& router;
    MediaTraffic& traffic;
    Delivery& delivery;
    StatusLog& log;
  };

  explicit ReportTraffic(const Parts& parts) : parts_(parts), blocks_(parts.setup) {}

  /// Takes in and routes what the inbox has. What is published after this comes after it.
  void Route(int64_t utime);

  void OnWarp(double warp) { warp_ = warp > 0 ? warp : kMaxWarp; }
  int64_t num_shared() const { return num_shared_; }  ///< On NODE_REPORT_UNC.

 private:
  /// Stands for `--warp max` where wall time matters: such missions run about 100 times as fast as
  /// real time.
  static constexpr double kMaxWarp = 100;

  struct Report {
    BrokerInbox::Item raw;
    int64_t made_utime = 0;
    Admission admission = {};
    std::string refused_name = {};  ///< Where it is refused.
    size_t block = 0;
  };

  bool TakeIn(int64_t utime, Report* report);
  void RouteBlock(int64_t utime, std::span<const Report> reports);
  void RouteOne(int64_t utime, const Report& report);
  void Share(int64_t utime, const Report& report);

  const Parts parts_;
  const ReportBlocks blocks_;
  double warp_ = kMaxWarp;
  int64_t num_shared_ = 0;
  std::vector<Report> reports_;      ///< Of this step and this broker's blocks.
  std::vector<Decision> decisions_;  ///< Of one report.
  node_report_t report_;             ///< Decoded into; keeps its strings' memory.
  std::vector<std::pair<std::string, int64_t>> shared_utimes_;  ///< By index; whose, and when.
};

}  // namespace shoal
