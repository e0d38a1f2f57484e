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

constexpr std::array<BackgroundEnding, 8> kBackgroundEndings = {{{".geojson", ""},
                                                                 {".json", ""},
                                                                 {".tif", ""},
                                                                 {".tiff", ""},
                                                                 {".png", ".pgw"},
                                                                 {".jpg", ".jgw"},
                                                                 {".jpeg", ".jgw"},
                                                                 {".webp", ".wpw"}}};

const BackgroundEnding* EndingOf(std::string_view file) {
  std::string lower;
  for (const char letter : file) lower += LowerCase(letter);
  const auto found =
      std::find_if(kBackgroundEndings.begin(), kBackgroundEndings.end(),
                   [&](const BackgroundEnding& each) { return lower.ends_with(each.ending); });
  return found == kBackgroundEndings.end() ? nullptr : &*found;
}

}  // namespace

std::string BackgroundProblem(std::string_view file) {
  const fs::path path(file);
  const bool leads_out =
      path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
  if (file.empty() || leads_out) {
    return "a background lies in the mission's folder, as \"charts/coast.geojson\": a viewer shows "
           "it to all that reach its page";
  }
  if (EndingOf(file) == nullptr) {
    return "a background ends in .geojson, .json, .tif, .tiff, .png, .jpg, .jpeg or .webp";
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

Result<std::string> BackgroundFolder::Read(size_t number, bool world) const {
  if (number >= files.size()) {
    return Error{
        fmt::format("there is no background {}: the mission has {}", number, files.size())};
  }
  const std::string file = world ? WorldFileOf(files[number]) : files[number];
  const Error missing{fmt::format("the background {} cannot be read", files[number])};
  if (file.empty() || !BackgroundProblem(files[number]).empty()) return missing;
  std::error_code error;
  const fs::path inside = fs::canonical(folder, error);
  if (error) return missing;
  const fs::path path = fs::canonical(fs::path(folder) / file, error);
  if (error || !fs::is_regular_file(path, error)) return missing;
  const auto [end, at] = std::mismatch(inside.begin(), inside.end(), path.begin(), path.end());
  if (end != inside.end()) return missing;
  const auto size = fs::file_size(path, error);
  if (error || size > kMaxBytes) {
    return Error{fmt::format("the background {} is larger than {} MB", files[number],
                             kMaxBytes / 1'000'000)};
  }
  std::ifstream in(path, std::ios::binary);
  std::string bytes(size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(std::max<std::streamsize>(in.gcount(), 0)));
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
      if (!each.empty() && fs::is_regular_file(folder / each, error)) there.push_back(each);
    }
  }
  std::sort(there.begin(), there.end());
  there.erase(std::unique(there.begin(), there.end()), there.end());
  return there;
}

}  // namespace shoal
