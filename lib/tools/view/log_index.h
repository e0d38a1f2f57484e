// An index of a whole log, built in one reading, so that any moment of the log can be shown by
// reading a small part of it again.
//
//   Result<LogReader> reader = LogReader::Open(path, OnDamage::kSkip);
//   Scene scene(mission);
//   const LogIndex index = BuildLogIndex(&*reader, &scene, mission, LogStamps::kMission);
//   const Keyframe& near = index.KeyframeBefore(1.5e6);
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lib/bus/record/log_reader.h"
#include "lib/bus/record/recorded_timeline.h"
#include "lib/tools/view/event_watch.h"
#include "lib/tools/view/link_book.h"
#include "lib/tools/view/recorded_charts.h"
#include "lib/tools/view/recorded_survey.h"
#include "lib/tools/view/scene.h"
#include "lib/tools/view/trail.h"

namespace shoal {

/// A message whose content holds until the next one of its channel and vehicle.
struct StandingMessage {
  uint64_t offset = 0;      ///< Of its event in the log.
  int64_t scene_utime = 0;  ///< The scene's time when it was read.
};

/// A position in a log from which reading can begin.
struct Keyframe {
  uint64_t offset = 0;        ///< Of the first event that is not yet in it.
  RecordedTimeline timeline;  ///< Up to there.
  int64_t scene_utime = 0;
  LinkBook links;
  MediaLinks media_links;
  int64_t num_fates = 0;  ///< As FateHistory numbers them.
  std::vector<bool> kinds_seen = std::vector<bool>(kNumKinds);
  std::vector<bool> causes_seen = std::vector<bool>(kNumCauses);
  /// The last of each vehicle's NAV, HELM_STATE, DESIRED, SWARM and node reports, and of the rules,
  /// in the order in which their first ones came, since that decides the order of vehicles.
  std::vector<StandingMessage> standing;
};

struct LogIndex {
  static constexpr size_t kMaxKeyframes = 256;
  static constexpr uint64_t kLeastGap_bytes = 16 << 10;  ///< Of the log, between keyframes.
  static constexpr size_t kMaxLinks = 500'000;           ///< Copies of counters in all keyframes.

  /// The last keyframe that holds nothing later than this; @pre one was built.
  const Keyframe& KeyframeBefore(int64_t line_us) const;

  std::vector<Keyframe> keyframes;  ///< In order; the first is the log's beginning.
  int64_t begin_us = 0;             ///< Of the timeline.
  int64_t end_us = 0;
  int64_t longest_pulse_us = 0;  ///< By the rules that were ever in force.
  std::vector<Trail> trails;     ///< By the vehicle's place in the scene.
  std::vector<RecordedChart> charts;
  std::vector<ViewEvent> events;  ///< In order of time; utime is that of the timeline.
  int64_t num_events = 0;         ///< Of the log.
  int64_t num_undecodable = 0;
  int64_t num_odd_times = 0;
  int64_t num_shifts = 0;                  ///< RecordedTimeline::num_shifts.
  std::vector<std::string> strange_rules;  ///< Of the first COMMS_RULES that has any.
  bool has_nav = false;
};

/// Called now and then with the share of the log that has been read; where it returns false the
/// reading ends there.
using IndexProgress = std::function<bool(double share)>;

/// Reads the whole of `reader`, from the start on. `scene` has seen nothing yet; then it shows the
/// end of the log, but for pulses.
[[nodiscard]] LogIndex BuildLogIndex(LogReader* reader, Scene* scene, const Mission& mission,
                                     LogStamps stamps, const IndexProgress& progress = {});

}  // namespace shoal
