#include "lib/mission/file/find_modem.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "lib/bus/os/files_below.h"
#include "lib/mission/file/load_modem.h"
#include "lib/mission/file/own_modems.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

namespace fs = std::filesystem;

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  // A file that must not be read is not looked for: the answer would reveal if it exists.
  return MayReadFile(path.string()) && fs::is_regular_file(path, ignored);
}

/// Returns where the modem's file is, empty where there is none.
fs::path PathOf(std::string_view name, const fs::path& folder) {
  if (name.empty()) return {};
  for (const fs::path& path :
       {folder / fs::path(name), folder / fs::path(std::string(name) + ".toml")}) {
    if (IsFile(path)) return path;
  }
  return {};
}

/// Returns the modem of that name, with or without .toml, that comes with shoal, or nullptr.
const OwnModem* FindOwn(std::string_view name) {
  if (name.ends_with(".toml")) name.remove_suffix(5);
  const auto own = OwnModems();
  const auto found = std::find_if(own.begin(), own.end(),
                                  [&](const OwnModem& modem) { return modem.name == name; });
  return found == own.end() ? nullptr : &*found;
}

NamedModem Named(std::string_view name, LoadedModem loaded) {
  const std::string where = "modem " + Quoted(name) + ": ";
  for (std::string& error : loaded.errors) error.insert(0, where);
  return {.modem = std::move(loaded.modem), .problems = std::move(loaded.errors)};
}

}  // namespace

NamedModem FindModem(std::string_view name, const std::string& folder) {
  const fs::path path = PathOf(name, folder);
  if (!path.empty()) return Named(name, LoadModem(path.string()));
  if (const OwnModem* own = FindOwn(name)) {
    return Named(name, LoadModemText(own->text, "data/modems/" + std::string(own->name) + ".toml"));
  }
  std::vector<std::string_view> words;
  for (const OwnModem& own : OwnModems()) words.push_back(own.name);
  return {.modem = {},
          .problems = {"unknown modem " + Quoted(name) + DidYouMean(name, words) + "; shoal has " +
                       Joined(words) +
                       "; any other needs a file, named relative to the folder of this one"}};
}

}  // namespace shoal
