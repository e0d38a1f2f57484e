#include "apps/shoal_log/log_encounters.h"

#include <fmt/format.h>

#include <optional>
#include <ostream>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/record/log_source.h"
#include "lib/tools/analysis/encounter_log.h"

namespace shoal {

namespace {

/// Of more encounters than this, those with the lowest scores are shown.
constexpr size_t kMaxEncountersShown = 50;

class EncountersOfLog {
 public:
  EncountersOfLog(const LogEncountersOptions& options, std::ostream& out, std::ostream& err)
      : options_(options), out_(out), err_(err), encounters_(options.encounter) {}

  int Run() {
    const EncounterOptions& encounter = options_.encounter;
    if (encounter.near_miss_m > encounter.acceptable_m ||
        encounter.acceptable_m > encounter.preferred_m) {
      err_ << "shoal: distances must grow from --near-miss over --acceptable to --preferred\n";
      return kExitUsage;
    }
    const OnDamage on_damage = options_.skip_damage ? OnDamage::kSkip : OnDamage::kStop;
    std::optional<LogReader> reader = OpenLog(options_.path, on_damage, err_);
    if (!reader) return kExitEnvironment;
    while (const auto event = reader->Next()) Take(*event);
    encounters_.Finish();
    const bool is_whole = ReportDamage(*reader, err_);
    Warn(num_undecodable_, "messages do not decode; left out");
    Warn(encounters_.num_impossible(), "NAV with impossible numbers; left out");
    Warn(encounters_.num_late(), "NAV out of time; left out");
    Warn(encounters_.num_vehicles_left_out(), "NAV of too many vehicles; left out");
    if (!encounters_.is_complete()) {
      err_ << fmt::format(
          "shoal: warning: {}: more encounters than can be kept; the later ones are "
          "left out\n",
          options_.path);
    }
    if (num_nav_ == 0 && is_whole) {
      err_ << fmt::format("shoal: {}: holds no NAV_*: the log of a mission is needed\n",
                          options_.path);
      return kExitUsage;
    }
    Print();
    return is_whole ? kExitOk : kExitEnvironment;
  }

 private:
  void Warn(int64_t count, std::string_view what) {
    if (count > 0) err_ << fmt::format("shoal: warning: {}: {} {}\n", options_.path, count, what);
  }

  template <class T, class Use>
  void Decoded(const LogEvent& event, Use use) {
    T message{};
    if (Decode(Unseal(event.data).message, &message)) {
      use(message);
    } else {
      ++num_undecodable_;
    }
  }

  void Take(const LogEvent& event) {
    if (const auto vehicle = VehicleOfChannel(event.channel, topics::kNav); !vehicle.empty()) {
      Decoded<nav_t>(event, [&](const nav_t& nav) {
        ++num_nav_;
        encounters_.Add(vehicle, nav);
      });
    } else if (event.channel == report_channel_) {
      Decoded<node_report_t>(event, [&](const node_report_t& report) { encounters_.Add(report); });
    } else if (const auto helm = VehicleOfChannel(event.channel, topics::kHelmDecision);
               !helm.empty()) {
      Decoded<helm_decision_t>(
          event, [&](const helm_decision_t& decision) { encounters_.Add(helm, decision); });
    }
  }

  void Print() {
    if (options_.csv) {
      out_ << encounters_.Csv();
      return;
    }
    if (encounters_.num_encounters() == 0) {
      out_ << fmt::format(
          "No encounters: no two vessels that made way came closer than {:g} m, "
          "closing to less than {:g} m\n",
          options_.encounter.entry_range_m, options_.encounter.risk_m);
      return;
    }
    const size_t most = options_.all ? SIZE_MAX : kMaxEncountersShown;
    out_ << (options_.explain ? encounters_.Explanation(most) : encounters_.Text(most));
  }

  const LogEncountersOptions& options_;
  std::ostream& out_;
  std::ostream& err_;
  EncounterLog encounters_;
  const std::string report_channel_ = channels::NodeReportLocal().name;
  int64_t num_nav_ = 0;
  int64_t num_undecodable_ = 0;
};

}  // namespace

int LogEncounters(const LogEncountersOptions& options, std::ostream& out, std::ostream& err) {
  return EncountersOfLog(options, out, err).Run();
}

}  // namespace shoal
