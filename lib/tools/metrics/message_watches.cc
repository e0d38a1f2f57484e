// Metrics of messages: energy and field.
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/tools/fields/field_reader.h"
#include "lib/tools/metrics/metric_channel.h"
#include "lib/tools/metrics/metric_vehicles.h"
#include "lib/tools/metrics/metric_watch.h"
#include "lib/tools/metrics/reduced_series.h"
#include "lib/tools/metrics/shaft_work.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

namespace {

class EnergyWatch : public MetricWatch {
 public:
  EnergyWatch(const Mission& mission, const MetricSpec& spec, const StepTime& now)
      : mission_(mission), from_s_(spec.from_s), now_(now) {
    for (const size_t vehicle : PlacesOf(mission, spec.vehicle)) {
      const auto* model = std::get_if<Remus100Options>(&mission.vehicles[vehicle].model);
      if (model == nullptr) continue;
      shafts_.push_back({.vehicle = vehicle, .work = ShaftWork(ParamsOf(*model))});
    }
  }

  void Subscribe(Bus& bus) override {
    for (Shaft& shaft : shafts_) {
      const std::string& name = mission_.vehicles[shaft.vehicle].name;
      shoal::Subscribe(bus, channels::Actuators(name), [&shaft](const actuators_t& actuators) {
        shaft.commanded_rpm = actuators.propeller_rpm;
      });
      shoal::Subscribe(bus, channels::Nav(name),
                       [&shaft](const nav_t& nav) { shaft.surge_mps = nav.surge_mps; });
    }
  }

  void EndStep(const Judge&) override {
    const double tick_s = Seconds(mission_.tick_us);
    for (Shaft& shaft : shafts_) {
      const double before_j = shaft.work.work_j();
      shaft.work.Step(shaft.commanded_rpm, shaft.surge_mps.value_or(0), tick_s);
      if (now_.time_s < from_s_ || !shaft.surge_mps) continue;
      work_j_ = work_j_.value_or(0) + (shaft.work.work_j() - before_j);
    }
  }

  double Value(const Judge&) const override { return work_j_.value_or(TrialResult::kNoValue); }

 private:
  struct Shaft {
    size_t vehicle = 0;
    ShaftWork work;
    double commanded_rpm = 0;
    std::optional<double> surge_mps = {};  ///< Absent: no NAV yet.
  };

  const Mission& mission_;
  double from_s_;
  const StepTime& now_;
  std::vector<Shaft> shafts_;
  std::optional<double> work_j_;
};

class FieldWatch : public MetricWatch {
 public:
  FieldWatch(const Mission& mission, const MetricSpec& spec, const StepTime& now)
      : spec_(spec), now_(now), series_(spec.reduction, spec.percentile) {
    const Result<const ChannelRow*> row = FindMetricChannel(mission, spec.channel);
    if (!row.ok()) return;
    Result<FieldReader> reader = FieldReader::Find(ShoalTypes(), (*row)->type, spec.field);
    if (reader.ok()) reader_.emplace(*reader);
  }

  void Subscribe(Bus& bus) override {
    if (!reader_) return;
    bus.SubscribeBytes(spec_.channel, [this](const Message& message) {
      if (now_.time_s < spec_.from_s) return;
      if (const std::optional<double> value = reader_->Read(message.data)) series_.Add(*value);
    });
  }

  double Value(const Judge&) const override { return series_.Value(); }

 private:
  const MetricSpec& spec_;
  const StepTime& now_;
  std::optional<FieldReader> reader_;
  ReducedSeries series_;
};

}  // namespace

std::unique_ptr<MetricWatch> WatchEnergy(const Mission& mission, const MetricSpec& spec,
                                         const StepTime& now) {
  return std::make_unique<EnergyWatch>(mission, spec, now);
}

std::unique_ptr<MetricWatch> WatchField(const Mission& mission, const MetricSpec& spec,
                                        const StepTime& now) {
  return std::make_unique<FieldWatch>(mission, spec, now);
}

}  // namespace shoal
