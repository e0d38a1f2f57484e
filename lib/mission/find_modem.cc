#include "lib/mission/find_modem.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "lib/mission/load_modem.h"
#include "lib/mission/suggest.h"

namespace shoal {
namespace {

namespace fs = std::filesystem;

/// The modems that come with shoal.
const char* const kModemFolder = SHOAL_DATA_DIR "/modems";

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Returns where the modem's file is, empty where there is none.
fs::path PathOf(std::string_view name, const fs::path& folder) {
  if (name.empty()) return {};
  const fs::path file(name);
  std::vector<fs::path> candidates = {folder / file, folder / (file.string() + ".toml")};
  if (!file.has_parent_path()) {
    candidates.push_back(kModemFolder / fs::path(file.string() + ".toml"));
    candidates.push_back(kModemFolder / file);
  }
  const auto found = std::find_if(candidates.begin(), candidates.end(), IsFile);
  return found == candidates.end() ? fs::path() : *found;
}

/// Returns the names of the modems that come with shoal, in alphabetical order.
std::vector<std::string> KnownModems() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(kModemFolder, ignored)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

NamedModem FindModem(std::string_view name, const std::string& folder) {
  const fs::path path = PathOf(name, folder);
  if (!path.empty()) {
    LoadedModem loaded = LoadModem(path.string());
    const std::string where = "modem " + Quoted(name) + ": ";
    for (std::string& error : loaded.errors) error.insert(0, where);
    return {.modem = std::move(loaded.modem), .problems = std::move(loaded.errors)};
  }
  const std::vector<std::string> known = KnownModems();
  const std::vector<std::string_view> words(known.begin(), known.end());
  return {.modem = {},
          .problems = {"unknown modem " + Quoted(name) + DidYouMean(name, words) + "; shoal has " +
                       Joined(words) +
                       "; any other needs a file, named relative to the folder of this one"}};
}

}  // namespace shoal
