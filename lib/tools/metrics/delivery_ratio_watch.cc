// The metric delivery_ratio: from the judge's counts alone.
#include "lib/comms/routing/vehicle_name.h"
#include "lib/tools/metrics/metric_vehicles.h"
#include "lib/tools/metrics/metric_watch.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

namespace {

class DeliveryRatioWatch : public MetricWatch {
 public:
  DeliveryRatioWatch(const Mission& mission, const MetricSpec& spec)
      : traffic_(spec.traffic), from_(Ends(mission, spec.from)), to_(Ends(mission, spec.to)) {}

  double Value(const Judge& judge) const override {
    const FateCounts& counts = traffic_ ? judge.tally().fates(*traffic_) : judge.swarm_counts();
    int64_t delivered = 0;
    int64_t offered = 0;
    for (const int from : from_) {
      for (const int to : to_) {
        offered += counts.CountOffered(from, to);
        if (traffic_) {
          delivered += counts.Count(from, to, "delivered");
        } else {
          delivered += counts.Count(from, to, "clean") + counts.Count(from, to, "recovered");
        }
      }
    }
    if (offered == 0) return TrialResult::kNoValue;
    return 100 * static_cast<double>(delivered) / static_cast<double>(offered);
  }

 private:
  static std::vector<int> Ends(const Mission& mission, const std::string& addressees) {
    if (VehicleKey(addressees) == "all") return {FateCounts::kAll};
    std::vector<int> ends;
    for (const size_t place : PlacesOf(mission, addressees))
      ends.push_back(static_cast<int>(place));
    return ends;
  }

  std::optional<Kind> traffic_;
  std::vector<int> from_;
  std::vector<int> to_;
};

}  // namespace

std::unique_ptr<MetricWatch> WatchDeliveryRatio(const Mission& mission, const MetricSpec& spec) {
  return std::make_unique<DeliveryRatioWatch>(mission, spec);
}

}  // namespace shoal
