#include "lib/mission/file/background_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "lib/base/text/letters.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

struct BackgroundEnding {
  std::string_view ending;
  std::string_view world;  ///< Empty: it states itself where it lies.
};

constexpr std::array<BackgroundEnding, 9> kBackgroundEndings = {{{".geojson", ""},
                                                                 {".json", ""},
                                                                 {".tif", ""},
                                                                 {".tiff", ""},
                                                                 {".png", ".pgw"},
                                                                 {".jpg", ".jgw"},
                                                                 {".jpeg", ".jgw"},
                                                                 {".webp", ".wpw"},
                                                                 {".mbtiles", ""}}};

const BackgroundEnding* EndingOf(std::string_view file) {
  std::string lower;
  for (const char letter : file) lower += LowerCase(letter);
  const auto found =
      std::find_if(kBackgroundEndings.begin(), kBackgroundEndings.end(),
                   [&](const BackgroundEnding& each) { return lower.ends_with(each.ending); });
  return found == kBackgroundEndings.end() ? nullptr : &*found;
}

}  // namespace

BackgroundKind KindOfBackground(std::string_view file) {
  if (file.ends_with('/')) return BackgroundKind::kFolder;
  const BackgroundEnding* ending = EndingOf(file);
  const bool is_tiles = ending != nullptr && ending->ending == ".mbtiles";
  return is_tiles ? BackgroundKind::kTiles : BackgroundKind::kFile;
}

std::string BackgroundProblem(std::string_view file) {
  const fs::path path(file);
  const bool leads_out =
      path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
  if (file.empty() || leads_out) {
    return "a background lies in the mission's folder, as \"charts/coast.geojson\": a viewer shows "
           "it to all that reach its page";
  }
  if (EndingOf(file) == nullptr && KindOfBackground(file) != BackgroundKind::kFolder) {
    return "a background ends in .geojson, .json, .tif, .tiff, .png, .jpg, .jpeg, .webp or "
           ".mbtiles; a folder of tiles ends in /";
  }
  return "";
}

std::string WorldFileOf(std::string_view file) {
  const BackgroundEnding* ending = EndingOf(file);
  if (ending == nullptr || ending->world.empty()) return "";
  return std::string(file.substr(0, file.size() - ending->ending.size())).append(ending->world);
}

BackgroundFolder BackgroundsOf(const Mission& mission) {
  const fs::path folder = fs::path(mission.file).parent_path();
  return {.folder = folder.empty() ? "." : folder.string(), .files = mission.backgrounds};
}

namespace {

/// Returns the path of `file`, of a background, inside `folder`.
Result<std::string> Located(const std::string& folder, const std::string& background,
                            const std::string& file) {
  if (const std::string problem = BackgroundProblem(background); !problem.empty()) {
    return Error{fmt::format("the background {}: {}", background, problem)};
  }
  std::error_code error;
  const fs::path inside = fs::canonical(folder, error);
  if (error) return Error{fmt::format("the folder {}: {}", folder, error.message())};
  const fs::path path = fs::canonical(fs::path(folder) / file, error);
  if (error) {
    return Error{
        fmt::format("the background {}: there is no {} in {}: put it there, or leave it "
                    "out of backgrounds",
                    background, file, folder)};
  }
  if (std::mismatch(inside.begin(), inside.end(), path.begin(), path.end()).first != inside.end()) {
    return Error{fmt::format("the background {}: a link leads out of {}: put the file itself there",
                             background, folder)};
  }
  return path.string();
}

}  // namespace

Result<std::string> BackgroundFolder::Find(size_t number, const std::string& below) const {
  if (number >= files.size()) {
    return Error{
        fmt::format("there is no background {}: the mission has {}", number, files.size())};
  }
  return Located(folder, files[number], files[number] + below);
}

Result<std::string> BackgroundFolder::Read(size_t number, bool world) const {
  const std::string file = number < files.size() && world ? WorldFileOf(files[number]) : "";
  if (number < files.size() && world && file.empty()) {
    return Error{fmt::format("the background {} has no world file: it states itself where it lies",
                             files[number])};
  }
  const Result<std::string> path =
      world && !file.empty() ? Located(folder, files[number], file) : Find(number);
  if (!path.ok()) return path;
  std::error_code error;
  if (!fs::is_regular_file(*path, error)) {
    return Error{fmt::format("the background {} is not a file", files[number])};
  }
  const auto size = fs::file_size(*path, error);
  if (error || size > kMaxBytes) {
    return Error{fmt::format("the background {} is larger than {} MB: make it smaller",
                             files[number], kMaxBytes / 1'000'000)};
  }
  std::ifstream in(*path, std::ios::binary);
  std::string bytes(size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in) {
    return Error{
        fmt::format("the background {} cannot be read: may you read {}?", files[number], *path)};
  }
  return bytes;
}

bool BackgroundFolder::HasWorld(size_t number) const {
  const std::string world = number < files.size() ? WorldFileOf(files[number]) : "";
  std::error_code error;
  return !world.empty() && fs::is_regular_file(fs::path(folder) / world, error);
}

std::vector<std::string> BackgroundFilesThere(const Mission& mission) {
  const fs::path folder = fs::path(mission.file).parent_path();
  std::vector<std::string> there;
  for (const std::string& file : mission.backgrounds) {
    for (const std::string& each : {file, WorldFileOf(file)}) {
      std::error_code error;
      if (each.empty() || !fs::is_regular_file(folder / each, error)) continue;
      if (fs::file_size(folder / each, error) <= BackgroundFolder::kMaxBytes) there.push_back(each);
    }
  }
  std::sort(there.begin(), there.end());
  there.erase(std::unique(there.begin(), there.end()), there.end());
  return there;
}

std::vector<std::string> MissingBackgrounds(const Mission& mission) {
  const BackgroundFolder backgrounds = BackgroundsOf(mission);
  std::vector<std::string> missing;
  for (size_t i = 0; i < backgrounds.files.size(); ++i) {
    const BackgroundKind kind = KindOfBackground(backgrounds.files[i]);
    const Result<std::string> path = backgrounds.Find(i);
    std::error_code error;
    if (!path.ok()) {
      missing.push_back(path.error());
    } else if (kind == BackgroundKind::kFolder && !fs::is_directory(*path, error)) {
      missing.push_back(fmt::format("the background {} is not a folder: leave out the / at its end",
                                    backgrounds.files[i]));
    } else if (kind != BackgroundKind::kFolder && !fs::is_regular_file(*path, error)) {
      missing.push_back(fmt::format("the background {} is a folder: a folder of tiles ends in /",
                                    backgrounds.files[i]));
    } else if (kind == BackgroundKind::kFile &&
               fs::file_size(*path, error) > BackgroundFolder::kMaxBytes) {
      missing.push_back(fmt::format("the background {} is larger than {} MB: make it smaller",
                                    backgrounds.files[i], BackgroundFolder::kMaxBytes / 1'000'000));
    }
  }
  return missing;
}

}  // namespace shoal
