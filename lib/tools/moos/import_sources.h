// The files that an import is made of: each as nsplug writes it, templates once for each vehicle.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/import.h"
#include "lib/tools/moos/import_losses.h"
#include "lib/tools/moos/moos_file.h"
#include "lib/tools/moos/nsplug.h"

namespace shoal {

/// Returns what pHelmIvP names as the file of behaviors; nullptr: nothing.
[[nodiscard]] const MoosLine* BehaviorsLine(const MoosFile& file);

class ImportSources {
 public:
  /// `options` outlive this.
  ImportSources(std::span<const MoosSource> sources, const MoosImportOptions& options,
                ImportLosses* losses);

  const std::vector<MoosFile>& files() const { return files_; }
  /// What the file with this index was plugged with.
  const MoosDefines& defines(size_t index) const { return defines_[index]; }

  /// Finds the file of behaviors of a vehicle's file, and adds what it is plugged with.
  std::optional<MoosSource> FindBhv(size_t index, MoosDefines* defines, PlugOptions* options);

  /// Returns the names of all files of behaviors that are given.
  std::vector<std::string> BhvNames() const;
  /// Returns those that no vehicle has, and that were not plugged.
  std::vector<std::string> UnusedBhvNames() const;

 private:
  struct BhvSource {
    MoosSource source;
    std::string target = {};   ///< What nsplug wrote; empty: it did not run.
    MoosDefines defines = {};  ///< What it was given.
    PlugOptions options = {};
    bool is_used = false;
  };

  void AddRuns();
  void FindTemplates(std::span<const MoosSource> sources, ImportLosses* losses);
  bool IsTemplateOf(const MoosSource& source, size_t vehicle) const;
  BhvSource* GivenBhv(std::string_view name);

  const MoosImportOptions& options_;
  std::vector<std::string> templates_;  ///< Names of files that describe vehicles.
  std::vector<BhvSource> bhv_sources_;
  std::vector<MoosFile> files_;
  std::vector<MoosDefines> defines_;  ///< Of each file.
};

}  // namespace shoal
