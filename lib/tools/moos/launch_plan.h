// What a launch script makes of a mission's files: which are plugged with which macros, and what it
// posts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/import_buttons.h"
#include "lib/tools/moos/nsplug.h"
#include "lib/tools/moos/shell_run.h"
#include "lib/tools/moos/shell_text.h"

namespace shoal {

/// One file that is plugged, or that is used as it is.
struct LaunchFile {
  std::string source;   ///< "meta_vehicle.moos".
  std::string target;   ///< "targ_abe.moos"; the source's name where it is used as it is.
  MoosDefines defines;  ///< What nsplug is given.
  PlugOptions options = {};
};

struct LaunchPlan {
  std::vector<LaunchFile> files;
  std::vector<MoosButton> pokes;     ///< What each line of uPokeDB posts.
  std::vector<std::string> notes;    ///< "launch.sh:12: ...": what could not be read.
  std::vector<std::string> scripts;  ///< That it calls, without their folders.
};

/// Takes the commands of a script that make the plan; `words` are without the command's name.
class LaunchPlanDraft {
 public:
  /// `nsplug meta_vehicle.moos targ_abe.moos VNAME=abe --macros=FILE`.
  void TakeNsplug(const ShellWords& words, int line, ShellRun* run);
  /// `uPokeDB targ_shore.moos DEPLOY_ALL=true SPEED:=1.5`; of several "=" the first counts.
  void TakePoke(const ShellWords& words, int line, const ShellRun& run);
  /// A file that is used as it is, where it is there and no other has become it.
  void AddPlain(const std::string& name, const ShellRun& run);

  LaunchPlan& plan() { return plan_; }

 private:
  static void TakeOption(const ShellWords& words, size_t at, LaunchFile* file);
  static void AddMacros(const std::string& name, int line, ShellRun* run, LaunchFile* file);
  void AddFile(LaunchFile file);
  LaunchFile* FindFile(const LaunchFile& file);

  LaunchPlan plan_;
};

}  // namespace shoal
