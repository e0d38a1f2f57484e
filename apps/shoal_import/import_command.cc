#include "apps/shoal_import/import_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/mission/file/load.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/command_line/find_program.h"
#include "lib/run/command_line/tool_commands.h"
#include "lib/run/moos_text/fields.h"
#include "lib/tools/moos/bhv_file.h"
#include "lib/tools/moos/import.h"
#include "lib/tools/moos/import_names.h"
#include "lib/tools/moos/launch_script.h"
#include "lib/tools/moos/moos_file.h"
#include "lib/tools/moos/nsplug.h"

namespace shoal {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Result<std::string> ReadMoosFile(const std::string& path) {
  constexpr size_t kLargest_bytes = 10'000'000;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return Error{path + " is a directory; name the .moos and .bhv files in it"};
  }
  const File file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (file == nullptr) return Error{path + " cannot be read: " + std::strerror(errno)};
  std::string text;
  std::array<char, 65536> buffer;
  while (const size_t size = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    text.append(buffer.data(), size);
    if (text.size() > kLargest_bytes) return Error{path + " is larger than 10 MB: no .moos file"};
  }
  if (std::ferror(file.get()) != 0) return Error{path + " cannot be read to its end"};
  return text;
}

/// Returns the error; nothing where the file is written. "x": an existing file is not changed.
std::optional<Error> WriteNewFile(const std::string& path, std::string_view text, int* code) {
  File file(std::fopen(path.c_str(), "wx"), &std::fclose);
  if (file == nullptr && errno == EEXIST) {
    *code = kExitUsage;
    return Error{path + " exists already; name another file, or remove it first"};
  }
  *code = kExitEnvironment;
  if (file == nullptr) return Error{"cannot write " + path + ": " + std::strerror(errno)};
  const bool is_written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  if (std::fclose(file.release()) == 0 && is_written) return std::nullopt;
  return Error{"cannot write " + path + " to its end: is the disk full?"};
}

/// Finds an included file in the including file's folder, then in `paths`. Only regular files below
/// a folder that was named, however the name is written, so that a mission of others cannot have
/// any file of this machine copied into its comments.
std::optional<MoosSource> FindIncluded(std::string_view name, std::string_view from,
                                       const std::vector<std::string>& paths) {
  namespace fs = std::filesystem;
  if (name.empty() || fs::path(name).is_absolute()) return std::nullopt;
  std::vector<std::pair<fs::path, fs::path>> places = {{fs::path(from).parent_path(), name}};
  for (const std::string& list : paths) {
    for (size_t begin = 0; begin < list.size();) {
      const size_t end = std::min(list.find(':', begin), list.size());
      const std::string folder = list.substr(begin, end - begin);
      begin = end + 1;
      if (folder.empty()) continue;
      places.emplace_back(folder, name);
      places.emplace_back(folder, fs::path(name).filename());
    }
  }
  for (const auto& [folder, file] : places) {
    const fs::path path = (folder / file).lexically_normal();
    std::error_code error;
    const fs::path inside = fs::relative(path, folder.empty() ? fs::path(".") : folder, error);
    if (error || inside.empty() || *inside.begin() == "..") continue;
    if (!fs::is_regular_file(path, error)) continue;
    Result<std::string> text = ReadMoosFile(path.string());
    if (text.ok()) return MoosSource{.name = path.string(), .text = std::move(*text)};
  }
  return std::nullopt;
}

/// Reads NAME=VALUE pairs that are separated by blanks; a value with blanks is in double
/// quotes; a NAME alone is defined and stands for nothing. `is_one`: the whole text is one pair.
Result<MoosDefines> ReadDefines(std::string_view text, bool is_one) {
  const Error wrong{fmt::format("{} is not NAME=VALUE", Quoted(text))};
  MoosDefines defines;
  std::string_view rest = Trimmed(text);
  while (!rest.empty()) {
    const size_t equals = std::min(rest.find('='), rest.size());
    const size_t blank = std::min(rest.find_first_of(" \t"), rest.size());
    const bool is_bare = is_one ? equals == rest.size() : blank < equals || equals == rest.size();
    const std::string name(Trimmed(rest.substr(0, is_bare && !is_one ? blank : equals)));
    if (name.empty() || name.find_first_of(" \t\"") != name.npos) return wrong;
    if (is_bare) {
      defines[name] = kBareMacro;
      rest = Trimmed(rest.substr(is_one ? rest.size() : blank));
      continue;
    }
    rest.remove_prefix(equals + 1);
    size_t end = is_one ? rest.size() : std::min(rest.find_first_of(" \t"), rest.size());
    const bool is_quoted = rest.starts_with('"') && rest.find('"', 1) != rest.npos;
    if (is_quoted) end = rest.find('"', 1) + 1;
    defines[name] = Trimmed(rest.substr(is_quoted ? 1 : 0, end - (is_quoted ? 2 : 0)));
    rest = Trimmed(rest.substr(end));
  }
  if (defines.empty()) return wrong;
  return defines;
}

/// Removes files that are not missions: those that other files #include, and .moos files without a
/// block.
void LeaveOutPlugs(const FindMoosFile& find, std::vector<std::string>* files) {
  std::set<std::string> left_out;
  for (const std::string& path : *files) {
    const Result<std::string> text = ReadMoosFile(path);
    if (!text.ok()) continue;
    for (std::string_view rest = *text; !rest.empty();) {
      constexpr std::string_view kInclude = "#include";
      const size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view line = Trimmed(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (!line.starts_with(kInclude)) continue;
      std::string_view name = Trimmed(line.substr(kInclude.size()));
      const bool is_quoted = name.starts_with('"');
      if (is_quoted) name.remove_prefix(1);
      const std::string file =
          FileName(name.substr(0, name.find_first_of(is_quoted ? "\"" : " \t<")));
      if (file != FileName(path)) left_out.insert(file);
    }
    const bool is_mission =
        IsBhvName(path) ||
        !ParseMoosFile(Plug({.name = path, .text = *text}, {}, find)).blocks.empty();
    if (!is_mission) left_out.insert(FileName(path));
  }
  std::erase_if(*files, [&](const std::string& path) { return left_out.contains(FileName(path)); });
}

/// Returns true where a plugged file describes a vehicle.
bool IsAnyVehicle(const MoosImportOptions& how) {
  return std::any_of(how.runs.begin(), how.runs.end(), [&](const MoosRun& run) {
    return !IsBhvName(run.source.name) &&
           DescribesVehicle(ParseMoosFile(Plug(run.source, run.defines, how.find, run.options)));
  });
}

/// Names the scripts behind `last`, each of which may launch another vehicle; those that it calls
/// were read.
void NameUnread(const std::vector<std::string>& scripts, const std::string& last,
                const std::vector<std::string>& called, std::vector<std::string>* notes) {
  for (auto each = std::find(scripts.begin(), scripts.end(), last) + 1; each != scripts.end();
       ++each) {
    if (std::find(called.begin(), called.end(), *each) != called.end()) continue;
    notes->push_back(fmt::format(
        "{}: not read, since {} launches a vehicle already; write a launch.sh that calls both",
        *each, last));
  }
}

/// Reads a mission's folder: what its launch script plugs, or else its .moos and .bhv files. The
/// script is read, never run.
void ReadFolder(const std::string& folder, MoosImportOptions* how, std::vector<std::string>* files,
                std::vector<std::string>* notes) {
  namespace fs = std::filesystem;
  std::vector<std::string> scripts;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool is_made = name.starts_with("targ_");
    if (!fs::is_regular_file(entry.path(), error) || is_made) continue;
    if (name.starts_with("launch") && name.ends_with(".sh")) scripts.push_back(name);
    if (name.ends_with(".moos") || name.ends_with(".bhv")) files->push_back(entry.path().string());
  }
  std::sort(files->begin(), files->end());
  std::sort(scripts.begin(), scripts.end());
  const auto main = std::find(scripts.begin(), scripts.end(), "launch.sh");
  if (main != scripts.end()) std::rotate(scripts.begin(), main, main + 1);
  const std::string base = folder.ends_with('/') ? folder : folder + "/";
  const bool has_bhv = std::any_of(files->begin(), files->end(), IsBhvName);
  for (const std::string& name : scripts) {
    Result<std::string> text = ReadMoosFile(base + name);
    if (!text.ok()) continue;
    const LaunchPlan plan =
        ReadLaunchScript({.name = base + name, .text = std::move(*text)}, how->find);
    for (const LaunchFile& file : plan.files) {
      auto source = how->find(file.source, base + name);
      if (!source) {
        notes->push_back(fmt::format("{}: {} is not there", name, Quoted(file.source)));
        continue;
      }
      const bool is_there = std::any_of(
          how->runs.begin(), how->runs.end(),
          [&](const MoosRun& run) { return FileName(run.target) == FileName(file.target); });
      if (is_there) continue;
      how->runs.push_back({.source = std::move(*source),
                           .target = file.target,
                           .defines = file.defines,
                           .options = file.options});
    }
    if (plan.files.empty()) continue;
    how->pokes.insert(how->pokes.end(), plan.pokes.begin(), plan.pokes.end());
    notes->insert(notes->end(), plan.notes.begin(), plan.notes.end());
    // Shore and vehicles may have a script each: on to the first that plugs behaviors.
    const bool plugs_bhv = std::any_of(how->runs.begin(), how->runs.end(), [](const MoosRun& run) {
      return IsBhvName(run.source.name);
    });
    if (!plugs_bhv && has_bhv && !IsAnyVehicle(*how)) continue;
    // launch.sh calls those beside it, or they are for special cases.
    if (main == scripts.end()) NameUnread(scripts, name, plan.scripts, notes);
    break;
  }
  // Behaviors that no line plugs are found by their name.
  if (!how->runs.empty()) return files->clear();
  LeaveOutPlugs(how->find, files);
}

int Fail(const std::string& problem, int code) {
  fmt::print(stderr, "shoal: {}\n", problem);
  return code;
}

/// Returns "alder.toml" for "missions/alder/", and for "missions/alder.moos".
std::string OwnName(const std::string& path) {
  std::filesystem::path named = std::filesystem::path(path).lexically_normal();
  if (!named.has_filename()) named = named.parent_path();
  const std::string stem = named.stem().string();
  return (stem.empty() || stem.starts_with('.') ? "mission" : stem) + ".toml";
}

/// Checks the mission, and becomes `shoal run FILE --view`.
int RunMission(const std::string& path) {
  const LoadedMission loaded = LoadMission(path);
  for (const std::string& warning : loaded.warnings) fmt::print(stderr, "{}\n", warning);
  if (!loaded.errors.empty()) return Fail(loaded.errors.front(), kExitUsage);
  const Result<std::string> shoal = FindBeside("shoal");
  if (!shoal.ok()) return Fail(shoal.error(), kExitEnvironment);
  fmt::print("shoal run {} --view\n", path);
  return BecomeProgram(*shoal, {"run", path, "--view"});
}

}  // namespace

int RunImport(const ImportOptions& options) {
  MoosImportOptions how;
  for (const std::string& define : options.defines) {
    const Result<MoosDefines> defines = ReadDefines(define, true);
    if (!defines.ok()) return Fail("--define: " + defines.error(), kExitUsage);
    for (const auto& [name, value] : *defines) how.defines.insert_or_assign(name, value);
  }
  for (const std::string& vehicle : options.vehicles) {
    Result<MoosDefines> defines = ReadDefines(vehicle, false);
    if (!defines.ok()) return Fail("--vehicle: " + defines.error(), kExitUsage);
    how.vehicles.push_back(std::move(*defines));
  }
  how.deploys = options.runs;
  how.find = [&options](std::string_view name, std::string_view from) {
    return FindIncluded(name, from, options.paths);
  };
  std::vector<MoosSource> sources;
  bool is_any_moos = false;
  std::vector<std::string> notes;
  std::vector<std::string> files = options.files;
  if (files.size() == 1 && std::filesystem::is_directory(files.front())) {
    const std::string folder = std::exchange(files, {}).front();
    ReadFolder(folder, &how, &files, &notes);
    if (how.runs.empty() && files.empty()) {
      return Fail(folder + " has no .moos file: name the folder of one mission", kExitUsage);
    }
    is_any_moos = true;
  }
  for (const std::string& path : files) {
    Result<std::string> text = ReadMoosFile(path);
    if (!text.ok()) return Fail(text.error(), kExitUsage);
    MoosSource source{.name = path, .text = std::move(*text)};
    const PluggedText plugged = Plug(source, how.defines, how.find);
    if (IsBhvName(path)) {
      const BhvFile file = ParseBhvFile(plugged);
      if (file.behaviors.empty() && file.modes.empty() && file.initials.empty()) {
        return Fail(path + " is not a file of behaviors: it has no Behavior, set or initialize",
                    kExitUsage);
      }
    } else if (ParseMoosFile(plugged).blocks.empty()) {
      return Fail(path + " is not a MOOS mission file: it has no ProcessConfig block", kExitUsage);
    }
    is_any_moos = is_any_moos || !IsBhvName(path);
    sources.push_back(std::move(source));
  }
  if (!is_any_moos) {
    return Fail("behaviors belong to a vehicle: name its .moos file too", kExitUsage);
  }
  const MoosImport import = ImportMoos(sources, how);
  for (const std::string& note : notes) fmt::print(stderr, "{}\n", note);
  for (const std::string& warning : import.warnings) fmt::print(stderr, "{}\n", warning);
  const std::string out_path =
      options.out_path.empty() && options.runs ? OwnName(options.files.front()) : options.out_path;
  if (out_path.empty()) {
    fmt::print("{}", import.mission);
    return kExitOk;
  }
  int code = kExitOk;
  if (const auto error = WriteNewFile(out_path, import.mission, &code)) {
    return Fail(error->message, code);
  }
  fmt::print(
      "{}: vehicles: {}, warnings: {}; its comments name every line that has no counterpart\n",
      out_path, import.num_vehicles, import.warnings.size());
  for (const VehicleOutlook& outlook : import.outlooks) {
    fmt::print("{} {}: {}\n", outlook.vehicle,
               outlook.moves ? "moves after `deploy`" : "stays where it is", outlook.why);
  }
  for (const std::string& loss : import.lost) fmt::print("lost: {}\n", loss);
  if (options.runs) return RunMission(out_path);
  fmt::print("next: shoal run {} --view\n      shoal send all deploy\n", out_path);
  return kExitOk;
}

}  // namespace shoal
