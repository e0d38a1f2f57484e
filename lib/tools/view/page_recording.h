// A recorded mission as data of a page that is one file and asks no viewer: what the viewer would
// answer, at steps of time. web/net/page_recording.js reads it.
//
//   auto view = RecordedView::Open("runs/berta");
//   const PageRecording recording = RecordForPage(**view, (*view)->begin_s(), (*view)->end_s(),
//   {});
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lib/tools/view/view_source.h"

namespace shoal {

struct PageRecordingOptions {
  double step_s = 0;          ///< Between frames; 0: chosen by the length.
  size_t max_fates = 60'000;  ///< The newest are kept.
  size_t max_transmissions =
      60'000;  ///< Pulses, and packets; of more every second is left out, ...
  size_t max_background_bytes = 4'000'000;  ///< Of all backgrounds; larger ones are left out.
  /// Adds members of the caller's to the page's data, and notes about them.
  std::function<void(nlohmann::json* all, std::vector<std::string>* notes)> add_more = {};
};

struct PageRecording {
  std::string json;
  double step_s = 0;
  int64_t num_frames = 0;
  int64_t num_fates = 0;           ///< That the page has.
  std::vector<std::string> notes;  ///< What it has not, as the page shows it.
};

/// Asks `view` for all that a page shows between two times.
/// @pre begin_s <= end_s, finite; options.step_s >= 0
[[nodiscard]] PageRecording RecordForPage(ViewSource& view, double begin_s, double end_s,
                                          const PageRecordingOptions& options);

/// Returns the step in which a recording of this length has at most 2000 frames.
[[nodiscard]] double PageStep_s(double length_s);

/// Returns what makes `after` of `before`: [value] in place of what was there; else an object with
/// one entry per member, or element, that differs: its change, or 0 where it is gone.
/// @pre before != after
[[nodiscard]] nlohmann::json ChangeOf(const nlohmann::json& before, const nlohmann::json& after);

}  // namespace shoal
