#include "lib/launch/recording.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "lib/record/text_file.h"
#include "lib/run/version.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

Result<bool> WriteText(const fs::path& path, const std::string& text) {
  if (TextFile(path.string(), text).Flush()) return true;
  return Error{
      fmt::format("cannot write {}: is the disk full, or the folder not yours?", path.string())};
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

  std::string run = fmt::format("shoal_version {}\nmission_file {}\nseed {}\n", kVersion,
                                fs::absolute(mission.file).string(), mission.seed);
  for (const std::string& each : options.overrides) run += fmt::format("set {}\n", each);
  run += fmt::format("warp {}\n", options.warp > 0 ? fmt::format("{}", options.warp) : "max");
  return WriteText(dir / "run.txt", run);
}

Result<bool> WriteSummary(const std::string& dir, const std::string& summary) {
  return WriteText(fs::path(dir) / "summary.txt", summary);
}

}  // namespace shoal
