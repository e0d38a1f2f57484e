// For tests: the rules once more, from the manual and the reference's table, in the plainest way
// and without lib/comms/routing's code, but for the random numbers of drop_percentage.
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/text/blanks.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/decide.h"
#include "lib/comms/routing/oracle_words_testing.h"
#include "lib/comms/routing/traffic_testing.h"

namespace shoal::oracle {

inline constexpr uint64_t kSeed = 7;

struct OracleVehicle {
  bool known = false;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  std::string group;
  int64_t reported = 0;
  std::optional<int64_t> messaged;
  LinkFactors factors;
  std::map<Kind, int64_t> next_number;
};

struct OracleReport {
  std::string source;
  std::string group;
  Eigen::Vector3d position_m;
  Fate fate;  ///< Number; and cause, where refused.
};

class Oracle {
 public:
  explicit Oracle(const std::vector<std::string>& mission) {
    for (const std::string& name : mission) {
      mission_.insert(Lower(name));
      vehicles_[Lower(name)];
    }
  }

  RoutingRules rules;
  int64_t now = 0;

  void SetFactors(const std::string& name, const LinkFactors& factors) {
    if (IsName(name)) vehicles_[Lower(name)].factors = factors;
  }

  void RequestFullReports(const std::string& name) {
    const std::string receiver = Lower(name);
    if (!Exists(receiver)) return;
    for (const auto& [source, vehicle] : vehicles_) {
      wanted_.erase({receiver, source});
      if (source != receiver && Exists(source)) wanted_.insert({receiver, source});
    }
  }

  OracleReport Admit(const RandomReport& report) {
    OracleReport admitted = {Lower(report.name), Lower(report.group), report.position_m, {}};
    const auto refuse = [&](Cause cause) {
      admitted.fate = Start(Kind::kReport, IsName(report.name) ? admitted.source : "");
      admitted.fate.numbers.cause = cause;
      return admitted;
    };
    if (!IsName(report.name) || !IsFinite(report.position_m)) {
      return refuse(Cause::kInvalid);
    }
    if (!rules.ignore_group.empty() && Lower(rules.ignore_group) == admitted.group) {
      return refuse(Cause::kIgnoredGroup);
    }
    OracleVehicle& source = vehicles_[admitted.source];
    source.known = true;
    source.position_m = report.position_m;
    source.group = admitted.group;
    source.reported = now;
    admitted.fate = Start(Kind::kReport, admitted.source);
    return admitted;
  }

  std::vector<Fate> Route(const OracleReport& report) {
    std::vector<Fate> fates;
    for (const auto& [name, receiver] : vehicles_) {
      if (!receiver.known || name == report.source) continue;
      Fate fate = report.fate;
      fate.destination = name;
      DecideReport(report, receiver, &fate);
      if (fate.numbers.cause == Cause::kDelivered) received_[{report.source, name}] = now;
      fates.push_back(fate);
    }
    return fates;
  }

  std::vector<Fate> Message(const RandomMessage& message) {
    bool to_all = Lower(message.dest_group) == "all";
    std::vector<std::string> named;
    std::set<std::string> seen;
    std::istringstream list(message.dest_node);
    for (std::string part; std::getline(list, part, ':');) {
      const std::string name = Trimmed(part);
      if (Lower(name) == "all") to_all = true;
      const bool is_new = seen.insert(Lower(name)).second;
      if (!name.empty() && Lower(name) != "all" && is_new) named.push_back(name);
    }
    const std::string key = IsName(message.source) ? Lower(message.source) : "";
    if (key.empty() || !message.is_sound ||
        (!to_all && named.empty() && message.dest_group.empty())) {
      Fate fate = Start(Kind::kMessage, key);
      fate.numbers.cause = Cause::kInvalid;
      return {fate};
    }
    vehicles_[key];
    std::set<std::string> to;
    std::vector<std::string> unknown;
    for (const auto& [name, vehicle] : vehicles_) {
      const bool in_group =
          !message.dest_group.empty() && vehicle.group == Lower(message.dest_group);
      if (vehicle.known && (to_all || in_group)) to.insert(name);
    }
    for (const std::string& name : named) {
      if (vehicles_.contains(Lower(name))) {
        to.insert(Lower(name));
      } else {
        unknown.push_back(name);
      }
    }
    to.erase(key);
    Fate sent = Start(Kind::kMessage, key);
    RefuseMessage(message, &vehicles_[key], &sent.numbers);
    return Deliver(sent, to, unknown);
  }

  std::vector<Fate> Ack(const RandomMessage& ack) {
    const std::string key = IsName(ack.source) ? Lower(ack.source) : "";
    Fate sent = Start(Kind::kAck, key);
    if (key.empty() || !ack.is_sound || !IsName(ack.dest_node) || key == Lower(ack.dest_node)) {
      sent.numbers.cause = Cause::kInvalid;
      return {sent};
    }
    if (vehicles_.contains(key)) {
      RefuseSource(vehicles_[key], &sent.numbers);
    } else {
      sent.numbers.cause = Cause::kUnknownSource;
    }
    if (vehicles_.contains(Lower(ack.dest_node))) return Deliver(sent, {Lower(ack.dest_node)}, {});
    return Deliver(sent, {}, {ack.dest_node});
  }

  void Forget() {
    for (auto& [name, vehicle] : vehicles_) {
      if (!vehicle.known || rules.stale_forget_s < 0) continue;
      if (Since(vehicle.reported) < rules.stale_forget_s) continue;
      vehicle.known = false;
      vehicle.group = "";
      vehicle.messaged = std::nullopt;
      std::erase_if(received_, [&](const auto& entry) {
        return entry.first.first == name || entry.first.second == name;
      });
      std::erase_if(wanted_, [&](const auto& pair) { return pair.first == name; });
    }
  }

 private:
  bool Exists(const std::string& name) {
    return mission_.contains(name) || (vehicles_.contains(name) && vehicles_[name].known);
  }

  double Since(int64_t utime) const { return Seconds(now - utime); }

  bool Stale(const OracleVehicle& vehicle) const {
    return rules.stale_time_s >= 0 && Since(vehicle.reported) >= rules.stale_time_s;
  }

  /// Numbers a transmission. Those of unknown sources are counted together.
  Fate Start(Kind kind, const std::string& key) {
    Fate fate;
    fate.numbers.kind = kind;
    const bool is_known = vehicles_.contains(key);
    if (is_known) fate.source = key;
    fate.numbers.number = (is_known ? vehicles_[key] : unknown_).next_number[kind]++;
    return fate;
  }

  static double Range(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double x = b.x() - a.x();
    const double y = b.y() - a.y();
    const double z = b.z() - a.z();
    return std::sqrt(x * x + (y * y + z * z));  // In the order of Eigen's norm().
  }

  bool IsLost(const Fate& fate) const {
    const StreamKey key = DropKey(kSeed, fate.numbers.kind, fate.source);
    return Stream(key.With(fate.destination).With(fate.numbers.number)).Uniform() * 100 <
           rules.drop_percentage;
  }

  /// True where stale; sets the age.
  bool StopsAsStale(const OracleVehicle& receiver, Decision* d) const {
    d->age_s = Since(receiver.reported);
    if (rules.stale_time_s >= 0) d->age_limit_s = rules.stale_time_s;
    return Stale(receiver);
  }

  bool StopsAsFar(double range_m, double stealth, double earange, Decision* d) const {
    d->range_m = range_m;
    if (rules.comms_range_m < 0) return false;
    d->limit_m = rules.comms_range_m * stealth * earange;
    return range_m >= d->limit_m;
  }

  void DecideReport(const OracleReport& report, const OracleVehicle& receiver, Fate* fate) {
    Decision* d = &fate->numbers;
    const double range_m = Range(report.position_m, receiver.position_m);
    if (wanted_.erase({fate->destination, report.source}) > 0) {
      d->override_rule = OverrideRule::kFullReport;
      d->range_m = range_m;
      d->age_s = Since(receiver.reported);
      return;
    }
    d->cause = Cause::kStaleReceiver;
    if (StopsAsStale(receiver, d)) return;
    if (range_m < rules.critical_range_m) {
      d->cause = Cause::kDelivered;
      d->override_rule = OverrideRule::kCriticalRange;
      d->range_m = range_m;
      d->limit_m = rules.critical_range_m;
      return;
    }
    d->cause = Cause::kOutOfRange;
    const double stealth = vehicles_[report.source].factors.stealth;
    if (StopsAsFar(range_m, stealth, receiver.factors.earange, d)) return;
    d->cause = Cause::kOtherGroup;
    if (rules.groups && report.group != receiver.group) return;
    d->cause = Cause::kDropped;
    if (rules.drop_percentage > 0) d->loss_pct = rules.drop_percentage;
    if (IsLost(*fate)) return;
    d->cause = Cause::kDelivered;
    const auto delivered = received_.find({report.source, fate->destination});
    if (rules.min_rpt_interval_s < 0 || delivered == received_.end()) return;
    if (Since(delivered->second) >= rules.min_rpt_interval_s) return;
    d->cause = Cause::kTooSoon;
    d->wait_s = rules.min_rpt_interval_s - Since(delivered->second);
  }

  static void RefuseSource(const OracleVehicle& source, Decision* d) {
    if (!source.known) d->cause = Cause::kUnknownSource;
  }

  void RefuseMessage(const RandomMessage& message, OracleVehicle* source, Decision* d) const {
    if (source->messaged && Since(*source->messaged) < rules.min_msg_interval_s) {
      d->cause = Cause::kTooSoon;
      d->wait_s = rules.min_msg_interval_s - Since(*source->messaged);
      return;
    }
    source->messaged = now;
    d->length_bytes = message.length_bytes;
    if (rules.max_msg_length_bytes != 0) {
      d->length_limit_bytes = rules.max_msg_length_bytes;
      if (message.length_bytes > rules.max_msg_length_bytes) {
        d->cause = Cause::kTooLong;
        return;
      }
    }
    RefuseSource(*source, d);
  }

  std::vector<Fate> Deliver(const Fate& sent, const std::set<std::string>& to,
                            const std::vector<std::string>& unknown) {
    std::vector<Fate> fates;
    const auto add = [&](const std::string& name) -> Fate& {
      fates.push_back(sent);
      fates.back().destination = name;
      return fates.back();
    };
    const bool is_refused = sent.numbers.cause != Cause::kDelivered;
    for (const std::string& name : to) {
      Fate& fate = add(name);
      if (!is_refused) DecideMessage(vehicles_[fate.source], vehicles_[name], &fate);
    }
    for (const std::string& name : unknown) {
      Fate& fate = add(name);
      if (!is_refused) fate.numbers.cause = Cause::kUnknownDestination;
    }
    if (fates.empty() && !is_refused) add("").numbers.cause = Cause::kNoDestination;
    if (fates.empty()) add("");
    return fates;
  }

  void DecideMessage(const OracleVehicle& source, const OracleVehicle& receiver, Fate* fate) const {
    Decision* d = &fate->numbers;
    d->cause = Cause::kUnknownDestination;
    if (!receiver.known) return;
    d->cause = Cause::kOtherGroup;
    const bool is_message = d->kind == Kind::kMessage;
    if (is_message && rules.msg_groups && source.group != receiver.group) return;
    d->cause = Cause::kStaleReceiver;
    if (StopsAsStale(receiver, d)) return;
    d->cause = Cause::kOutOfRange;
    const double range_m = Range(source.position_m, receiver.position_m);
    if (StopsAsFar(range_m, source.factors.stealth, receiver.factors.earange, d)) return;
    if (rules.drop_percentage > 0) d->loss_pct = rules.drop_percentage;
    d->cause = IsLost(*fate) ? Cause::kDropped : Cause::kDelivered;
  }

  std::set<std::string> mission_;
  std::map<std::string, OracleVehicle> vehicles_;
  OracleVehicle unknown_;
  std::map<std::pair<std::string, std::string>, int64_t> received_;  ///< (source, receiver)
  std::set<std::pair<std::string, std::string>> wanted_;             ///< (receiver, source)
};

}  // namespace shoal::oracle
