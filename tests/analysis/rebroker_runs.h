// For tests of Rebroker: logs of the missions of rebroker_testing.h, decided again.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "lib/tools/rebroker/rebroker.h"
#include "sim/app_factory.h"
#include "tests/analysis/rebroker_testing.h"

namespace shoal {

/// Returns the setup by the rules in the log.
inline BrokerSetup SetupFor(const CommsLog& log) {
  const Result<BrokerSetup> setup = SetupOf(*log.rules);
  EXPECT_TRUE(setup.ok());
  return *setup;
}

/// Decides again by the recorded rules; `out` takes the log that this gives.
inline RebrokerOutcome AsRecorded(const CommsLog& log, std::vector<TestEvent>* out = nullptr) {
  EventSink sink;
  if (out != nullptr) {
    sink = [out](int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
      out->push_back({utime, std::string(channel), {data.begin(), data.end()}});
    };
  }
  return Rebroker(log, {.setup = SetupFor(log), .absences = AbsencesIn(log)}, MakeShoreBroker,
                  sink);
}

/// Of broker and log alone: what `shoal rebroker --log` writes.
inline bool IsOfBroker(const std::string& channel) {
  const auto& names = BrokerChannels();
  return std::find(names.begin(), names.end(), channel) != names.end() ||
         channel == "VIEW_COMMS_PULSE" || channel.starts_with("NODE_REPORT_") ||
         channel.starts_with("NODE_MESSAGE_") || channel.starts_with("ACK_MESSAGE_") ||
         channel.starts_with("ACOUSTIC_RX_");
}

/// Returns the log of a mission.
inline std::vector<TestEvent> RecordedEvents(const std::string& mission = kMixedTraffic) {
  const TestDirectory directory;
  Record(mission, directory.File("m.lcm"));
  return EventsOf(directory.File("m.lcm"));
}

/// Counts fates: "report delivered" and so on.
inline std::map<std::string, int64_t> CausesOf(const std::vector<TestEvent>& events) {
  std::map<std::string, int64_t> causes;
  for (const TestEvent& event : events) {
    comms_fates_t fates;
    if (event.channel != "COMMS_FATES" || !Decode(event.data, &fates)) continue;
    for (const fate_t& fate : fates.fates) causes[fate.kind + " " + fate.cause] += fate.count;
  }
  return causes;
}

}  // namespace shoal
