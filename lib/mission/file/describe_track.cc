// The table [vehicle.track].
#include <array>
#include <string_view>
#include <utility>

#include "lib/mission/file/describe.h"
#include "lib/mission/model/track_model.h"

namespace shoal {

void Describe(Fields& fields, TrackOptions& options) {
  constexpr std::array<std::pair<std::string_view, TrackTime>, 2> kTimes = {{
      {"first", TrackTime::kFirst},
      {"absolute", TrackTime::kAbsolute},
  }};
  if (fields.Has("file", !options.file.empty())) {
    fields.Text("file", options.file, {.min_length = 1, .max_length = 1000});
  }
  fields.Choice("time", options.time, kTimes);
  fields.Number("delay_s", options.delay_s, Between(-kLongest_s, kLongest_s));
  fields.Flag("underwater", options.underwater);
}

}  // namespace shoal
