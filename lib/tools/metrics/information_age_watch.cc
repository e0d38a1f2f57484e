// The metric information_age: of contacts of the swarm, or of node reports.
#include <map>
#include <string>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/tools/analysis/information_age.h"
#include "lib/tools/metrics/metric_vehicles.h"
#include "lib/tools/metrics/metric_watch.h"
#include "lib/tools/metrics/report_ages.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

namespace {

class InformationAgeWatch : public MetricWatch {
 public:
  InformationAgeWatch(const Mission& mission, const MetricSpec& spec, const StepTime& now)
      : mission_(mission),
        spec_(spec),
        now_(now),
        vehicles_(PlacesOf(mission, spec.vehicle)),
        contacts_(PlacesOf(mission, spec.to)),
        is_of_swarm_(IsOfSwarm(mission, spec.source)) {
    for (const size_t contact : contacts_) {
      places_[VehicleKey(mission.vehicles[contact].name)] = contact;
    }
  }

  void Subscribe(Bus& bus) override {
    for (const size_t vehicle : vehicles_) {
      const std::string& name = mission_.vehicles[vehicle].name;
      if (is_of_swarm_) {
        if (mission_.SwarmOf(mission_.vehicles[vehicle]) == nullptr) continue;
        shoal::Subscribe(bus, channels::Swarm(name),
                         [this](const swarm_t& swarm) { swarm_ages_.Add(swarm); });
      } else {
        shoal::Subscribe(bus, channels::NodeReport(name),
                         [this, vehicle](const node_report_t& report) {
                           const auto contact = places_.find(VehicleKey(report.name));
                           if (contact == places_.end()) return;
                           report_ages_.Add(vehicle, contact->second, report.utime, now_.utime);
                         });
      }
    }
  }

  void EndStep(const Judge&) override { last_utime_ = now_.utime; }

  double Value(const Judge&) const override {
    const std::vector<AgeTooth> teeth =
        TeethFrom(is_of_swarm_ ? TeethOfSwarm() : TeethOfReports(),
                  mission_.start_utime + static_cast<int64_t>(spec_.from_s * 1e6));
    if (teeth.empty()) return TrialResult::kNoValue;
    if (spec_.reduction == Reduction::kMax) return MaxAge_s(teeth);
    if (spec_.reduction == Reduction::kMean) return MeanAge_s(teeth);
    return AgePercentile_s(teeth, spec_.percentile / 100);
  }

 private:
  std::vector<AgeTooth> TeethOfSwarm() const {
    std::vector<AgeTooth> all;
    for (const auto& [pair, teeth] : swarm_ages_.Teeth()) {
      if (!places_.contains(VehicleKey(pair.second))) continue;
      all.insert(all.end(), teeth.begin(), teeth.end());
    }
    return all;
  }

  std::vector<AgeTooth> TeethOfReports() const {
    std::vector<AgeTooth> all;
    for (const size_t vehicle : vehicles_) {
      for (const size_t contact : contacts_) {
        if (contact == vehicle) continue;
        const std::vector<AgeTooth> teeth = report_ages_.Teeth(vehicle, contact, last_utime_);
        all.insert(all.end(), teeth.begin(), teeth.end());
      }
    }
    return all;
  }

  const Mission& mission_;
  const MetricSpec& spec_;
  const StepTime& now_;
  std::vector<size_t> vehicles_;
  std::vector<size_t> contacts_;
  std::map<std::string, size_t> places_;  ///< Of the contacts, by key.
  bool is_of_swarm_;
  InformationAge swarm_ages_;
  ReportAges report_ages_;
  int64_t last_utime_ = 0;
};

}  // namespace

std::unique_ptr<MetricWatch> WatchInformationAge(const Mission& mission, const MetricSpec& spec,
                                                 const StepTime& now) {
  return std::make_unique<InformationAgeWatch>(mission, spec, now);
}

}  // namespace shoal
