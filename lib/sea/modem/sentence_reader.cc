#include "lib/sea/modem/sentence_reader.h"

#include "lib/sea/modem/sentence_text.h"

namespace shoal {

std::string_view SentenceReader::Text(size_t field) {
  if (field <= sentence_.fields.size()) return sentence_.fields[field - 1];
  Reject(field, "there");
  return {};
}

int SentenceReader::Number(size_t field, int low, int high) {
  const auto number = ParseDigits(Text(field));
  if (number && *number >= low && *number <= high) return *number;
  const std::string least = std::to_string(low);
  Reject(field, low == high ? least : least + " to " + std::to_string(high));
  return low;
}

void SentenceReader::Reject(size_t field, std::string_view wanted) {
  if (!problem_.empty()) return;
  problem_ = "field " + std::to_string(field) + " must be " + std::string(wanted);
}

}  // namespace shoal
