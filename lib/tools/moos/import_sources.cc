#include "lib/tools/moos/import_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/import_names.h"
#include "lib/tools/moos/import_settings.h"

namespace shoal {
namespace {

constexpr char kTemplate[] = "TEMPLATE";  ///< Of --vehicle: which file it is made of.

/// Returns the apps of lines of ANTLER that are comments.
std::vector<std::string> StoppedApps(std::string_view text) {
  std::vector<std::string> apps;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = Trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.starts_with("//")) continue;
    line = Trimmed(line.substr(2));
    const size_t equals = line.find('=');
    if (equals == line.npos || LowerCase(Trimmed(line.substr(0, equals))) != "run") continue;
    apps.push_back(AppNameOfRun(Trimmed(line.substr(equals + 1))));
  }
  return apps;
}

/// Gives blocks with a name of their own the app that ANTLER runs under it:
/// `Run = uTimerScript @ NewConsole = false ~ uTimerScript_PING`.
MoosFile WithAppsOfNames(MoosFile file, std::string_view source) {
  file.stopped_apps = StoppedApps(source);
  std::map<std::string, std::string> apps;  // By names in lower case.
  for (const MoosBlock& block : file.blocks) {
    if (AppClass(block.app) != "antler") continue;
    for (const MoosLine& line : block.lines) {
      const size_t tilde = line.value.find('~');
      if (LowerCase(line.key) != "run" || tilde == line.value.npos) continue;
      const std::string name = LowerCase(Trimmed(line.value.substr(tilde + 1)));
      if (!name.empty()) apps.emplace(name, AppNameOfRun(line.value));
    }
  }
  for (MoosBlock& block : file.blocks) {
    const auto app = apps.find(LowerCase(block.app));
    if (app != apps.end()) block.app = app->second;
  }
  return file;
}

}  // namespace

const MoosLine* BehaviorsLine(const MoosFile& file) {
  const MoosLine* named = nullptr;
  for (const MoosBlock& block : file.blocks) {
    if (AppClass(block.app) != "phelmivp") continue;
    for (const MoosLine& line : block.lines) {
      if (LowerCase(line.key) == "behaviors") named = &line;
    }
  }
  return named;
}

ImportSources::ImportSources(std::span<const MoosSource> sources, const MoosImportOptions& options,
                             ImportLosses* losses)
    : options_(options) {
  FindTemplates(sources, losses);
  for (const MoosSource& source : sources) {
    if (IsBhvName(source.name)) {
      bhv_sources_.push_back({.source = source, .target = {}, .defines = {}});
      continue;
    }
    MoosFile file =
        WithAppsOfNames(ParseMoosFile(Plug(source, options.defines, options.find)), source.text);
    if (options.vehicles.empty() || !DescribesVehicle(file)) {
      files_.push_back(std::move(file));
      defines_.push_back(options.defines);
      continue;
    }
    for (size_t i = 0; i < options.vehicles.size(); ++i) {
      if (!IsTemplateOf(source, i)) continue;
      MoosDefines defines = options.vehicles[i];
      defines.insert(options.defines.begin(), options.defines.end());
      files_.push_back(
          WithAppsOfNames(ParseMoosFile(Plug(source, defines, options.find)), source.text));
      defines_.push_back(std::move(defines));
    }
  }
  AddRuns();
}

/// Adds the files of a launch script.
void ImportSources::AddRuns() {
  for (const MoosRun& run : options_.runs) {
    MoosDefines defines = run.defines;
    defines.insert(options_.defines.begin(), options_.defines.end());
    if (IsBhvName(run.source.name)) {
      bhv_sources_.push_back(
          {.source = run.source, .target = run.target, .defines = defines, .options = run.options});
      continue;
    }
    files_.push_back(WithAppsOfNames(
        ParseMoosFile(Plug(run.source, defines, options_.find, run.options)), run.source.text));
    defines_.push_back(std::move(defines));
  }
}

/// Lists the files that describe vehicles.
void ImportSources::FindTemplates(std::span<const MoosSource> sources, ImportLosses* losses) {
  if (options_.vehicles.empty()) return;
  for (const MoosSource& source : sources) {
    if (IsBhvName(source.name)) continue;
    if (DescribesVehicle(ParseMoosFile(Plug(source, options_.defines, options_.find)))) {
      templates_.push_back(source.name);
    }
  }
  const bool any_named =
      std::any_of(options_.vehicles.begin(), options_.vehicles.end(),
                  [](const MoosDefines& vehicle) { return vehicle.contains(kTemplate); });
  if (templates_.size() < 2 || any_named) return;
  const bool is_one_each = templates_.size() == options_.vehicles.size();
  losses->Warn(
      fmt::format("{} templates and {} vehicles: {}; write {}=NAME.moos in --vehicle to choose",
                  templates_.size(), options_.vehicles.size(),
                  is_one_each ? "the first vehicle is of the first, and so on"
                              : "all vehicles are of " + CleanUtf8(templates_.front()),
                  kTemplate));
}

/// Returns true where a vehicle is made of a template: the one that it names, or else the one in
/// its place where there are as many of both, or else the first.
bool ImportSources::IsTemplateOf(const MoosSource& source, size_t vehicle) const {
  if (templates_.size() < 2) return true;
  const auto named = options_.vehicles[vehicle].find(kTemplate);
  if (named != options_.vehicles[vehicle].end()) {
    return FileName(source.name) == FileName(named->second);
  }
  const bool is_one_each = templates_.size() == options_.vehicles.size();
  return source.name == templates_[is_one_each ? vehicle : 0];
}

/// Returns the given file of behaviors with this name, nullptr: there is none.
ImportSources::BhvSource* ImportSources::GivenBhv(std::string_view name) {
  for (BhvSource& given : bhv_sources_) {
    const std::string& written = given.target.empty() ? given.source.name : given.target;
    if (FileName(written) == FileName(name)) return &given;
  }
  return nullptr;
}

std::optional<MoosSource> ImportSources::FindBhv(size_t index, MoosDefines* defines,
                                                 PlugOptions* options) {
  const MoosFile& file = files_[index];
  std::vector<std::string> names;
  if (const MoosLine* line = BehaviorsLine(file)) {
    names.push_back(line->value);
    // What nsplug writes, and what it reads.
    const std::string written = FileName(line->value);
    if (written.starts_with("targ_")) names.push_back("meta_" + written.substr(5));
  }
  names.push_back(Stem(file.name) + ".bhv");
  for (const std::string& name : names) {
    if (BhvSource* given = GivenBhv(name)) {
      given->is_used = true;
      for (const auto& [macro, value] : given->defines) defines->insert_or_assign(macro, value);
      *options = given->options;
      return given->source;
    }
  }
  if (bhv_sources_.size() == 1) {
    bhv_sources_.front().is_used = true;
    return bhv_sources_.front().source;
  }
  for (const std::string& name : names) {
    auto found = options_.find == nullptr ? std::nullopt : options_.find(name, file.name);
    if (found) return found;
  }
  return std::nullopt;
}

std::vector<std::string> ImportSources::BhvNames() const {
  std::vector<std::string> names;
  for (const BhvSource& given : bhv_sources_) names.push_back(given.source.name);
  return names;
}

std::vector<std::string> ImportSources::UnusedBhvNames() const {
  std::vector<std::string> names;
  for (const BhvSource& given : bhv_sources_) {
    if (!given.is_used && given.target.empty()) names.push_back(given.source.name);
  }
  return names;
}

}  // namespace shoal
