// Writes frames: GET /api/frame and the stream (docs/extending/viewer_protocol.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lib/run/orders/command_record.h"
#include "lib/tools/view/scene.h"
#include "lib/tools/view/view_clock.h"

namespace shoal {

/// What a frame shows beside the scene.
struct FrameParts {
  double t_s = 0;
  ViewClock clock;
  std::vector<const ViewPulse*> pulses;
  int64_t pulses_left_out = 0;
  std::vector<const AcousticPacket*> packets;
  std::span<const CommandRecord> commands = {};
  int64_t num_events = 0;
  int64_t num_fates = 0;
};

[[nodiscard]] std::string FrameJson(const Scene& scene, const FrameParts& parts);

/// Returns the parts that a frame of a whole moment has: the scene's time, all pulses and packets
/// that are not over, and its number of fates.
[[nodiscard]] FrameParts WholeFrame(const Scene& scene);

}  // namespace shoal
