#include "lib/mission/toml/problems.h"

#include <fmt/format.h>

#include <string_view>

#include "lib/base/text/terminal_text.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr size_t kMaxShown = 100;

/// Returns `text` for a line of a terminal: without control characters, at most 200 bytes.
std::string OneLine(std::string_view text) {
  constexpr size_t kLongest = 200;
  return TerminalLine(text.substr(0, kLongest));
}

}  // namespace

Problems::Problems(std::string file, std::vector<std::string> overrides)
    : file_(std::move(file)), overrides_(std::move(overrides)) {}

void Problems::Add(const Place& place, std::string text) {
  problems_.emplace(place, std::move(text));
}

void Problems::Warn(const Place& place, std::string text) {
  warnings_.emplace(place, std::move(text));
}

void Problems::WarnOfFailure(const Place& place, std::string text) {
  if (warnings_.emplace(place, std::move(text)).second) ++num_failures_;
}

std::string Problems::WhereIs(const Place& place) const {
  if (place.override_number > 0) {
    return "--set " + OneLine(overrides_.at(static_cast<size_t>(place.override_number - 1)));
  }
  if (place.line == 0) return OneLine(file_);
  return fmt::format("{}:{}:{}", OneLine(file_), place.line, place.column);
}

std::string Problems::LineOf(const Place& place) const {
  if (place.override_number > 0) return WhereIs(place);
  return fmt::format("{}:{}", OneLine(file_), place.line);
}

std::vector<std::string> Problems::Lines(const Notes& notes, std::string_view prefix,
                                         std::string_view noun) const {
  std::vector<std::string> messages;
  for (const auto& [place, text] : notes) {
    if (messages.size() == kMaxShown) {
      messages.push_back(
          fmt::format("{}: and {} more {}", OneLine(file_), notes.size() - kMaxShown, noun));
      break;
    }
    messages.push_back(fmt::format("{}: {}{}", WhereIs(place), prefix, text));
  }
  return messages;
}

std::vector<std::string> Problems::InOrder() const { return Lines(problems_, "", "errors"); }

std::vector<std::string> Problems::WarningsInOrder() const {
  return Lines(warnings_, "warning: ", "warnings");
}

}  // namespace shoal
