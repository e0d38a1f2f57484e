// The page that shows a person what an app does: MOOS users know it as an appcast.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

struct StatusPage {
  std::vector<std::string> config_warnings;
  std::vector<std::string> run_warnings;
  std::string text;  ///< Configuration, counters, recent events; lines end in '\n'.
};

/// Returns the page as a terminal shows it: title line with counts of warnings and the step
/// ("helm_alpha   0/1(1822)"), warnings first, then the text.
std::string Format(const StatusPage& page, std::string_view app, int64_t step);

/// Returns what a terminal can show of a text from outside: at most `max_characters`, the last of
/// them "..." where there are more; '?' for what is not printable ASCII.
std::string Printable(std::string_view text, size_t max_characters = 40);

/// For whole sentences about a text from outside, such as the reason of a refusal.
inline constexpr size_t kLongestSentence = 400;

/// Keeps an app's warnings (equal ones counted, not repeated) and its most recent events.
class StatusLog {
 public:
  /// Notes that something is wrong while running. Equal texts are shown once, with a count.
  void Warn(std::string_view text);
  /// Notes a warning about the configuration.
  void WarnConfig(std::string_view text);
  /// Takes back a run warning whose cause has gone.
  void Retract(std::string_view text);
  /// Notes an event; the last 10 are shown.
  void Event(int64_t utime, std::string_view text);

  /// Fills warnings, and appends the recent events to `page->text`.
  void AppendTo(StatusPage* page) const;

 private:
  std::map<std::string, int64_t, std::less<>> warnings_;
  std::vector<std::string> config_warnings_;
  std::deque<std::string> events_;  ///< Newest first.
  int64_t num_events_ = 0;
};

}  // namespace shoal
