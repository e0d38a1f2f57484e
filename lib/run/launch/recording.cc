#include "lib/run/launch/recording.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "lib/base/arithmetic/arithmetic_id.h"
#include "lib/bus/os/text_file.h"
#include "lib/mission/file/background_files.h"
#include "lib/mission/file/data_files.h"
#include "lib/run/command_line/version.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

Result<bool> WriteText(const fs::path& path, const std::string& text) {
  if (TextFile(path.string(), text).Flush()) return true;
  return Error{
      fmt::format("cannot write {}: is the disk full, or the folder not yours?", path.string())};
}

/// Copies what the mission reads beside its file, so that the recording holds it too. What lies
/// outside the mission's folder is found by its own path, and stays there.
Result<bool> CopyDataFiles(const fs::path& dir, const Mission& mission) {
  const fs::path folder = fs::path(mission.file).parent_path();
  std::vector<std::string> files = DataFilesOf(mission);
  for (const std::string& file : BackgroundFilesThere(mission)) {
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  }
  for (const std::string& file : files) {
    const fs::path relative = fs::path(file).lexically_normal();
    if (relative.is_absolute() || *relative.begin() == "..") continue;
    std::error_code error;
    fs::create_directories((dir / relative).parent_path(), error);
    if (!error) fs::copy_file(folder / relative, dir / relative, error);
    if (error) {
      return Error{fmt::format("cannot copy {} to {}: {}", (folder / relative).string(),
                               (dir / relative).string(), error.message())};
    }
  }
  return true;
}

}  // namespace

Result<bool> PrepareRecording(const RunOptions& options, const Mission& mission) {
  const fs::path dir(options.record_dir);
  std::error_code error;
  fs::create_directories(dir, error);
  if (!fs::is_directory(dir)) {
    return Error{fmt::format("cannot make the folder {}: {}", dir.string(), error.message())};
  }
  if (!fs::is_empty(dir, error) || error) {
    return Error{
        fmt::format("{} is not empty: it holds a recording, or files of yours; name a new folder",
                    dir.string())};
  }
  std::ifstream in(mission.file);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (auto written = WriteText(dir / "mission.toml", text); !written.ok()) return written;
  if (auto copied = CopyDataFiles(dir, mission); !copied.ok()) return copied;

  std::string run =
      fmt::format("shoal_version {}\narithmetic {}\nmission_file {}\nseed {}\n", kVersion,
                  ArithmeticId(), fs::absolute(mission.file).string(), mission.seed);
  for (const std::string& each : options.overrides) run += fmt::format("set {}\n", each);
  run += fmt::format("warp {}\n", options.warp > 0 ? fmt::format("{}", options.warp) : "max");
  return WriteText(dir / "run.txt", run);
}

Result<bool> WriteSummary(const std::string& dir, const std::string& summary) {
  return WriteText(fs::path(dir) / "summary.txt", summary);
}

Result<bool> WriteVerdict(const std::string& dir, const std::string& verdict) {
  return WriteText(fs::path(dir) / "verdict.txt", verdict);
}

}  // namespace shoal
