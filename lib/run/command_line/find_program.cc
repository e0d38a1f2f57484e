#include "lib/run/command_line/find_program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

namespace shoal {

namespace {

namespace fs = std::filesystem;

bool IsProgram(const fs::path& path) {
  std::error_code error;  // Folders of PATH may be closed to us.
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

/// Those that another program of shoal or a mission of missions/ starts.
constexpr std::string_view kOwnPrograms[] = {
    "acomms",         "acoustic_ping",    "c_planner",      "gateway",      "helm",
    "netsim_manager", "node_reporter",    "recorder",       "referee",      "shoal",
    "shoal-campaign", "shoal-encounters", "shoal-import",   "shoal-log",    "shoal-log-export",
    "shoal-plot",     "shoal-rays",       "shoal-rebroker", "shoal-viewer", "shore_broker",
    "vehicle_sim"};

bool IsOwn(std::string_view program) {
  return std::find(std::begin(kOwnPrograms), std::end(kOwnPrograms), program) !=
         std::end(kOwnPrograms);
}

/// Returns the CMake target of a program: `shoal-log` is made by shoal_log.
std::string TargetOf(std::string_view program) {
  if (program == "shoal-viewer") return "viewer";
  std::string target(program);
  std::replace(target.begin(), target.end(), '-', '_');
  return target;
}

}  // namespace

std::string ExecutableDirectory() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path().string();
}

Result<std::string> FindProgram(const std::string& program, const std::string& mission_file) {
  std::vector<fs::path> candidates;
  if (program.find('/') != std::string::npos) {
    candidates = {fs::path(program), fs::path(mission_file).parent_path() / program,
                  fs::path(ExecutableDirectory()) / program};
  } else {
    candidates.push_back(fs::path(ExecutableDirectory()) / program);
    const char* variable = std::getenv("PATH");
    const std::string path = variable == nullptr ? "" : variable;
    for (size_t begin = 0; begin < path.size();) {
      const size_t end = std::min(path.find(':', begin), path.size());
      candidates.push_back(fs::path(path.substr(begin, end - begin)) / program);
      begin = end + 1;
    }
  }
  for (const fs::path& candidate : candidates) {
    if (IsProgram(candidate)) return fs::absolute(candidate).string();
  }
  for (const fs::path& candidate : candidates) {
    std::error_code error;
    if (!fs::exists(candidate, error)) continue;
    return Error{fmt::format("{} is {}", fs::absolute(candidate).lexically_normal().string(),
                             fs::is_directory(candidate, error)
                                 ? "a folder, not a program"
                                 : "not executable: `chmod +x` it, or begin the command with its "
                                   "interpreter (command = [\"python3\", ...])")};
  }
  std::vector<std::string> places;
  for (const fs::path& candidate : candidates) {
    std::string place = fs::absolute(candidate).lexically_normal().string();
    if (std::find(places.begin(), places.end(), place) == places.end()) {
      places.push_back(std::move(place));
    }
  }
  if (IsOwn(program)) {
    return Error{fmt::format("the program {} {}", program, WhyMissing(program))};
  }
  constexpr size_t kMaxPlaces = 3;
  places.resize(std::min(places.size(), kMaxPlaces));
  return Error{
      fmt::format("cannot find the program '{}'; looked for {}", program, fmt::join(places, ", "))};
}

Result<std::string> FindBeside(const std::string& program) {
  const fs::path path = fs::path(ExecutableDirectory()) / program;
  if (IsProgram(path)) return path.string();
  return Error{fmt::format("the program {} {}", program, WhyMissing(program))};
}

std::string WhyMissing(const std::string& program) {
  std::error_code error;
  const fs::path folder = fs::path(ExecutableDirectory()).parent_path();
  if (!fs::exists(folder / "CMakeCache.txt", error)) {
    return fmt::format("is not in {}: install shoal again (docs/start/install.md)",
                       ExecutableDirectory());
  }
  // A path from the current folder, as one types it, unless it begins with "..".
  const fs::path near = fs::proximate(folder, error);
  const bool is_below = !error && !near.empty() && *near.begin() != "..";
  return fmt::format("is not built: cmake --build {} --target {}",
                     is_below ? near.string() : folder.string(), TargetOf(program));
}

std::string FindExecutable(std::string_view name, std::string_view search_path) {
  for (size_t begin = 0; begin < search_path.size();) {
    const size_t end = std::min(search_path.find(':', begin), search_path.size());
    const std::string_view folder = search_path.substr(begin, end - begin);
    begin = end + 1;
    if (folder.empty()) continue;
    const fs::path candidate = fs::path(folder) / name;
    std::error_code error;
    if (IsProgram(candidate)) return fs::absolute(candidate, error).string();
  }
  return {};
}

}  // namespace shoal
