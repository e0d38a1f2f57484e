// shoal-viewer from its command line to its exit code.
#pragma once

#include "apps/viewer/viewer_options.h"

namespace shoal {

/// Serves until a signal comes. Prints the page's address as its first line. Returns the exit code
/// (lib/base/check/result.h).
int RunViewer(const ViewerOptions& options);

/// The main function of shoal-viewer.
int RunShoalViewer(int argc, char** argv);

}  // namespace shoal
