// Any bytes as files of MOOS-IvP: what is imported is a mission that loads, in bounded time.
//
// An input is files, separated by a byte 0: a vehicle's .moos, its .bhv, a file that both include
// as "plug".
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/check.h"
#include "lib/mission/file/load.h"
#include "lib/tools/moos/import.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> texts;
  while (texts.size() < 3) {
    const size_t end = std::min(bytes.find('\0'), bytes.size());
    texts.emplace_back(bytes.substr(0, end));
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  const shoal::MoosSource sources[] = {{.name = "a.moos", .text = texts[0]},
                                       {.name = "a.bhv", .text = texts[1]}};
  const auto find = [&](std::string_view name,
                        std::string_view) -> std::optional<shoal::MoosSource> {
    if (name != "plug") return std::nullopt;
    return shoal::MoosSource{.name = "plug", .text = texts[2]};
  };
  const shoal::MoosImport import =
      shoal::ImportMoos(sources, {.defines = {{"V", texts[2]}}, .vehicles = {}, .find = find});
  const shoal::LoadedMission loaded = shoal::LoadMissionText(import.mission, "m");
  SHOAL_CHECK(loaded.errors.empty(), "an imported mission loads");
  return 0;
}
