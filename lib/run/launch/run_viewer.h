// `shoal view`: the viewer, of a recorded mission or beside a running one.
#pragma once

#include "lib/run/launch/viewer_arguments.h"

namespace shoal {

/// Turns this process into shoal-viewer. Returns, with the exit code, only where that fails.
int RunView(const ViewOptions& options);

/// The same, of the recorded mission that comes with shoal (examples/recorded). Its absence is an
/// error of the installation: kExitEnvironment.
int RunViewOfExample(ViewOptions options);

}  // namespace shoal
