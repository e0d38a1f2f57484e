// Broker and gateways together: every transmission has its fates over every hop, and each is the
// one that a second, plainer reading of docs/media.md gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "lib/bus/channels.h"
#include "lib/bus/memory_bus.h"
#include "lib/random/stream.h"
#include "sim/app_factory.h"

namespace shoal::media_hops_test {

constexpr int64_t kStep_us = 100'000;
const std::vector<std::string> kNames = {"alpha", "bravo", "charlie", "buoy", "mast"};

/// alpha: vhf; bravo: sound; charlie, buoy and mast: both. buoy and mast forward either way.
Mission FiveVehicles(uint64_t seed) {
  Mission mission;
  mission.seed = seed;
  mission.comms = {.comms_range_m = -1,
                   .critical_range_m = 0,
                   .stale_time_s = -1,
                   .stale_forget_s = -1,
                   .min_msg_interval_s = -1,
                   .reports_over = Over("vhf,acoustic"),
                   .messages_over = Over("vhf,acoustic")};
  mission.acoustics.is_used = true;
  AcousticOptions& options = mission.acoustics.options;
  options.access_mode = AccessMode::kShared;
  options.data_rate_bps = 20'000;
  options.packet_loss = 0.1;
  MediumOptions vhf = {.name = "vhf"};
  vhf.radio = {.range_m = 800, .surface_depth_m = 0.5, .latency_s = 0.05, .jitter_s = 0.4};
  vhf.radio.loss = 0.05;
  mission.media = {vhf};
  for (const std::string& name : kNames) {
    Vehicle vehicle;
    vehicle.name = name;
    vehicle.acoustic_address = static_cast<int>(mission.vehicles.size()) + 1;
    vehicle.media.names = {"vhf", "acoustic"};
    mission.vehicles.push_back(vehicle);
  }
  mission.vehicles[0].media.names = {"vhf"};
  mission.vehicles[1].media.names = {"acoustic"};
  for (const size_t gateway : {3U, 4U}) {
    mission.vehicles[gateway].media.gateway = {.exists = true,
                                               .from = {"acoustic", "vhf"},
                                               .to = {"vhf", "acoustic"},
                                               .queue = 3,
                                               .rate_hz = 8,
                                               .max_hops = 2};
  }
  return mission;
}

struct Place {
  double x_m = 0;
  double depth_m = 0;
};

/// What docs/media.md has a leg be carried by; a cause where nothing carries it.
std::string Carrier(const Place& from, const Place& to, bool from_has_vhf, bool to_has_vhf,
                    bool from_has_sound, bool to_has_sound) {
  std::string fault;
  if (from_has_vhf && to_has_vhf) {
    const double range_m = std::hypot(from.x_m - to.x_m, from.depth_m - to.depth_m);
    if (std::max(from.depth_m, to.depth_m) > 0.5) {
      fault = "submerged";
    } else if (range_m >= 800) {
      fault = "out_of_range";
    } else {
      return "vhf";
    }
  }
  if (from_has_sound && to_has_sound) return "acoustic";
  return fault.empty() ? "no_medium" : fault;
}

/// A broker, two gateways and random traffic.
class Sea {
 public:
  explicit Sea(uint64_t seed) : mission_(FiveVehicles(seed)), dice_(seed, "sea") {
    apps_.push_back(
        MakeApp({.name = "shore_broker", .app = "shore_broker", .vehicle = {}, .command = {}},
                mission_, hub_.Join("shore_broker")));
    for (const std::string gateway : {"buoy", "mast"}) {
      apps_.push_back(MakeApp(
          {.name = "gateway_" + gateway, .app = "gateway", .vehicle = gateway, .command = {}},
          mission_, hub_.Join("gateway_" + gateway)));
      Subscribe(log_, channels::RelayRx(gateway), [this](const relay_t& relay) {
        ++num_given;
        node_message_t message;
        if (relay.kind == "message" && Decode(relay.data, &message) &&
            message.dest_node == relay.gateway) {
          ++num_own;
        }
      });
    }
    Subscribe(log_, channels::RelayTx(), [this](const relay_t& relay) {
      ++num_sent_on;
      TakeOffer(relay);
      const bool is_sent_on = relay.refused.empty();
      EXPECT_TRUE(!is_sent_on || std::ranges::count(relay.via, ':') <= 1) << relay.via;
    });
    Subscribe(log_, channels::CommsFates(), [this](const comms_fates_t& fates) {
      for (const fate_t& fate : fates.fates) num_fates[fate.kind] += fate.count;
    });
    Subscribe(log_, channels::CommsMedia(), [this](const comms_media_t& media) {
      for (const fate_medium_t& fate : media.media) Compare(fate);
    });
    for (const std::string& name : kNames) {
      Subscribe(log_, channels::NodeReport(name), [this, name](const node_report_t& report) {
        const auto is_new = received_.emplace(name, report.name, report.utime).second;
        EXPECT_TRUE(is_new) << name << " has received " << report.name << "'s report twice";
        EXPECT_NE(name, report.name);
      });
    }
  }

  void Step(bool with_traffic) {
    utime_ += kStep_us;
    if (with_traffic) Move();
    if (with_traffic) Transmit();
    hub_.NextStep();
    hub_.HandleAll();
    for (const auto& app : apps_) app->Tick(utime_);
    hub_.NextStep();
    hub_.HandleAll();
  }

  std::map<std::string, int64_t> num_expected;
  std::map<std::string, int64_t> num_fates;
  std::set<std::string> causes;
  int64_t num_given = 0;
  int64_t num_own = 0;  ///< Messages for the gateway alone.
  int64_t num_sent_on = 0;
  int64_t num_compared = 0;

 private:
  static size_t IndexOf(std::string_view name) {
    return static_cast<size_t>(std::ranges::find(kNames, name) - kNames.begin());
  }

  /// Two of them change their place; the truth is on NAV.
  void Move() {
    for (int i = 0; i < 2 && utime_ % 2'000'000 == 0; ++i) {
      const auto which = static_cast<size_t>(dice_.UniformInt(kNames.size()));
      places_[which] = {.x_m = std::floor(dice_.Uniform() * 1500),
                        .depth_m = which != 0 && dice_.UniformInt(3) == 0 ? 20.0 : 0.0};
    }
    for (size_t i = 0; i < kNames.size(); ++i) {
      nav_t nav{};
      nav.x_m = places_[i].x_m;
      nav.z_m = places_[i].depth_m;
      Publish(log_, channels::Nav(kNames[i]), nav);
    }
  }

  void Report(const std::string& name) {
    node_report_t report{};
    report.utime = utime_;
    report.name = name;
    Publish(log_, channels::NodeReportLocal(), report);
    num_expected["report"] += static_cast<int64_t>(kNames.size()) - 1;
  }

  void Transmit() {
    if (utime_ == kStep_us) {  // The broker is to know all of them from the first step on.
      for (const std::string& name : kNames) Report(name);
      return;
    }
    const std::string& source = kNames[dice_.UniformInt(kNames.size())];
    if (dice_.UniformInt(8) != 0) return Report(source);
    node_message_t message{};
    message.utime = utime_;
    message.src_node = source;
    message.dest_node = kNames[(IndexOf(source) + 1) % kNames.size()];
    message.var_name = "X";
    Publish(log_, channels::NodeMessageLocal(), message);
    num_expected["message"] += NumAudience(source, message.dest_node, source);
  }

  /// Its destination and the gateways, but for its sender and its maker.
  static int64_t NumAudience(const std::string& sender, const std::string& dest_node,
                             const std::string& maker) {
    std::set<std::string> audience = {dest_node, "buoy", "mast"};
    audience.erase(sender);
    if (maker != dest_node) audience.erase(maker);
    return static_cast<int64_t>(audience.size());
  }

  void TakeOffer(const relay_t& relay) {
    const std::string& kind = relay.kind;
    if (!relay.refused.empty()) {
      ++num_expected[kind];
    } else if (kind == "report") {
      num_expected[kind] += static_cast<int64_t>(kNames.size()) - 1;
    } else {
      node_message_t message;
      ASSERT_TRUE(Decode(relay.data, &message));
      num_expected[kind] += NumAudience(relay.gateway, message.dest_node, message.src_node);
    }
  }

  void Compare(const fate_medium_t& fate) {
    causes.insert(fate.cause);
    if (fate.cause == "already_received" && fate.medium.empty()) return;
    // The places of the moment of sending are known where the fate is of the same step.
    const bool is_at_once =
        fate.cause == "no_medium" || fate.cause == "submerged" || fate.cause == "out_of_range";
    if (!is_at_once) {
      EXPECT_TRUE(fate.medium == "vhf" || fate.medium == "acoustic") << fate.cause;
      const char* without = fate.medium == "vhf" ? "bravo" : "alpha";
      EXPECT_TRUE(fate.source != without && fate.destination != without) << fate.medium;
      return;
    }
    ++num_compared;
    const size_t from = IndexOf(fate.source);
    const size_t to = IndexOf(fate.destination);
    EXPECT_EQ(fate.cause,
              Carrier(places_[from], places_[to], from != 1, to != 1, from != 0, to != 0))
        << fate.source << " to " << fate.destination;
  }

  Mission mission_;
  Stream dice_;
  MemoryBus hub_;
  Bus& log_ = hub_.Join("log");
  std::vector<std::unique_ptr<App>> apps_;
  std::array<Place, 5> places_;
  std::set<std::tuple<std::string, std::string, int64_t>> received_;
  int64_t utime_ = 0;
};

TEST(MediaAndHops, LoseTrackOfNothingInTwentyThousandSteps) {
  std::set<std::string> causes;
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    Sea sea(seed);
    for (int i = 0; i < 2000; ++i) sea.Step(true);
    for (int i = 0; i < 200; ++i) sea.Step(false);  // All that is under way ends.
    EXPECT_EQ(sea.num_fates["report"], sea.num_expected["report"]) << "seed " << seed;
    EXPECT_EQ(sea.num_fates["message"], sea.num_expected["message"]) << "seed " << seed;
    EXPECT_GT(sea.num_expected["message"], 100);
    EXPECT_EQ(sea.num_given - sea.num_own, sea.num_sent_on)
        << "nothing waits at a gateway any more";
    EXPECT_GT(sea.num_given, 1000);
    EXPECT_GT(sea.num_compared, 1000);
    causes.insert(sea.causes.begin(), sea.causes.end());
  }
  for (const char* cause :
       {"delivered", "no_medium", "submerged", "out_of_range", "packet_loss", "already_received"}) {
    EXPECT_TRUE(causes.contains(cause)) << cause << " was never seen";
  }
}

}  // namespace shoal::media_hops_test
