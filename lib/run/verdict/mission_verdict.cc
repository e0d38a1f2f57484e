#include "lib/run/verdict/mission_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "lib/run/verdict/summary.h"

namespace shoal {

namespace {

constexpr size_t kMaxWord = 2000;  ///< Bytes of a text.

std::string NumberWord(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? fmt::format("{:.10g}", *number) : "";
}

std::optional<double> NumberIn(std::string_view word) {
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) {
    return std::nullopt;
  }
  return number;
}

/// A tab or a line's end would begin another word.
std::string OneWord(std::string_view text) {
  std::string word(text.substr(0, kMaxWord));
  for (char& letter : word) {
    if (static_cast<unsigned char>(letter) < 0x20) letter = ' ';
  }
  return word;
}

std::vector<std::string_view> WordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    const size_t tab = line.find('\t');
    words.push_back(line.substr(0, std::min(tab, kMaxWord)));
    if (tab == std::string_view::npos) return words;
    line.remove_prefix(tab + 1);
  }
}

void TakeLine(std::string_view line, MissionVerdict* verdict) {
  const std::vector<std::string_view> words = WordsOf(line);
  if (words.size() == 2 && words[0] == "result") {
    verdict->result = words[1];
  } else if (words.size() == 2 && words[0] == "why") {
    verdict->why = words[1];
  } else if (words.size() == 2 && words[0] == "end_s") {
    verdict->end_s = NumberIn(words[1]).value_or(0);
  } else if (words.size() == 8 && words[0] == "expectation" &&
             verdict->lines.size() < MissionVerdict::kMaxLines) {
    verdict->lines.push_back({.passed = words[1] == "pass",
                              .value = NumberIn(words[2]),
                              .unit = std::string(words[3]),
                              .margin = NumberIn(words[4]),
                              .where = std::string(words[5]),
                              .text = std::string(words[6]),
                              .numbers = std::string(words[7])});
  }
}

}  // namespace

MissionVerdict VerdictOf(const Mission& mission, const Judge& judge, double end_s, bool complete) {
  MissionVerdict verdict{.result = "INCOMPLETE", .end_s = end_s};
  if (complete) {
    verdict.why = FailuresOf(mission, judge);
    verdict.result = verdict.why.empty() ? "PASS" : "FAIL";
  }
  for (ExpectationVerdict& each : judge.Verdicts()) {
    if (verdict.lines.size() == MissionVerdict::kMaxLines) break;
    verdict.lines.push_back({.passed = each.passed,
                             .value = each.value,
                             .unit = std::string(each.unit),
                             .margin = each.margin,
                             .where = std::move(each.where),
                             .text = std::move(each.text),
                             .numbers = std::move(each.numbers)});
  }
  return verdict;
}

std::string TextOf(const MissionVerdict& verdict) {
  std::string text = fmt::format("result\t{}\nwhy\t{}\nend_s\t{}\n", OneWord(verdict.result),
                                 OneWord(verdict.why), NumberWord(verdict.end_s));
  for (const VerdictLine& line : verdict.lines) {
    text += fmt::format("expectation\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", line.passed ? "pass" : "FAIL",
                        NumberWord(line.value), OneWord(line.unit), NumberWord(line.margin),
                        OneWord(line.where), OneWord(line.text), OneWord(line.numbers));
  }
  return text;
}

std::optional<MissionVerdict> ReadVerdict(std::string_view text) {
  MissionVerdict verdict;
  while (!text.empty()) {
    const size_t end = text.find('\n');
    TakeLine(text.substr(0, end), &verdict);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  constexpr std::array<std::string_view, 3> kResults = {"PASS", "FAIL", "INCOMPLETE"};
  const bool is_known =
      std::find(kResults.begin(), kResults.end(), verdict.result) != kResults.end();
  if (!is_known) return std::nullopt;
  return verdict;
}

}  // namespace shoal
