// A recorded mission that is shown at once, however long its log is: first its begin, while another
// thread reads all of it.
//
//   Result<std::unique_ptr<GrowingLog>> log = GrowingLog::Open("runs/mine", "");
//   log->source()->FrameJson(12.5);
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "lib/base/check/result.h"
#include "lib/tools/view/recorded_view.h"

namespace shoal {

/// The begin of a log, and the share of the whole log that has been read meanwhile.
class PartView;

class GrowingLog {
 public:
  /// What is read in this time is shown first; a log that takes no longer is shown as a whole.
  static constexpr int64_t kFirst_us = 1'200'000;

  /// `now_us` returns wall time that never jumps. Errors as those of RecordedView::Open.
  [[nodiscard]] static Result<std::unique_ptr<GrowingLog>> Open(const std::string& path,
                                                                const std::string& mission_file,
                                                                std::function<int64_t()> now_us);
  ~GrowingLog();

  /// Returns the present view; any thread may call it.
  std::shared_ptr<ViewSource> source() const;
  /// Waits until all has been read.
  void AwaitAll();

 private:
  GrowingLog() = default;
  void ReadAll(const std::string& path, const std::string& mission_file);

  mutable std::mutex mutex_;
  std::shared_ptr<ViewSource> source_;
  std::atomic<bool> stopped_ = false;
  std::shared_ptr<PartView> part_;  ///< Null where the first view is the whole.
  std::thread reading_;             ///< Not started where the first view is the whole.
};

}  // namespace shoal
