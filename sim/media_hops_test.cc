// Broker and gateways together: every transmission has its fates over every hop, and each is the
// one that a second, plainer reading of docs/communication/media.md gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "apps/shore_broker/air_text.h"
#include "lib/base/random/stream.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/memory_bus.h"
#include "sim/app_factory.h"
#include "sim/media_hops_testing.h"

namespace shoal::media_hops_test {

const std::vector<std::string> kNames = {"alpha", "bravo", "charlie", "buoy", "mast"};

/// alpha: vhf; bravo: sound; charlie, buoy and mast: both. buoy and mast forward either way.
Mission FiveVehicles(uint64_t seed) {
  Mission mission;
  mission.seed = seed;
  mission.start_utime = kStep_us;  // The broker's first step is the mission's.
  mission.comms = {.comms_range_m = -1,
                   .critical_range_m = 0,
                   .stale_time_s = -1,
                   .stale_forget_s = -1,
                   .min_msg_interval_s = -1,
                   .reports_over = Over("vhf,acoustic"),
                   .messages_over = Over("vhf,acoustic")};
  mission.acoustics.is_used = true;
  mission.acoustics.queue = false;  // The oracle knows none.
  AcousticOptions& options = mission.acoustics.options;
  options.access_mode = AccessMode::kShared;
  options.data_rate_bps = 20'000;
  options.packet_loss = 0.1;
  MediumOptions vhf = {.name = "vhf"};
  vhf.radio = {.range_m = 800, .surface_depth_m = 0.5};
  vhf.radio.rate_bps = 9600;
  vhf.radio.latency_s = 0.05;
  vhf.radio.jitter_s = 0.4;
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

constexpr size_t kReport_bytes = 37;

/// A broker, two gateways and random traffic.
class Sea {
  const Mission mission_;

 public:
  explicit Sea(uint64_t seed) : mission_(FiveVehicles(seed)), dice_(seed, "sea") {
    apps_.push_back(
        MakeApp({.name = "shore_broker", .app = "shore_broker", .vehicle = {}, .command = {}},
                mission_, hub_.Join("shore_broker")));
    for (const std::string gateway : {"buoy", "mast"}) {
      apps_.push_back(MakeApp({.name = "gateway_" + gateway,
                               .app = "gateway",
                               .vehicle = gateway,
                               .vehicle_place = static_cast<size_t>(mission_.FindVehicle(gateway) -
                                                                    mission_.vehicles.data()),
                               .command = {}},
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
      offers_.push_back(relay);  // For the broker's next step.
      const bool is_sent_on = relay.refused.empty();
      EXPECT_TRUE(!is_sent_on || std::ranges::count(relay.via, ':') <= 1) << relay.via;
    });
    Subscribe(log_, channels::CommsFates(), [this](const comms_fates_t& fates) {
      for (const fate_t& fate : fates.fates) num_fates[fate.kind] += fate.count;
    });
    Subscribe(log_, channels::CommsMedia(), [this](const comms_media_t& media) {
      for (const fate_medium_t& fate : media.media) {
        causes.insert(fate.cause);
        oracle.Compare(fate, utime_);
      }
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
    std::vector<relay_t> offers;
    offers.swap(offers_);
    if (with_traffic) Transmit();
    for (const relay_t& relay : offers) TakeOffer(relay);
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
  HopOracle oracle{mission_};

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
    oracle.Take("report", name, kReport_bytes, utime_, places_);
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
    oracle.Take("message", source, AirBytes(message).size(), utime_, places_);
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
      oracle.TakeRefused(kind, relay.gateway);
    } else if (kind == "report") {
      num_expected[kind] += static_cast<int64_t>(kNames.size()) - 1;
      oracle.Take(kind, relay.gateway, kReport_bytes, utime_, places_);
    } else {
      node_message_t message;
      ASSERT_TRUE(Decode(relay.data, &message));
      num_expected[kind] += NumAudience(relay.gateway, message.dest_node, message.src_node);
      oracle.Take(kind, relay.gateway, AirBytes(message).size(), utime_, places_);
    }
  }

  Stream dice_;
  MemoryBus hub_;
  Bus& log_ = hub_.Join("log");
  std::vector<std::unique_ptr<App>> apps_;
  HopOracle::Places places_;
  std::vector<relay_t> offers_;  ///< Of the last step.
  std::set<std::tuple<std::string, std::string, int64_t>> received_;
  int64_t utime_ = 0;
};

/// Ten cases of their own seeds: 100,000 steps with traffic in all.
class MediaAndHops : public testing::TestWithParam<uint64_t> {};

TEST_P(MediaAndHops, LoseTrackOfNothingAndArriveInTime) {
  constexpr uint64_t kSeedsOfCase = 5;
  std::set<std::string> causes;
  for (uint64_t i = 1; i <= kSeedsOfCase; ++i) {
    const uint64_t seed = kSeedsOfCase * GetParam() + i;
    Sea sea(seed);
    for (int step = 0; step < 2000; ++step) sea.Step(true);
    for (int step = 0; step < 200; ++step) sea.Step(false);  // All that is under way ends.
    EXPECT_EQ(sea.num_fates["report"], sea.num_expected["report"]) << "seed " << seed;
    EXPECT_EQ(sea.num_fates["message"], sea.num_expected["message"]) << "seed " << seed;
    EXPECT_GT(sea.num_expected["message"], 100);
    EXPECT_EQ(sea.num_given - sea.num_own, sea.num_sent_on)
        << "nothing waits at a gateway any more";
    EXPECT_GT(sea.num_given, 1000);
    EXPECT_GT(sea.oracle.num_compared, 5000);
    EXPECT_GT(sea.oracle.num_timed, 2000);
    for (const std::string medium : {"vhf", "acoustic"}) {
      EXPECT_LT(sea.oracle.jitters[medium].least, 0.05) << medium;
      EXPECT_GT(sea.oracle.jitters[medium].most, 0.95) << medium;
    }
    causes.insert(sea.causes.begin(), sea.causes.end());
  }
  for (const char* cause :
       {"delivered", "no_medium", "submerged", "out_of_range", "packet_loss", "already_received"}) {
    EXPECT_TRUE(causes.contains(cause)) << cause << " was never seen";
  }
}
INSTANTIATE_TEST_SUITE_P(TenThousandSteps, MediaAndHops, testing::Range<uint64_t>(0, 10));

}  // namespace shoal::media_hops_test
