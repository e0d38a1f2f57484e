#include "lib/comms/routing/rules.h"

namespace shoal {

MediaChoice Over(std::string_view text) {
  MediaChoice choice = {.names = {}, .at_once = text.find('+') != text.npos};
  const char between = choice.at_once ? '+' : ',';
  while (true) {
    const size_t end = text.find(between);
    choice.names.emplace_back(text.substr(0, end));
    if (end == text.npos) return choice;
    text.remove_prefix(end + 1);
  }
}

std::string TextOf(const MediaChoice& choice) {
  std::string text;
  for (const std::string& name : choice.names) {
    if (!text.empty()) text += choice.at_once ? '+' : ',';
    text += name;
  }
  return text;
}

}  // namespace shoal
