#include "lib/tools/rebroker/rebroker_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/time/seconds.h"
#include "lib/mission/file/load_comms.h"
#include "lib/mission/file/load_media.h"

namespace shoal {

namespace {

constexpr size_t kMaxVehiclesNamed = 10;

std::string SecondsText(int64_t utime) { return fmt::format("{:.3f} s", Seconds(utime)); }

std::string_view TimeText(LogTime time) {
  switch (time) {
    case LogTime::kMission:
      return "mission time";
    case LogTime::kSeals:
      return "lcm-logger's, steps and order restored from the seals";
    case LogTime::kWall:
      return "lcm-logger's of a live broker";
  }
  return "";
}

std::string MissingText(const std::vector<ReportGap>& gaps) {
  int64_t num_missing = 0;
  std::string vehicles;
  for (size_t i = 0; i < gaps.size(); ++i) {
    num_missing = std::min(num_missing, INT64_MAX / 2) + gaps[i].num_missing;
    if (i >= kMaxVehiclesNamed) continue;
    vehicles += fmt::format("{}{} {} of {}", i == 0 ? "" : ", ", gaps[i].vehicle,
                            gaps[i].num_missing, gaps[i].num_found + gaps[i].num_missing);
  }
  if (gaps.size() > kMaxVehiclesNamed) vehicles += ", ...";
  return fmt::format(
      "{} node reports seem to be missing, by the vehicles' own count ({}); lcm-logger loses "
      "bursts, `shoal run --record` does not. What hangs on each report's number "
      "(drop_percentage) is not reproduced",
      num_missing, vehicles);
}

std::map<std::string, LinkFactors> FactorsOf(const BrokerSetup& setup) {
  return {setup.factors.begin(), setup.factors.end()};
}

}  // namespace

std::string LogText(const std::vector<std::string>& paths, const CommsLog& log,
                    const std::optional<BrokerSetup>& recorded) {
  std::string text =
      fmt::format("Log:      {}, {} to {}, {}\n", fmt::join(paths, ", "),
                  SecondsText(log.first_utime), SecondsText(log.last_utime), TimeText(log.time));
  std::map<std::string, int64_t> counts;
  for (const LoggedMessage& input : log.inputs) ++counts[BrokerChannels()[input.channel]];
  std::vector<std::string> words;
  words.reserve(counts.size());
  for (const auto& [channel, count] : counts) {
    words.push_back(fmt::format("{} {}", count, channel));
  }
  text += fmt::format("Received: {}\n", fmt::join(words, ", "));
  if (recorded) {
    text += fmt::format("Mission:  {} vehicles, seed {}, tick {} s\n", recorded->vehicles.size(),
                        recorded->seed, Seconds(log.tick_us));
  }
  for (size_t i = 1; i < log.starts.size(); ++i) {
    text += fmt::format("Restart:  the broker was started again at {} and knew no vehicle\n",
                        SecondsText(log.starts[i].utime));
  }
  return text;
}

std::vector<std::string> WarningsOf(const CommsLog& log) {
  std::vector<std::string> warnings;
  if (!log.gaps.empty()) warnings.push_back(MissingText(log.gaps));
  const std::pair<int64_t, std::string_view> counts[] = {
      {log.time == LogTime::kMission ? log.num_backward : 0,
       "events are earlier than the one before; sorted by time"},
      {log.num_repeated, "messages are there twice; each is taken once"},
      {log.num_foreign, "messages of another mission left out"},
      {log.num_impossible, "events with a time that no mission has left out"},
      {log.num_unsealed,
       "messages from outside have no seal: their step is that of the message before"}};
  for (const auto& [count, what] : counts) {
    if (count > 0) warnings.push_back(fmt::format("{} {}", count, what));
  }
  if (log.tick_is_guessed) {
    warnings.push_back(
        fmt::format("the log does not contain the tick; {} s is a guess", Seconds(log.tick_us)));
  }
  if (log.rules && !log.rules->is_start) {
    warnings.push_back(
        fmt::format("the log does not hold the broker's start: its rules are those of {}",
                    SecondsText(log.rules->utime)));
  }
  if (log.rules) {
    for (std::string& line : StrangeRules(*log.rules)) warnings.push_back(std::move(line));
  }
  return warnings;
}

std::string ReproducedText(const CommsLog& log, const RebrokerOutcome& outcome) {
  if (log.fates.empty()) {
    return "Recorded: no decisions (COMMS_FATES), so there is nothing to compare with\n";
  }
  const DecisionComparison& comparison = outcome.comparison;
  std::string text = fmt::format("Recorded: reproduced {} of {} decisions\n",
                                 comparison.num_reproduced(), comparison.num_recorded());
  if (comparison.num_now() > comparison.num_recorded()) {
    text += fmt::format("          {} decisions more than the log holds\n",
                        comparison.num_now() - comparison.num_recorded());
  }
  if (!comparison.IsEqual()) {
    text += "          The first difference:\n" + comparison.first_difference();
  }
  if (outcome.num_undecodable > 0) {
    text += fmt::format("          {} COMMS_FATES do not decode\n", outcome.num_undecodable);
  }
  return text;
}

std::string ChangesText(const BrokerSetup& then, const BrokerSetup& now) {
  std::string text;
  const std::vector<std::string> old_lines = ExplainComms(then.rules);
  const std::vector<std::string> new_lines = ExplainComms(now.rules);
  for (size_t i = 0; i < std::min(old_lines.size(), new_lines.size()); ++i) {
    if (old_lines[i] == new_lines[i]) continue;
    text += fmt::format("          {} (was {})\n", new_lines[i],
                        old_lines[i].substr(old_lines[i].find('=') + 2));
  }
  std::istringstream was(ExplainMedia(then.media));
  std::istringstream is(ExplainMedia(now.media));
  std::set<std::string> old_acoustics;
  for (std::string line; std::getline(was, line);) old_acoustics.insert(line);
  for (std::string line; std::getline(is, line);) {
    if (!old_acoustics.contains(line)) text += fmt::format("          [acoustics] {}\n", line);
  }
  std::map<std::string, LinkFactors> before = FactorsOf(then);
  std::map<std::string, LinkFactors> after = FactorsOf(now);
  for (const auto& [name, factors] : before) after.emplace(name, LinkFactors());
  for (const auto& [name, factors] : after) {
    const LinkFactors& old = before[name];
    if (factors == old) continue;
    text += fmt::format("          {}: stealth = {} (was {}), earange = {} (was {})\n", name,
                        factors.stealth, old.stealth, factors.earange, old.earange);
  }
  return text.empty() ? "          the same as recorded\n" : text;
}

std::string AbsencesText(const CommsLog& log, const RebrokerOutcome& outcome) {
  std::string text;
  for (const BrokerAbsence& absence : outcome.absences) {
    text += fmt::format(
        "Away:     while the broker was away{}, after {} until {}: {} decisions more, not counted "
        "below\n",
        log.time == LogTime::kMission ? "" : " (or its decisions were lost)",
        SecondsText(absence.after_utime),
        absence.to_the_end ? "the end of the log" : SecondsText(absence.before_utime),
        absence.num_decisions);
  }
  if (outcome.num_too_early > 0) {
    text += fmt::format("Early:    {} messages were published before the broker began\n",
                        outcome.num_too_early);
  }
  return text;
}

}  // namespace shoal
