// What a vehicle knows of its position: the filter, fed with the readings of each step.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "lib/vehicle/navigation/beacons.h"
#include "lib/vehicle/navigation/instruments.h"
#include "lib/vehicle/navigation/navigation_filter.h"

namespace shoal {

/// What a vehicle believes at the start; standard deviations, >= 0.
struct StartKnowledge {
  double position_m = 1;  ///< Of x and of y.
  double heading_rad = 0.1;
  double current_mps = 0.3;  ///< Of each component; the estimate begins at still water.
};

/// Returns what a filter assumes of a vehicle with these instruments: the spreads that they are
/// drawn with, and their noise.
[[nodiscard]] FilterOptions FilterFor(const InstrumentOptions& options, FilterOptions tuning = {});

/// Which instruments the filter took in one step.
struct InstrumentsUsed {
  bool compass = false;
  bool dvl = false;
  bool log = false;
  bool gps = false;
};

/// A range that was offered to the filter.
struct RangeUsed {
  size_t beacon = 0;
  double range_m = 0;
  UpdateResult result;
  std::optional<UpdateResult> direction;  ///< Of its bearing and depression, where measured.
};

class Navigator {
 public:
  /// `assumed` holds the options before Drawn(). The first position and heading are drawn about
  /// those of `start`.
  Navigator(const InstrumentOptions& assumed, const FilterOptions& tuning,
            const StartKnowledge& knowledge, std::vector<Beacon> beacons, const StreamKey& key);

  /// Begins at a true position, with the errors of StartKnowledge.
  void Start(const Eigen::Vector2d& position_m, double heading_rad);

  /// Takes the readings of one step of `dt_s` >= 0; 0: of the first. @pre after Start
  void Take(const Readings& readings, double dt_s);

  /// @pre after Start
  const NavigationFilter& filter() const { return *filter_; }
  double depth_m() const { return depth_m_; }
  const InstrumentsUsed& used() const { return used_; }
  const std::vector<RangeUsed>& ranges() const { return ranges_; }  ///< Of the last Take.
  /// Of position; 95 % of truths lie inside.
  [[nodiscard]] ErrorEllipse ellipse() const;

 private:
  InstrumentOptions assumed_;
  FilterOptions filter_options_;
  StartKnowledge knowledge_;
  std::vector<Beacon> beacons_;
  StreamKey key_;
  std::optional<NavigationFilter> filter_;
  double depth_m_ = 0;
  InstrumentsUsed used_;
  std::vector<RangeUsed> ranges_;
  int64_t starts_ = 0;
};

}  // namespace shoal
