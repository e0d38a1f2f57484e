#include "lib/sea/media/relay_path.h"

#include <algorithm>

#include "lib/base/text/letters.h"

namespace shoal {

int NumHops(std::string_view via) {
  return via.empty() ? 0 : static_cast<int>(std::ranges::count(via, ':')) + 1;
}

bool IsVia(std::string_view via, std::string_view name) {
  while (!via.empty()) {
    const std::string_view hop = via.substr(0, via.find(':'));
    if (IsSameWord(hop, name)) return true;
    via.remove_prefix(std::min(hop.size() + 1, via.size()));
  }
  return false;
}

std::string WithHop(std::string_view via, std::string_view name) {
  std::string longer(via);
  if (!longer.empty()) longer += ':';
  longer += name;
  return longer;
}

}  // namespace shoal
