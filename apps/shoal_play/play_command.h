// `shoal play`: a recording on LCM, as if its mission ran.
#pragma once

#include <string>

#include "apps/shoal_play/player.h"

namespace shoal {

/// Returns the exit code: 0; kExitUsage if the log or a name is wrong; kExitEnvironment.
int RunPlay(const PlayOptions& options);

/// Returns the mission that a recording is of: the one beside it, as far as its playing is
/// concerned; else one made of what the log holds.
[[nodiscard]] Mission MissionToPlay(const PlaybackLog& log);

}  // namespace shoal
