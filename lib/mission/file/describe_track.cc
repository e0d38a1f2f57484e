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
  constexpr std::array<std::pair<std::string_view, DepthPositive>, 3> kPositives = {{
      {"by_form", DepthPositive::kByForm},
      {"down", DepthPositive::kDown},
      {"up", DepthPositive::kUp},
  }};
  if (fields.Has("file", !options.file.empty())) {
    fields.Text("file", options.file, {.min_length = 1, .max_length = 1000});
  }
  fields.Choice("time", options.time, kTimes);
  fields.Number("delay_s", options.delay_s, Between(-kLongest_s, kLongest_s));
  fields.Flag("underwater", options.underwater);
  fields.Choice("depth_positive", options.depth_positive, kPositives);
  if (fields.Has("depth_positive", false) && !options.underwater) {
    fields.Warn("depth_positive", "depth_positive has no effect without underwater = true");
  }
  if (fields.Has("name", !options.name.empty())) {
    fields.Text("name", options.name, {.min_length = 1, .max_length = 100});
  }
  if (fields.Has("number", options.number != 0)) {
    fields.Integer("number", options.number, 1, 1'000'000);
  }
  if (!options.name.empty() && options.number != 0) {
    fields.Refuse("number", "a track is chosen by its name or by its number: leave one out");
  }
}

}  // namespace shoal
