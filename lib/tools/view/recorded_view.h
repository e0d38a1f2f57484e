// A recorded mission as the viewer's page shows it.
//
//   auto view = RecordedView::Open("runs/berta");     // or runs/berta/mission.lcm
//   if (!view.ok()) return Fail(view.error());
//   (*view)->FrameJson(312.5);
//
// Opening reads the log once (lib/tools/view/log_index.h). A moment is shown by reading on from the
// keyframe before it, or from where another moment was shown a little earlier. The log is read in
// pieces, not mapped: if the file is cut while it is open, the view ends there and the process goes
// on.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/record/index_file.h"
#include "lib/mission/file/background_files.h"
#include "lib/mission/model/mission.h"
#include "lib/tools/view/link_history.h"
#include "lib/tools/view/log_index.h"
#include "lib/tools/view/recorded_cursor.h"
#include "lib/tools/view/scene.h"
#include "lib/tools/view/view_source.h"

namespace shoal {

struct RecordedViewOptions {
  std::string mission_file = {};            ///< Empty: the one beside the log, if any.
  std::vector<std::string> overrides = {};  ///< Of `mission_file`.
  std::string boot = {};                    ///< Names this start of the viewer.
  IndexProgress progress = {};              ///< Of the reading; it may end it.
  /// The index of a log with as many bytes is kept beside it, and used.
  uint64_t least_indexed_bytes = kLeastIndexedLog_bytes;
};

class RecordedView : public ViewSource {
 public:
  /// Opens a log, or the folder of `shoal run --record`. Damages are left out and named in the
  /// notes; a log of which nothing can be read is an error, as is a `mission_file` that does not
  /// load. Errors state what to try.
  static Result<std::unique_ptr<RecordedView>> Open(const std::string& path,
                                                    const RecordedViewOptions& options = {});

  /// What a user should know about the log.
  const std::vector<std::string>& notes() const { return notes_; }
  const Mission& mission() const { return mission_; }
  double begin_s() const { return Seconds(index_.begin_us); }
  double end_s() const { return Seconds(index_.end_us); }

  /// Returns the setup with another start's name and one more note.
  std::string SetupJsonWith(const std::string& boot, const std::string& note) const;

  // Times outside of the log are clamped to it.
  std::string SetupJson(bool commands) override;
  std::string FrameJson(double t_s) override;
  std::string TrailsJson() override;
  std::string LinksJson(double t_s) override;
  Result<std::string> MediumLinksJson(std::string_view medium, double t_s) override;
  /// Of the last FateHistory::kMaxFates.
  std::string FatesJson(const FateQuery& query, double t_s) override;
  std::string EventsJson() override;
  std::string VerdictJson() override;
  BackgroundFolder Backgrounds() override { return BackgroundsOf(mission_); }
  /// Fates and ranges are of the last FateHistory::kMaxFates of all links.
  Result<std::string> LinkJson(std::string_view from, std::string_view to, double t_s) override;
  Result<std::string> VehicleJson(std::string_view name, double t_s, double window_s) override;

 private:
  RecordedView(LogReader reader, LogStamps stamps, Mission mission, bool knows_rules);

  std::string MakeSetupJson(const std::string& boot, const std::vector<std::string>& notes) const;
  int64_t LineOf(double t_s) const;
  /// Returns a cursor at `line_us`; give it back to the idle ones.
  std::unique_ptr<SceneCursor> SceneAt(int64_t line_us);
  std::unique_ptr<FateCursor> FatesAt(int64_t line_us);
  std::vector<RatioBin> RatioBins(const LinkCounts& link, int64_t line_us) const;
  Error NoSuchVehicle(std::string_view name) const;

  LogReader reader_;  ///< Of which the others are made; has read the whole log.
  const LogStamps stamps_;
  const Mission mission_;
  const Scene blank_;  ///< Has seen nothing.
  LogIndex index_;
  std::vector<std::string> notes_;
  Mission shown_;  ///< As the setup has it.
  bool knows_mission_ = false;
  std::string floor_json_;
  std::string setup_json_;
  std::string trails_json_;
  std::string events_json_;
  std::string verdict_json_;
  IdleCursors<SceneCursor> idle_scenes_;
  IdleCursors<FateCursor> idle_fates_;
};

}  // namespace shoal
