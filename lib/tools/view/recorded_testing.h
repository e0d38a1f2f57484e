// Generated logs, for tests of recorded views.
#pragma once

#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/record/log_testing.h"
#include "lib/tools/view/recorded_view.h"
#include "lib/tools/view/view_testing.h"

namespace shoal {

inline constexpr int64_t kRecordedStep_us = 100'000;
inline const std::vector<std::string> kTrafficNames = {"alpha", "Bravo", "c3"};

/// Draws the messages of a mission, in the order of a log; all of it follows from `seed`.
class TrafficMaker {
 public:
  explicit TrafficMaker(uint32_t seed) : random_(seed) {}

  std::vector<TestEvent> Make(int num_steps) {
    for (int step = 0; step <= num_steps; ++step) MakeStep(step);
    return std::move(events_);
  }

 private:
  int Draw(int most) { return std::uniform_int_distribution(0, most)(random_); }

  template <class T>
  void Append(const std::string& channel, const T& message) {
    events_.push_back({.utime = utime_, .channel = channel, .data = Encoded(message)});
  }

  void MakeStep(int step) {
    utime_ = step * kRecordedStep_us;
    if (step % 3 == 1) Append(channels::CommsFates().name, FatesOf(utime_, MakeFates()));
    if (step == 0 || Draw(60) == 0) {
      BrokerRules rules = RulesWith(utime_, 50 + Draw(300), 1 + Draw(4));
      for (const std::string& name : kTrafficNames) rules.vehicles.push_back({.name = name});
      rules.tick_us = kRecordedStep_us;
      rules.rules.pulse_duration_s = 5;
      Append(channels::CommsRules().name, ToMessage(rules));
    }
    for (const std::string& name : kTrafficNames) MakeVehicle(step, name);
    if (step > 120 && Draw(30) == 0) {
      Append(channels::NodeReportFromOutside().name,
             ReportOf(Draw(1) == 0 ? "ship" : "Zodiac", utime_, Draw(100), 7));
    }
    for (const std::string& name : kTrafficNames) {
      // A vehicle that is silent for a while becomes stale.
      if (step % 5 == 2 && Draw(9) > 1) {
        Append(channels::NodeReportLocal().name, ReportOf(name, utime_, Draw(100), Draw(100)));
      }
    }
    if (step % 3 == 1) {
      Append(channels::ViewCommsPulse().name,
             PulsesOf(utime_, {PulseOf("ALPHA2BRAVO", "nrep", 1 + Draw(4)),
                               PulseOf("C32BRAVO_" + std::to_string(Draw(3)), "msg", 5)}));
    }
  }

  void MakeVehicle(int step, const std::string& name) {
    desired_t desired{
        .utime = utime_, .heading_deg = 1.0 * Draw(359), .speed_mps = 2, .depth_m = 0};
    Append(channels::Desired(name).name, desired);
    if (step % 10 == 0) {
      helm_state_t helm{};
      helm.utime = utime_;
      helm.vehicle = name;
      helm.state = Draw(5) == 0 ? "ALL-STOP" : "DRIVE";
      helm.all_stop = helm.state == "DRIVE" ? "clear" : "ManualOverride";
      helm.waypoint_index = Draw(3);
      Append(channels::HelmState(name).name, helm);
    }
    Append(channels::Nav(name).name, NavAt(utime_, 0.1 * step + Draw(20), Draw(20)));
    if (step % 10 == 5) {
      swarm_t swarm{};
      swarm.utime = utime_;
      swarm.vehicle = name;
      swarm.num_said = step;
      Append(channels::Swarm(name).name, swarm);
    }
  }

  std::vector<fate_t> MakeFates() {
    static const std::vector<std::string> kCauses = {"delivered", "out_of_range", "too_soon"};
    std::vector<fate_t> fates;
    for (const std::string& source : kTrafficNames) {
      for (const std::string& destination : kTrafficNames) {
        if (source == destination || Draw(2) == 0) continue;
        fate_t fate = FateOf(source, destination, kCauses[static_cast<size_t>(Draw(2))]);
        fate.number = ++num_sent_;
        fate.range_m = Draw(500);
        fate.limit_m = 250;
        if (Draw(3) == 0) fate = Through(fate, CalmPath(utime_ - 300'000));
        fates.push_back(fate);
      }
    }
    return fates;
  }

  std::mt19937 random_;
  int64_t utime_ = 0;
  int64_t num_sent_ = 0;
  std::vector<TestEvent> events_;
};

inline Mission TrafficMission() {
  Mission mission = MissionOf(kTrafficNames);
  mission.comms.pulse_duration_s = 5;
  return mission;
}

/// What TrafficMission() is as a mission file.
inline constexpr const char* kTrafficMissionText = R"(
[mission]
duration_s = 600
[[vehicle]]
name = "alpha"
[[vehicle]]
name = "Bravo"
[[vehicle]]
name = "c3"
)";

/// Opens a log of `events` that has TrafficMission() beside it.
inline std::unique_ptr<RecordedView> OpenTraffic(const TestDirectory& directory,
                                                 const std::vector<TestEvent>& events) {
  std::ofstream(directory.File("mission.toml")) << kTrafficMissionText;
  WriteLog(directory.File("mission.lcm"), events);
  auto view = RecordedView::Open(directory.File("mission.lcm"));
  EXPECT_TRUE(view.ok()) << view.error();
  return std::move(*view);
}

/// A frame without what differs in a recorded one: the clock, and events that a running
/// mission learns of later.
inline nlohmann::json ComparableFrame(const std::string& text) {
  nlohmann::json frame = nlohmann::json::parse(text);
  frame.erase("clock");
  frame.erase("num_events");
  return frame;
}

}  // namespace shoal
