#include "lib/bus/record/log_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "lib/base/schema/text.h"
#include "lib/base/time/seconds.h"

namespace shoal {

bool IsSelectionSound(const LogSelection& selection, std::ostream& err) {
  if (!selection.from_s || !selection.to_s || *selection.from_s <= *selection.to_s) return true;
  err << fmt::format("shoal: --from {} is after --to {}: nothing lies between\n", *selection.from_s,
                     *selection.to_s);
  return false;
}

std::optional<LogReader> OpenLog(const std::string& path, OnDamage on_damage, std::ostream& err) {
  Result<LogReader> reader = LogReader::Open(path, on_damage);
  if (reader.ok()) return std::move(*reader);
  err << reader.error() << '\n';
  return std::nullopt;
}

bool IsLogItself(const std::string& path, const std::string& out_path, std::ostream& err) {
  std::error_code ignored;
  if (!std::filesystem::equivalent(path, out_path, ignored)) return false;
  err << fmt::format("{} is the log itself; name another file\n", out_path);
  return true;
}

bool ReportDamage(const LogReader& reader, std::ostream& err) {
  constexpr size_t kMaxShown = 10;
  const auto& damages = reader.damages();
  for (size_t i = 0; i < std::min(kMaxShown, damages.size()); ++i) {
    err << fmt::format("{}: byte {}: {} ({} bytes skipped)\n", reader.path(), damages[i].begin,
                       damages[i].what, damages[i].end - damages[i].begin);
  }
  const auto num_more = reader.num_damages() - static_cast<int64_t>(kMaxShown);
  if (num_more > 0) err << fmt::format("{}: {} more damages\n", reader.path(), num_more);
  if (!reader.error().empty()) err << reader.error() << '\n';
  return reader.error().empty();
}

bool IsSelected(const LogSelection& selection, const LogEvent& event) {
  const double time_s = Seconds(event.utime);
  // Half a microsecond of tolerance: 12.3 is no whole number of microseconds in binary.
  constexpr double kTolerance_s = 0.5e-6;
  if (selection.from_s && time_s < *selection.from_s - kTolerance_s) return false;
  if (selection.to_s && time_s > *selection.to_s + kTolerance_s) return false;
  return TakesChannel(selection.channels, selection.without, event.channel);
}

bool ReportUnmatched(const LogReader& reader, const LogSelection& selection,
                     const std::set<std::string, std::less<>>& channels, std::ostream& err) {
  return ReportUnmatched(reader.path(), {.only = selection.channels, .without = selection.without},
                         channels, err);
}

bool ReportUnmatched(const std::string& path, const ChannelChoice& choice,
                     const std::set<std::string, std::less<>>& channels, std::ostream& err) {
  size_t num_unmatched = 0;
  std::vector<std::string> globs = choice.only;
  globs.insert(globs.end(), choice.without.begin(), choice.without.end());
  for (size_t i = 0; i < globs.size(); ++i) {
    const std::string& glob = globs[i];
    if (std::any_of(channels.begin(), channels.end(),
                    [&](const std::string& channel) { return Matches(glob, channel); })) {
      continue;
    }
    if (i < choice.only.size()) ++num_unmatched;
    std::string names;
    for (const std::string& channel : channels) {
      if (!names.empty()) names += ", ";
      AppendQuoted(channel, &names);
    }
    err << fmt::format("{}: no channel matches '{}'; there are: {}\n", path, glob,
                       names.empty() ? "none" : names);
  }
  return num_unmatched == 0 || num_unmatched < choice.only.size();
}

}  // namespace shoal
