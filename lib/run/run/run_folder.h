// The folder in which a user's running missions leave what commands and apps need to find them. It
// is this user's alone: another user who could write here could have this user's files overwritten
// through a symbolic link, read the viewer's token, or redirect commands to other ports.
//
//   <port>.run     the entry of a mission (lib/run/run/run_registry.h)
//   <port>.secret  its secret (lib/bus/bus/mission_secret.h)
//   <port>.ended   the verdict on the last mission there
//   <port>-logs/   the participants' output, of a run without --record
//
// Every function that touches the folder refuses one that is not this user's, or that others can
// use; the error states the remedy. Names are file names without a slash.
#pragma once

#include <string>
#include <string_view>

#include "lib/base/check/result.h"

namespace shoal {

/// Returns the folder's path: $SHOAL_RUN_DIR, $XDG_RUNTIME_DIR/shoal or /tmp/shoal-<uid>.
std::string RunFolder();

/// Makes the folder where it is missing, with mode 0700, and returns its path. An error where it is
/// a symbolic link, another user's, or open to others.
[[nodiscard]] Result<std::string> OpenRunFolder();

/// Writes a file of mode 0600 in place of what may bear its name, a symbolic link included, and
/// returns its path. Others see the old file or the new one, never a part.
[[nodiscard]] Result<std::string> WriteRunFile(std::string_view name, std::string_view text);

/// Returns the text of a file. An error where it is not a regular file of this user, where others
/// can write it, or where it is larger than 4 MiB.
[[nodiscard]] Result<std::string> ReadRunFile(std::string_view name);

/// Removes a file; one that is not there is no error.
void RemoveRunFile(std::string_view name);

/// Makes an empty folder of mode 0700, in place of a file or folder of this name, and returns its
/// path.
[[nodiscard]] Result<std::string> MakeRunSubfolder(std::string_view name);

}  // namespace shoal
