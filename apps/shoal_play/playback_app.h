// The participant that publishes what a log holds, step by step, as the mission did; and writes
// what others publish beside it into a second log.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/shoal_play/playback_log.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/record/channel_choice.h"
#include "lib/bus/record/log_writer.h"
#include "lib/run/run/app.h"

namespace shoal {

/// In its seals, and in `shoal status`.
inline constexpr char kPlaybackName[] = "playback";

struct PlaybackCounts {
  int64_t played = 0;
  int64_t bytes = 0;
  /// Messages of the stepping and of LCM itself, since a playback has its own; and messages whose
  /// channel's name LCM cannot send.
  int64_t left_out = 0;
  int64_t not_chosen = 0;
  int64_t repeated = 0;  ///< From before the place where the playing begins, and still in force.
  int64_t answers = 0;   ///< Messages of others, in the second log.
};

/// Returns true for a channel that is published again: all but ticks, orders to the clock, requests
/// and their answers, and LCM's own.
[[nodiscard]] bool IsPlayed(std::string_view channel);

class PlaybackApp : public App {
 public:
  /// Plays `log` from its present place on, after what holds there. Both pointers must outlive
  /// this; `answers` may be null: no second log.
  PlaybackApp(PlaybackLog* log, const ChannelChoice& channels, int64_t tick_us, LogWriter* answers,
              Bus& bus);

  /// Publishes the events of this step.
  void Tick(int64_t utime) override;
  void End() override { FlushAnswers(); }
  std::string Fault() const override { return fault_; }
  StatusPage Status() const override;

  /// A viewer that comes late asks for the rules.
  std::vector<std::string> RequestChannels() const override;
  std::optional<RequestAnswer> Answer(std::string_view channel,
                                      std::span<const uint8_t> data) const override;

  const PlaybackCounts& counts() const { return counts_; }
  /// True where all events have been published.
  bool is_at_end() const { return is_at_end_; }

 private:
  void PublishHolding();
  void PublishEvent(const LogEvent& event);
  void FlushAnswers();

  PlaybackLog& log_;
  const ChannelChoice channels_;
  const int64_t tick_us_;
  LogWriter* const answers_;
  Bus& bus_;
  int64_t utime_ = 0;
  std::optional<LogEvent> next_;
  bool has_begun_ = false;
  Bytes rules_;  ///< The last.
  bool is_at_end_ = false;
  PlaybackCounts counts_;
  std::string fault_;
};

}  // namespace shoal
