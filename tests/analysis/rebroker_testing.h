// For tests of `shoal rebroker` only: a small mission with all that a broker handles, and its log.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "lib/bus/bus/seal.h"
#include "lib/bus/record/log_reader.h"
#include "lib/bus/record/log_testing.h"
#include "lib/mission/file/load.h"
#include "lib/tools/rebroker/comms_log.h"
#include "sim/simulation.h"

namespace shoal {

/// Groups, a far vehicle, losses, messages with and without acks, and every sort of control.
constexpr char kMixedTraffic[] = R"(
[mission]
duration_s = 20
seed = 7
[comms]
comms_range = 80
critical_range = 10
min_msg_interval = 2
min_rpt_interval = 0.5
drop_percentage = 30
groups = true
[[vehicle]]
name = "alpha"
group = "red"
[[vehicle]]
name = "bravo"
group = "red"
start = { x_m = 60, y_m = 0, heading_deg = 0 }
[[vehicle]]
name = "charlie"
group = "blue"
start = { x_m = 0, y_m = 70, heading_deg = 0 }
stealth = 0.5
[[event]]
at_s = 5
message = { src_node = "alpha", dest_node = "all", var_name = "A", string_val = "1", ack = true }
[[event]]
at_s = 6
message = { src_node = "bravo", dest_group = "red", var_name = "B", double_val = 2 }
[[event]]
at_s = 7
message = { src_node = "bravo", dest_group = "red", var_name = "B", double_val = 3 }
[[event]]
at_s = 7
rule = "comms_range"
value = 200
[[event]]
at_s = 8
rule = "stealth"
vehicle = "charlie"
value = 0.9
[[event]]
at_s = 9
rule = "full_report"
vehicle = "charlie"
)";

/// Three vehicles that send acoustically, with losses, damage and collisions.
constexpr char kAcousticTraffic[] = R"(
[mission]
duration_s = 40
seed = 7
[comms]
comms_range = 500
min_msg_interval = 2
reports_over = "acoustic"
messages_over = "acoustic"
[acoustics]
crc = false
access_mode = "shared"
collisions = "corrupt"
half_duplex = true
bit_error_rate = 0.002
packet_loss = 0.2
data_rate_bps = 3000
[[vehicle]]
name = "alpha"
reporter = { rate_hz = 10, blackout_interval_s = 1, blackout_variance_s = 0.9 }
[[vehicle]]
name = "bravo"
start = { x_m = 300, y_m = 0, heading_deg = 0 }
reporter = { rate_hz = 10, blackout_interval_s = 1, blackout_variance_s = 0.9 }
[[vehicle]]
name = "charlie"
start = { x_m = 0, y_m = 400, heading_deg = 0 }
reporter = { rate_hz = 10, blackout_interval_s = 2, blackout_variance_s = 1.9 }
[[event]]
at_s = 5
message = { src_node = "alpha", dest_node = "all", var_name = "A", string_val = "1", ack = true }
[[event]]
at_s = 15
message = { src_node = "bravo", dest_node = "alpha", var_name = "B", double_val = 2 }
)";

inline Mission TestMission(const std::string& text) {
  LoadedMission loaded = LoadMissionText(text, "test.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

/// Runs the mission in one process and writes its log.
inline void Record(const std::string& text, const std::string& path) {
  const Mission mission = TestMission(text);
  Simulation simulation(mission, path);
  while (simulation.Step()) {
  }
  ASSERT_EQ(simulation.Fault(), "");
}

inline std::vector<TestEvent> EventsOf(const std::string& path) {
  std::vector<TestEvent> events;
  Result<LogReader> reader = LogReader::Open(path);
  if (!reader.ok()) {
    ADD_FAILURE() << reader.error();
    return events;
  }
  while (const auto event = reader->Next()) {
    events.push_back(
        {event->utime, std::string(event->channel), {event->data.begin(), event->data.end()}});
  }
  return events;
}

inline CommsLog LogOf(const std::vector<TestEvent>& events,
                      std::optional<int64_t> tick_us = std::nullopt) {
  CommsLogBuilder builder;
  for (const TestEvent& event : events) {
    builder.Add({.utime = event.utime, .channel = event.channel, .data = event.data});
  }
  return builder.Build(tick_us);
}

/// Returns the log as lcm-logger would have written it: wall times, and seals. The publisher is
/// the channel's name: where each has one, that is the fixed order too.
inline std::vector<TestEvent> Sealed(std::vector<TestEvent> events, int64_t tick_us = 100'000,
                                     int64_t mission_id = 42) {
  uint32_t sequence = 0;
  for (TestEvent& event : events) {
    AppendSeal({.publisher = event.channel,
                .mission_id = mission_id,
                .step = event.utime / tick_us,
                .sequence = sequence++},
               MissionSecret{}, event.channel, &event.data);
    event.utime = 1'700'000'000'000'000 + event.utime / 10 + sequence;
  }
  return events;
}

}  // namespace shoal
