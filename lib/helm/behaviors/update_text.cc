#include "lib/helm/behaviors/update_text.h"

#include "lib/base/text/blanks.h"
#include "lib/helm/modes/value_text.h"

namespace shoal {
namespace {

/// Returns the place of the next # outside quotes, or the end.
size_t EndOfItem(std::string_view text) {
  bool in_quotes = false;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') in_quotes = !in_quotes;
    if (text[i] == '#' && !in_quotes) return i;
  }
  return text.size();
}

}  // namespace

Result<std::vector<UpdateItem>> ParseUpdate(std::string_view text) {
  std::vector<UpdateItem> items;
  while (true) {
    const size_t end = EndOfItem(text);
    const std::string_view part = Trimmed(text.substr(0, end));
    const size_t sign = part.find('=');
    if (sign == std::string_view::npos || Trimmed(part.substr(0, sign)).empty()) {
      return Error{"'" + std::string(part) + "': write key = value, and # between several"};
    }
    items.push_back(
        {std::string(Trimmed(part.substr(0, sign))), std::string(Trimmed(part.substr(sign + 1)))});
    if (end == text.size()) return items;
    text.remove_prefix(end + 1);
  }
}

}  // namespace shoal
