// A recorded mission as one file of HTML: the page of the viewer with all that it shows, for a
// browser without a viewer and without a network.
#pragma once

#include <string>
#include <string_view>

#include "apps/viewer/page_files.h"
#include "lib/base/check/result.h"

namespace shoal {

/// Returns the page of `files` with `recording` (PageRecording::json) in it. Its security policy
/// names scripts and styles by their hashes, and lets nothing else run or be loaded.
[[nodiscard]] Result<std::string> SelfContainedPage(const PageFiles& files,
                                                    std::string_view recording);

/// Returns `bytes` in the format of zlib (RFC 1950), in base64.
[[nodiscard]] std::string DeflatedBase64(std::string_view bytes);

struct ExportOptions {
  std::string log;           ///< A log, or the folder of a recording.
  std::string mission_file;  ///< Empty: the one beside the log.
  std::string path;          ///< Of the page.
  double step_s = 0;         ///< Between frames; 0: chosen by the length.
};

/// Writes the page, after a line about its size on standard output. Returns the exit code.
int ExportPage(const PageFiles& files, const ExportOptions& options);

}  // namespace shoal
