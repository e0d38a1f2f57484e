// Cursors in a log: each reads on from a keyframe to a moment.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "lib/tools/view/fate_history.h"
#include "lib/tools/view/log_index.h"
#include "shoal/comms_media_t.hpp"

namespace shoal {

/// Reads events in order of the timeline.
class LogWalk {
 public:
  LogWalk(LogReader reader, LogStamps stamps, const Keyframe& keyframe)
      : reader_(std::move(reader)),
        stamps_(stamps),
        timeline_(keyframe.timeline),
        offset_(keyframe.offset) {}

  /// Gives `take` the events that are not later than `line_us` and were not given before.
  template <class Take>
  void ReadUpTo(int64_t line_us, Take take) {
    reader_.Seek(offset_);
    while (const auto event = reader_.Next()) {
      offset_ = event->offset;
      RecordedTimeline next = timeline_;
      if (const auto utime = MissionUtimeOf(*event, stamps_)) next.Advance(*utime);
      if (next.now_us() > line_us) return;
      timeline_ = next;
      take(*event);
      offset_ = event->offset + kLogHeaderSize + event->channel.size() + event->data.size();
    }
    offset_ = reader_.size();
  }

  const RecordedTimeline& timeline() const { return timeline_; }
  uint64_t offset() const { return offset_; }
  LogReader& reader() { return reader_; }

 private:
  LogReader reader_;
  LogStamps stamps_;
  RecordedTimeline timeline_;
  uint64_t offset_;
};

/// The scene at a moment of a log.
class SceneCursor {
 public:
  /// `blank`: a scene that has seen nothing.
  SceneCursor(LogReader reader, LogStamps stamps, const Keyframe& keyframe, const Scene& blank);

  /// @pre line_us is not less than in the call before
  void GoTo(int64_t line_us);

  const Scene& scene() const { return scene_; }
  int64_t line_us() const { return line_us_; }
  uint64_t offset() const { return walk_.offset(); }

 private:
  LogWalk walk_;
  Scene scene_;
  int64_t line_us_ = 0;
};

/// The last fates before a moment of a log.
class FateCursor {
 public:
  FateCursor(LogReader reader, LogStamps stamps, const Keyframe& keyframe);

  /// @pre line_us is not less than in the call before
  void GoTo(int64_t line_us);

  const FateHistory& fates() const { return fates_; }
  int64_t line_us() const { return line_us_; }
  uint64_t offset() const { return walk_.offset(); }

 private:
  void TakeMedia(const LogEvent& event);

  LogWalk walk_;
  FateHistory fates_;
  FatesView message_;  ///< Its memory is used again, as that of the next.
  comms_media_t media_;
  int64_t line_us_ = 0;
};

/// Cursors that are not in use: several pages may look at several moments.
template <class Cursor>
class IdleCursors {
 public:
  explicit IdleCursors(size_t max_idle) : max_idle_(max_idle) {}

  /// Returns the cursor that is nearest to `line_us` and not behind it, and has read at least up to
  /// `offset`; or nullptr.
  std::unique_ptr<Cursor> Take(int64_t line_us, uint64_t offset) {
    const std::lock_guard lock(mutex_);
    auto best = idle_.end();
    for (auto it = idle_.begin(); it != idle_.end(); ++it) {
      if ((*it)->line_us() > line_us || (*it)->offset() < offset) continue;
      if (best == idle_.end() || (*it)->line_us() >= (*best)->line_us()) best = it;
    }
    if (best == idle_.end()) return nullptr;
    std::unique_ptr<Cursor> cursor = std::move(*best);
    idle_.erase(best);
    return cursor;
  }

  /// Forgets the one that was idle for longest where there are too many.
  void Return(std::unique_ptr<Cursor> cursor) {
    std::unique_ptr<Cursor> forgotten;  // outlives the lock
    const std::lock_guard lock(mutex_);
    if (idle_.size() == max_idle_) {
      forgotten = std::move(idle_.front());
      idle_.erase(idle_.begin());
    }
    idle_.push_back(std::move(cursor));
  }

 private:
  const size_t max_idle_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Cursor>> idle_;  ///< Those that were used last at the end.
};

}  // namespace shoal
