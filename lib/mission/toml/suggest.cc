#include "lib/mission/toml/suggest.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/base/text/terminal_text.h"

namespace shoal {
namespace {

constexpr size_t kLongestWord = 64;    // No key and no name of ours is longer.
constexpr size_t kLongestQuoted = 60;  // Bytes; a line of a terminal holds it with its context.

/// Returns the distance to that run of the candidate's words ("a_b_c" has six) that is nearest.
int DistanceToAnyPart(std::string_view word, std::string_view candidate) {
  int nearest = EditDistance(word, candidate);
  for (size_t begin = 0;;) {
    for (size_t end = candidate.find('_', begin); end != std::string_view::npos;
         end = candidate.find('_', end + 1)) {
      nearest = std::min(nearest, EditDistance(word, candidate.substr(begin, end - begin)));
    }
    if (begin > 0) nearest = std::min(nearest, EditDistance(word, candidate.substr(begin)));
    begin = candidate.find('_', begin);
    if (begin == std::string_view::npos) return nearest;
    ++begin;
  }
}

}  // namespace

int EditDistance(std::string_view a, std::string_view b) {
  std::vector<int> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string_view Suggest(std::string_view word, std::span<const std::string_view> candidates) {
  if (word.empty() || word.size() > kLongestWord) return {};
  const std::string lower = LowerCase(word);
  // A third of the letters wrong is a typing error, more is another word.
  const int limit = word.size() == 1 ? 0 : static_cast<int>(word.size() + 2) / 3;
  std::string_view best;
  std::tuple<int, int> best_distance = {limit + 1, 0};
  for (const std::string_view candidate : candidates) {
    if (candidate.size() > kLongestWord) continue;
    const std::string lower_candidate = LowerCase(candidate);
    const std::tuple<int, int> distance = {DistanceToAnyPart(lower, lower_candidate),
                                           EditDistance(lower, lower_candidate)};
    if (std::get<0>(distance) > limit) continue;
    if (best.empty() || distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string DidYouMean(std::string_view word, std::span<const std::string_view> candidates) {
  const std::string_view suggestion = Suggest(word, candidates);
  if (suggestion.empty()) return "";
  return " (did you mean '" + std::string(suggestion) + "'?)";
}

std::string Quoted(std::string_view text) {
  size_t length = std::min(kLongestQuoted, text.size());
  const auto continues = [&](size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
  };
  while (length < text.size() && length < kLongestQuoted + 3 && continues(length)) ++length;
  return "'" + TerminalLine(text.substr(0, length)) + (length < text.size() ? "...'" : "'");
}

std::string Joined(std::span<const std::string_view> words) {
  std::string joined;
  for (const std::string_view word : words) {
    if (!joined.empty()) joined += ", ";
    joined += word;
  }
  return joined;
}

}  // namespace shoal
