// NODE_REPORT_UNC: reports for displays, of each vehicle at most one in a while.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/comms/routing/router.h"

namespace shoal {

class SharedReports {
 public:
  /// Both outlive this.
  SharedReports(Bus& bus, const Router& router) : bus_(bus), router_(router) {}

  /// Wall time passes this much slower than the mission's; 0: `--warp max`.
  void OnWarp(double warp) { warp_ = warp > 0 ? warp : kMaxWarp; }
  /// Publishes the report of a vehicle, unless its last one was too short a time ago.
  void Offer(int64_t utime, int source, std::span<const uint8_t> report);

  int64_t num_published() const { return num_published_; }

 private:
  /// Stands for `--warp max` where wall time matters: such missions run about 100 times as fast as
  /// real time.
  static constexpr double kMaxWarp = 100;

  Bus& bus_;
  const Router& router_;
  double warp_ = kMaxWarp;
  int64_t num_published_ = 0;
  std::vector<std::pair<std::string, int64_t>> published_utimes_;  ///< By source; whose, and when.
};

}  // namespace shoal
