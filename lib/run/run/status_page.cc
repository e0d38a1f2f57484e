#include "lib/run/run/status_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/base/time/seconds.h"

namespace shoal {

namespace {
constexpr size_t kMaxEvents = 10;
constexpr size_t kMaxWarnings = 100;  ///< Different texts; a peer may provoke warnings without end.
}  // namespace

std::string Format(const StatusPage& page, std::string_view app, int64_t step) {
  const std::string rule(64, '=');
  std::string out = fmt::format(
      "{}\n{:<44}{:>20}\n{}\n", rule, app,
      fmt::format("{}/{}({})", page.config_warnings.size(), page.run_warnings.size(), step), rule);
  if (!page.config_warnings.empty()) {
    out += fmt::format("Configuration warnings: {}\n", page.config_warnings.size());
    for (const std::string& warning : page.config_warnings) out += "    " + warning + "\n";
    out += "\n";
  }
  if (!page.run_warnings.empty()) {
    out += fmt::format("Run warnings: {}\n", page.run_warnings.size());
    for (const std::string& warning : page.run_warnings) out += "    " + warning + "\n";
    out += "\n";
  }
  return out + page.text;
}

std::string Printable(std::string_view text, size_t max_characters) {
  constexpr std::string_view kCut = "...";
  std::string shown(text.substr(0, max_characters));
  if (text.size() > max_characters && max_characters >= kCut.size()) {
    shown.replace(shown.size() - kCut.size(), kCut.size(), kCut);
  }
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return shown;
}

void StatusLog::Warn(std::string_view text) {
  const auto found = warnings_.find(text);
  if (found != warnings_.end()) {
    ++found->second;
  } else {
    const std::string_view key = warnings_.size() < kMaxWarnings ? text : "(further warnings)";
    ++warnings_[std::string(key)];
  }
}

void StatusLog::WarnConfig(std::string_view text) { config_warnings_.emplace_back(text); }

void StatusLog::Retract(std::string_view text) {
  const auto found = warnings_.find(text);
  if (found != warnings_.end()) warnings_.erase(found);
}

void StatusLog::Event(int64_t utime, std::string_view text) {
  ++num_events_;
  events_.push_front(fmt::format("[{:.2f}]: {}", Seconds(utime), text));
  if (events_.size() > kMaxEvents) events_.pop_back();
}

void StatusLog::AppendTo(StatusPage* page) const {
  page->config_warnings.insert(page->config_warnings.end(), config_warnings_.begin(),
                               config_warnings_.end());
  for (const auto& [text, count] : warnings_) {
    page->run_warnings.push_back(count == 1 ? text : fmt::format("{} ({} times)", text, count));
  }
  page->text += fmt::format("\nMost recent events ({}):\n", num_events_);
  for (const std::string& event : events_) page->text += "    " + event + "\n";
}

}  // namespace shoal
